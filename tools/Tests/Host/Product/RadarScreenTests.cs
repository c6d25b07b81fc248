using System;
using Glint.Core;
using Glint.Tests;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Host.Tests.Product;

public sealed class RadarScreenTests
{
    // The first frames make buffers and compile methods; then a frame is free of garbage.
    [Test]
    public void Frame_AllocatesNothing()
    {
        var made = new GameObject("Radar");
        try
        {
            made.AddComponent<RadarReflector>();
            var screen = made.AddComponent<RadarScreen>();
            var radar = ScreenRadar.Default;
            (radar.Spokes, radar.Cells, radar.RainRate) = (1024, 64, 5);
            var display = ScreenDisplay.Default;
            display.Side = 64;
            (screen.Kernel, screen.Radar, screen.Display) = (TestKernels.Screen, radar, display);
            for (int frame = 0; frame < 100; frame++)
                screen.Advance(0.02);
            long before = GC.GetAllocatedBytesForCurrentThread();
            for (int frame = 0; frame < 100; frame++)
                screen.Advance(0.02);
            Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.Zero);
        }
        finally
        {
            UnityEngine.Object.DestroyImmediate(made);
        }
    }
}
