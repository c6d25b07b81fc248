using System;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace Glint.Tests
{
    /// <summary>The picture in a texture, compared with the processor's and with what is at known places.</summary>
    public sealed class ScreenPictureTests
    {
        const double Heading = 30;

        static readonly ScreenColours s_colours = new ScreenColours
        {
            Outside = new double3(0.1, 0.1, 0.2), Background = 0, Echo = new double3(1, 0.9, 0),
            Trail = new double3(0, 0.2, 0.8), Rings = new double3(0, 0.6, 0), Heading = 1, Marker = new double3(0, 1, 1)
        };

        // Larger than the cells, so that it interpolates, and smaller, so that pixels have several of them.
        [TestCase(900, 256, 64, PictureOrientation.NorthUp, TrailMotion.Relative)]
        [TestCase(150, 1024, 512, PictureOrientation.HeadUp, TrailMotion.True)]
        public void Pixels_AreThoseOfTheProcessor(int side, int spokes, int cells, PictureOrientation orientation,
            TrailMotion motion)
        {
            var radar = ScreenBench.Small(spokes, cells);
            (radar.BeamWidth, radar.RainRate) = (6, 30);
            using (var bench = new ScreenBench(radar, (10, 3000, 1e4), (200, 8000, 1e3), (359, 11000, 1e5)))
            {
                (bench.Receiver.TrailTurns, bench.Receiver.PersistenceTurns) = (5, 1);
                (bench.Receiver.TrailMotion, bench.Position) = (motion, new double2(-1234, 56789));
                bench.Turn(0, 500);
                var display = DisplayOf(side, orientation);
                (display.HasBearingLine, display.BearingLine, display.RangeMarker) = (true, 250, 4000);
                var view = ScreenView.Of(bench.Geometry, display, bench.Receiver, s_colours, Heading / 360,
                    bench.Tracer.Front - 1, bench.Tracer.TrailMiddle);
                byte[] expected = new ScreenPicture(bench.Geometry, view, bench.Video(), bench.Trails()).Draw();
                byte[] pixels = Draw(bench, view);
                int different = 0;
                for (int i = 0; i < pixels.Length; i++)
                    if (Math.Abs(pixels[i] - expected[i]) > 1)
                        different++;
                // At edges of cells float32 may choose the neighbour.
                Assert.That(different, Is.LessThan(pixels.Length / 2000));
            }
        }

        // A reflector 5,556 m to the east, half the range scale, and the ship heads for 30 degrees.
        [TestCase(PictureOrientation.NorthUp, 90)]
        [TestCase(PictureOrientation.HeadUp, 60)]
        public void Reflector_IsWhereItsBearingAndRangePutIt(PictureOrientation orientation, double shown)
        {
            const int side = 400;
            using (var bench = new ScreenBench(ScreenBench.Small(), (90, 5556, 1e4)))
            {
                bench.Receiver.GainDb = -20;
                bench.Turn(0, 180);
                var display = DisplayOf(side, orientation);
                display.RangeRings = 0;
                byte[] pixels = Draw(bench, ScreenView.Of(bench.Geometry, display, bench.Receiver, s_colours,
                    Heading / 360, bench.Tracer.Front - 1, 0));
                double angle = math.radians(shown);
                int x = (int)(side / 2 + side / 4 * Math.Sin(angle)), y = (int)(side / 2 + side / 4 * Math.Cos(angle));
                Assert.That(pixels[4 * (y * side + x)], Is.GreaterThan(100), "echo");
                Assert.That(pixels[4 * (y * side + side - x)], Is.LessThan(20), "its mirror image");
                double line = math.radians(orientation == PictureOrientation.NorthUp ? Heading : 0);
                int lineX = (int)(side / 2 + 50 * Math.Sin(line)), lineY = (int)(side / 2 + 50 * Math.Cos(line));
                Assert.That(pixels[4 * (lineY * side + lineX) + 2], Is.GreaterThan(90), "heading line");
                Assert.That(pixels[0], Is.EqualTo(26).Within(1), "corner");
            }
        }

        // An encoded grey of 0.5 is 0.214 in linear light.
        [Test]
        public void Colours_OfALinearProject_AreLinear()
        {
            using (var bench = new ScreenBench(ScreenBench.Small()))
            {
                var colours = s_colours;
                colours.Outside = 0.5;
                var view = ScreenView.Of(bench.Geometry, DisplayOf(64, PictureOrientation.NorthUp), bench.Receiver,
                    colours, 0, 0, 0);
                Assert.That(Draw(bench, view)[0], Is.EqualTo(128).Within(1));
                Assert.That(Draw(bench, view, isLinear: true)[0], Is.EqualTo(0.214 * 255).Within(1));
            }
        }

        static ScreenDisplay DisplayOf(int side, PictureOrientation orientation)
        {
            var display = ScreenDisplay.Default;
            (display.Side, display.Orientation) = (side, orientation);
            return display;
        }

        static byte[] Draw(ScreenBench bench, in ScreenView view, bool isLinear = false)
        {
            var texture = new RenderTexture(view.Side, view.Side, 0, GraphicsFormat.R8G8B8A8_UNorm)
            {
                enableRandomWrite = true
            };
            try
            {
                texture.Create();
                bench.Tracer.Draw(texture, view, isLinear);
                var request = AsyncGPUReadback.Request(texture);
                request.WaitForCompletion();
                return request.GetData<byte>().ToArray();
            }
            finally
            {
                UnityEngine.Object.DestroyImmediate(texture);
            }
        }
    }
}
