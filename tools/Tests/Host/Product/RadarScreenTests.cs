using System;
using Glint.Core;
using Glint.Tests;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Host.Tests.Product;

public sealed class RadarScreenTests
{
    // The first frames make buffers and compile methods; then a frame is free of garbage.
    [TestCase(false)]
    [TestCase(true)]
    public void Frame_AllocatesNothing(bool hasSea)
    {
        GameObject made = new("Radar"), sea = new("Sea");
        try
        {
            made.transform.position = new Vector3(0, 15, 0);
            made.AddComponent<RadarReflector>();
            var screen = made.AddComponent<RadarScreen>();
            var radar = ScreenRadar.Default;
            (radar.Spokes, radar.Cells, radar.RainRate) = (1024, 64, 5);
            var display = ScreenDisplay.Default;
            display.Side = 64;
            (screen.Kernel, screen.SeaKernel) = (TestKernels.Screen, TestKernels.SeaField);
            (screen.Radar, screen.Display) = (radar, display);
            if (hasSea)
            {
                screen.Sea = sea.AddComponent<Sea>();
                screen.Sea.Clutter = SeaClutterSettings.On;
            }
            for (int frame = 0; frame < 100; frame++)
                screen.Advance(0.01);
            long before = GC.GetAllocatedBytesForCurrentThread();
            for (int frame = 0; frame < 100; frame++)
                screen.Advance(0.01);
            Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.Zero);
        }
        finally
        {
            UnityEngine.Object.DestroyImmediate(made);
            UnityEngine.Object.DestroyImmediate(sea);
        }
    }
}
