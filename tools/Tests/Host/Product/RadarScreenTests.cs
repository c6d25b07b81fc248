using System;
using System.Linq;
using Glint.Core;
using Glint.Host.Tests.Vulkan;
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
            (radar.Spokes, radar.Cells, radar.RainRate, radar.RangeScale) = (1024, 64, 5, 500);
            var display = ScreenDisplay.Default;
            display.Side = 64;
            (screen.Kernel, screen.SeaKernel) = (TestKernels.Screen, TestKernels.SeaField);
            (screen.Radar, screen.Display) = (radar, display);
            if (hasSea)
            {
                screen.Sea = sea.AddComponent<Sea>();
                screen.Sea.Clutter = SeaClutterSettings.On;
            }
            for (int frame = 0; frame < 30; frame++)
                screen.Advance(0.01);
            long before = GC.GetAllocatedBytesForCurrentThread();
            for (int frame = 0; frame < 30; frame++)
                screen.Advance(0.01);
            Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.Zero);
        }
        finally
        {
            UnityEngine.Object.DestroyImmediate(made);
            UnityEngine.Object.DestroyImmediate(sea);
        }
    }

    [Test]
    public void Picture_OnADeviceThatDrawsIntoNoTexture_IsThereAsAnArray()
    {
        var made = new GameObject("Mast");
        using var log = new LogCapture();
        try
        {
            GraphicsDevice.HasStoredTextures = false;
            var screen = made.AddComponent<RadarScreen>();
            screen.Kernel = TestKernels.Screen;
            var display = ScreenDisplay.Default;
            display.Side = 64;
            screen.Display = display;
            screen.Advance(0.1);
            screen.Advance(0.1);
            Assert.That(screen.Picture == null);
            Assert.That(log.Messages.Single().Text, Does.StartWith("RadarScreen of 'Mast': ").And.EndsWith(
                "does not draw into textures of the format R8G8B8A8_UNorm: Picture is empty, use ReadPicture"));
            Assert.That(screen.ReadPicture(), Has.Length.EqualTo(4 * 64 * 64));
        }
        finally
        {
            GraphicsDevice.HasStoredTextures = true;
            UnityEngine.Object.DestroyImmediate(made);
        }
    }
}
