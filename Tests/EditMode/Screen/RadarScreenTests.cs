using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Glint.Tests
{
    /// <summary>The component: own ship, compass, reflectors, settings and picture.</summary>
    public sealed class RadarScreenTests
    {
        readonly List<GameObject> _made = new List<GameObject>();
        RadarScreen _screen;

        [SetUp]
        public void MakeShip()
        {
            var ship = Make("Ship", Vector3.zero);
            var mast = Make("Radar", new Vector3(0, 15, 0));
            mast.transform.SetParent(ship.transform, false);
            _screen = mast.AddComponent<RadarScreen>();
            _screen.Kernel = TestKernels.Screen;
            _screen.OwnShip = ship.transform;
            _screen.Radar = ScreenBench.Small();
            var display = ScreenDisplay.Default;
            display.Side = 128;
            _screen.Display = display;
        }

        [TearDown]
        public void Destroy()
        {
            foreach (var made in _made)
                UnityEngine.Object.DestroyImmediate(made);
            _made.Clear();
        }

        // East of the radar; the compass points to +X, so that it is north; and the ship may head anywhere.
        [TestCase(0, 0, 90)]
        [TestCase(90, 0, 0)]
        [TestCase(0, 200, 90)]
        [TestCase(-30, 45, 120)]
        public void Reflector_IsAtItsTrueBearing(float north, float heading, double bearing)
        {
            Make("Compass", Vector3.zero).AddComponent<Compass>().transform.rotation = Quaternion.Euler(0, north, 0);
            _screen.OwnShip.rotation = Quaternion.Euler(0, heading, 0);
            Reflector(new Vector3(4000, 15, 0), 1e4);
            TurnOnce();
            var levels = _screen.ReadLevels();
            int largest = Array.IndexOf(levels, levels.Max());
            Assert.That(largest / 256, Is.EqualTo((int)Math.Round(bearing / 360 * 1024)));
            Assert.That(largest % 256, Is.EqualTo((int)(4000 / _screen.Geometry.CellSize)));
            Assert.That(_screen.HeadingDegrees, Is.EqualTo((heading - north + 360) % 360).Within(1e-3));
        }

        // 24 turns a minute are 144 degrees a second over the bow; a ship that turns adds its own turn.
        [Test]
        public void Antenna_TurnsClockwise_WithTheShip()
        {
            _screen.Advance(0);
            Assert.That(_screen.AntennaDegrees, Is.EqualTo(0).Within(1e-6));
            _screen.Advance(0.5);
            Assert.That(_screen.AntennaDegrees, Is.EqualTo(72).Within(1e-6));
            _screen.OwnShip.rotation = Quaternion.Euler(0, 350, 0);
            _screen.Advance(0.5);
            Assert.That(_screen.AntennaDegrees, Is.EqualTo(134).Within(1e-3));
        }

        [Test]
        public void Reflectors_OfAnyNumber_AreShown()
        {
            for (int i = 0; i < 40; i++)
                Reflector(new Vector3(0, 15, 1000 + 200 * i), 1e5);
            TurnOnce();
            var levels = _screen.ReadLevels();
            for (int i = 0; i < 40; i++)
                Assert.That(levels[(int)((1000 + 200 * i) / _screen.Geometry.CellSize)], Is.GreaterThan(40), $"{i}");
        }

        [Test]
        public void Reflector_ThatIsDisabledOrDestroyed_IsNotShown()
        {
            var reflector = Reflector(new Vector3(0, 15, 4000), 1e5);
            Assert.That(Peak(), Is.GreaterThan(40));
            reflector.enabled = false;
            Assert.That(Peak(), Is.LessThan(20));
            reflector.enabled = true;
            Assert.That(Peak(), Is.GreaterThan(40));
            UnityEngine.Object.DestroyImmediate(reflector.gameObject);
            Assert.That(Peak(), Is.LessThan(20));
        }

        [Test]
        public void Picture_IsTheTextureThatTheProcessorDraws()
        {
            Reflector(new Vector3(3000, 15, 4000), 1e4);
            TurnOnce();
            var request = AsyncGPUReadback.Request(_screen.Picture);
            request.WaitForCompletion();
            byte[] pixels = request.GetData<byte>().ToArray(), expected = _screen.ReadPicture();
            Assert.That(pixels, Has.Length.EqualTo(4 * 128 * 128));
            Assert.That(pixels.Zip(expected, (a, b) => Math.Abs(a - b) > 1).Count(differs => differs), Is.LessThan(40));
            Assert.That(pixels.Where((_, i) => i % 4 == 0).Max(), Is.GreaterThan(150), "an echo");
        }

        // 5 km away to the north-east, at 0.6 of the range scale.
        [Test]
        public void Detections_AreMarkedInThePicture()
        {
            var radar = ScreenBench.Small();
            radar.RangeScale = 5000 / 0.6;
            _screen.Radar = radar;
            Reflector(new Vector3(3000, 15, 4000), 1e4);
            TurnOnce();
            var strongest = _screen.ReadDetections().OrderByDescending(each => each.OverThresholdDb).First();
            double scale = 64 / radar.RangeScale;
            Assert.That(strongest.Range * scale * Math.Sin(strongest.BearingDegrees * Math.PI / 180),
                Is.EqualTo(3000 * scale).Within(1));
            byte[] plain = _screen.ReadPicture(), marked = _screen.ReadPicture();
            _screen.Mark(marked, new[] { strongest });
            var changed = Enumerable.Range(0, 128 * 128).Where(pixel => plain[4 * pixel] != marked[4 * pixel]
                || plain[4 * pixel + 2] != marked[4 * pixel + 2]).ToArray();
            Assert.That(changed, Has.Length.EqualTo(1));
            Assert.That(changed[0] % 128, Is.EqualTo(63.5 + 3000 * scale).Within(1.5));
            Assert.That(changed[0] / 128, Is.EqualTo(63.5 + 4000 * scale).Within(1.5));
        }

        [Test]
        public void Picture_StaysTheSameObject_UntilItsSizeChanges()
        {
            _screen.Advance(0.1);
            var picture = _screen.Picture;
            var radar = _screen.Radar;
            radar.RangeScale /= 2;
            _screen.Radar = radar;
            _screen.Advance(0.1);
            Assert.That(_screen.Picture, Is.SameAs(picture));
            Assert.That(_screen.Geometry.Radar.RangeScale, Is.EqualTo(radar.RangeScale));
            var display = _screen.Display;
            display.Side = 200;
            _screen.Display = display;
            _screen.Advance(0.1);
            Assert.That(_screen.Picture.width, Is.EqualTo(200));
        }

        [Test]
        public void Mistakes_AreRefusedWithTheirName()
        {
            Assert.That(() => _screen.ReadLevels(), Throws.InstanceOf<GlintException>()
                .With.Message.StartsWith("RadarScreen of 'Radar' has no turn yet"));
            foreach (double seconds in new[] { -0.1, double.NaN, double.PositiveInfinity })
                Assert.That(() => _screen.Advance(seconds), Throws.InstanceOf<GlintException>()
                    .With.Message.Contains("give a time of 0 or more"));
            Assert.That(() => _screen.Radar = new ScreenRadar(), Throws.InstanceOf<GlintException>()
                .With.Message.StartsWith("RadarScreen of 'Radar': frequency 0 Hz must be from"));
            var reflector = Reflector(Vector3.zero, 1);
            Assert.That(() => reflector.CrossSection = -1, Throws.InstanceOf<GlintException>()
                .With.Message.StartsWith("RadarReflector of 'Reflector'"));
            Make("North", Vector3.zero).AddComponent<Compass>();
            Make("South", Vector3.zero).AddComponent<Compass>();
            Assert.That(() => _screen.Advance(0), Throws.InstanceOf<GlintException>()
                .With.Message.Contains("2 compasses"));
            UnityEngine.Object.DestroyImmediate(_made[_made.Count - 1]);
            _screen.Kernel = null;
            Assert.That(() => _screen.Advance(0), Throws.InstanceOf<GlintException>()
                .With.Message.StartsWith("RadarScreen of 'Radar' has no kernel"));
        }

        float Peak()
        {
            TurnOnce();
            return _screen.ReadLevels().Max();
        }

        void TurnOnce()
        {
            // 2.5 s a turn, and the beam.
            for (int frame = 0; frame < 14; frame++)
                _screen.Advance(0.2);
        }

        RadarReflector Reflector(Vector3 position, double section)
        {
            var reflector = Make("Reflector", position).AddComponent<RadarReflector>();
            reflector.CrossSection = section;
            return reflector;
        }

        GameObject Make(string name, Vector3 position)
        {
            var made = new GameObject(name);
            made.transform.position = position;
            _made.Add(made);
            return made;
        }
    }
}
