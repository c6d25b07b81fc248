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
        GameObject made = new("Radar"), sea = new("Sea"), ship = GameObject.CreatePrimitive(PrimitiveType.Cube),
            pier = GameObject.CreatePrimitive(PrimitiveType.Cube);
        try
        {
            made.transform.position = new Vector3(0, 15, 0);
            made.AddComponent<RadarReflector>();
            (ship.transform.position, pier.transform.position) = (new Vector3(0, 0, 200), new Vector3(0, 0, 300));
            const int layer = 28;
            (ship.layer, pier.layer) = (layer, layer);
            var underway = ship.AddComponent<Underway>();
            var screen = made.AddComponent<RadarScreen>();
            var radar = ScreenRadar.Default;
            (radar.Spokes, radar.Cells, radar.RainRate, radar.RangeScale) = (1024, 64, 5, 500);
            (radar.Pattern, radar.PulseRate, radar.BlindWidth) = (ScreenPattern.Sinc, 2000, 20);
            pier.AddComponent<InterferingRadar>();
            var display = ScreenDisplay.Default;
            display.Side = 64;
            var receiver = ScreenReceiver.Default;
            (receiver.TrailTurns, receiver.TrailMotion) = (10, TrailMotion.True);
            screen.Receiver = receiver;
            (screen.Kernel, screen.SeaKernel) = (TestKernels.Screen, TestKernels.SeaField);
            (screen.Radar, screen.Display, screen.Layers) = (radar, display, 1 << layer);
            if (hasSea)
            {
                screen.Sea = sea.AddComponent<Sea>();
                screen.Sea.Clutter = SeaClutterSettings.On;
            }
            long allocated = 0;
            for (int frame = 0; frame < 60; frame++)
            {
                // The host's Transform allocates, the screen that follows the ship does not.
                underway.Advance(0.01);
                long before = GC.GetAllocatedBytesForCurrentThread();
                screen.Advance(0.01);
                if (frame >= 30)
                    allocated += GC.GetAllocatedBytesForCurrentThread() - before;
            }
            Assert.That(allocated, Is.Zero);
            Assert.That(screen.PointCount, Is.EqualTo(128));
        }
        finally
        {
            UnityEngine.Object.DestroyImmediate(made);
            UnityEngine.Object.DestroyImmediate(sea);
            UnityEngine.Object.DestroyImmediate(ship);
            UnityEngine.Object.DestroyImmediate(pier);
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
