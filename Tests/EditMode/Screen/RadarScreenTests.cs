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
        // Objects of other tests are on others.
        const int Layer = 28;

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
            _screen.Layers = 1 << Layer;
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

        // Spokes count from the first pass of north, from which other radars have their bearings.
        [TestCase(0, 0)]
        [TestCase(80, -797)]
        [TestCase(280, -228)]
        public void Spokes_OfAShipOnACourse_AreCountedFromTheFirstPassOfNorth(float heading, long first)
        {
            _screen.OwnShip.rotation = Quaternion.Euler(0, heading, 0);
            _screen.Advance(0);
            _screen.Advance(0.1);
            _screen.ReadFrame(out long spoke);
            Assert.That(spoke, Is.EqualTo(first));
            Assert.That(_screen.AntennaDegrees, Is.EqualTo((heading + 14.4) % 360).Within(1e-3));
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

        // A ship that a script moves, from the second turn on: it was merged with what stands still before.
        [Test]
        public void Ship_ThatMoves_EchoesFromWhereItIs()
        {
            Ship("Pier", new Vector3(-3000, 15, 0));
            var ship = Ship("Ship", new Vector3(3000, 15, 0));
            AssertEchoes(0, 3000, -3000);
            foreach (float at in new float[] { 3500, 4000 })
            {
                ship.transform.position = new Vector3(at, 15, 0);
                AssertEchoes(0, at, -3000);
            }
            // An own ship in the scene has no echo.
            _screen.OwnShip = ship.transform;
            AssertEchoes(0, -3000);
        }

        [Test]
        public void Ship_ThatIsHiddenOrDestroyed_IsNotShown_AndNewOnesAreAfterGatherAgain()
        {
            var ship = Ship("Ship", new Vector3(3000, 15, 0));
            var other = Ship("Other", new Vector3(0, 15, 4000));
            AssertEchoes(0, 3000);
            AssertEchoes(90, 4000);
            ship.GetComponent<Renderer>().enabled = false;
            AssertEchoes(0);
            UnityEngine.Object.DestroyImmediate(other);
            AssertEchoes(90);
            Ship("New", new Vector3(5000, 15, 0));
            AssertEchoes(0);
            _screen.GatherAgain();
            AssertEchoes(0, 5000);
            _screen.Layers = 0;
            AssertEchoes(0);
            Assert.That(_screen.PointCount, Is.Zero);
        }

        [Test]
        public void Seas_AreNotTraced()
        {
            var tile = Ship("Snapshot", new Vector3(3000, 15, 0));
            tile.AddComponent<SeaSnapshot>();
            AssertEchoes(0);
        }

        // The library has wet ground up to 10 GHz.
        [Test]
        public void Meshes_ThatCannotBeTraced_AreRefused()
        {
            var ship = Ship("Ship", new Vector3(3000, 15, 0));
            var material = ScriptableObject.CreateInstance<RadarMaterial>();
            (material.name, material.Kind, material.Published) = ("mud", RadarMaterialKind.Published, "itu_wet_ground");
            ship.AddComponent<RadarSurface>().Material = material;
            var radar = _screen.Radar;
            radar.Frequency = 11e9;
            _screen.Radar = radar;
            Assert.That(() => _screen.Advance(0), Throws.InstanceOf<GlintException>()
                .With.Message.StartsWith("material 'mud' has no data at"));
            UnityEngine.Object.DestroyImmediate(material);
            var mesh = UnityEngine.Object.Instantiate(ship.GetComponent<MeshFilter>().sharedMesh);
            mesh.name = "sealed";
            mesh.UploadMeshData(true);
            ship.GetComponent<MeshFilter>().sharedMesh = mesh;
            Assert.That(() => _screen.Advance(0), Throws.InstanceOf<GlintException>().With.Message.EqualTo(
                "RadarScreen of 'Radar': mesh 'sealed' of 'Ship' is not readable: tick Read/Write in the mesh's import "
                + "settings; or take its layer out of Layers"));
            _screen.Layers = 0;
            _screen.Advance(0);
            UnityEngine.Object.DestroyImmediate(mesh);
        }

        // Half a cell, and 64 points of a cube.
        [Test]
        public void Points_OfMeshes_AreCounted()
        {
            Ship("Ship", new Vector3(3000, 15, 0)).transform.localScale = Vector3.one;
            TurnOnce();
            Assert.That(_screen.PointCount, Is.EqualTo(64));
            Assert.That(_screen.PointSpacing, Is.EqualTo(_screen.Geometry.CellSize / 2));
            Assert.That(_screen.MeshBytes, Is.GreaterThan(64 * 32));
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

        // The compass makes +X north.
        [Test]
        public void TrueTrails_KeepTheirPlaceOverTheGround()
        {
            Make("Compass", Vector3.zero).AddComponent<Compass>().transform.rotation = Quaternion.Euler(0, 90, 0);
            var receiver = _screen.Receiver;
            (receiver.TrailTurns, receiver.TrailMotion) = (10, TrailMotion.True);
            _screen.Receiver = receiver;
            _screen.OwnShip.position = new Vector3(3000, 0, -2000);
            _screen.Advance(0.1);
            double pixel = _screen.Geometry.Radar.RangeScale / TrailMap.Radius;
            Assert.That(_screen.Tracer.TrailMiddle.x, Is.EqualTo(2000 / pixel).Within(1e-3));
            Assert.That(_screen.Tracer.TrailMiddle.y, Is.EqualTo(3000 / pixel).Within(1e-3));
        }

        // To the east, where its own beam stands on the screen; with north at +X it is to the north. 5 kHz are 30 km.
        [TestCase(0, 90)]
        [TestCase(90, 0)]
        public void InterferingRadar_IsAtItsTrueBearing(float north, double bearing)
        {
            Make("Compass", Vector3.zero).AddComponent<Compass>().transform.rotation = Quaternion.Euler(0, north, 0);
            var other = Make("Other", new Vector3(4000, 15, 0)).AddComponent<InterferingRadar>();
            (other.PulseRate, other.TurnsAMinute, other.StartBearing) = (5000, 0, (float)bearing + 180);
            TurnOnce();
            var levels = _screen.ReadLevels();
            int[] spokes = Enumerable.Range(0, 1024).Where(spoke => levels.Skip(256 * spoke).Take(256).Max() > 20).ToArray();
            Assert.That(spokes, Is.Not.Empty);
            // 108 dB over noise in the middle: the Gaussian beam is 88 dB down at 3.24 degrees.
            Assert.That(spokes.Select(spoke => Math.Abs(Math.IEEERemainder(360 * spoke / 1024.0 - bearing, 360))),
                Is.All.LessThan(3.3));
            other.enabled = false;
            TurnOnce();
            Assert.That(_screen.ReadLevels().Max(), Is.LessThan(20));
            Assert.That(() => other.PulseRate = 0, Throws.InstanceOf<GlintException>()
                .With.Message.StartsWith("InterferingRadar of 'Other': a pulse rate of 0 Hz"));
            foreach (float value in new[] { float.NaN, float.PositiveInfinity })
            {
                Assert.That(() => other.TurnsAMinute = value, Throws.InstanceOf<GlintException>()
                    .With.Message.StartsWith("InterferingRadar of 'Other': a turn rate of "));
                Assert.That(() => other.StartBearing = value, Throws.InstanceOf<GlintException>()
                    .With.Message.StartsWith("InterferingRadar of 'Other': a start bearing of "));
            }
            Assert.That((other.TurnsAMinute, other.StartBearing), Is.EqualTo((0f, (float)bearing + 180)));
        }

        [Test]
        public void Messages_HaveNumbersOfNoLanguage()
        {
            using (new ForeignCulture())
            {
                var reflector = Reflector(Vector3.zero, 1);
                Assert.That(() => reflector.CrossSection = -0.5, Throws.InstanceOf<GlintException>()
                    .With.Message.Contains(" -0.5 m2"));
                var other = Make("Other", Vector3.zero).AddComponent<InterferingRadar>();
                Assert.That(() => other.Power = -0.5f, Throws.InstanceOf<GlintException>()
                    .With.Message.Contains(" -0.5 W"));
            }
        }

        [Test]
        public void PatternTable_IsThatOfTheText()
        {
            var radar = ScreenBench.Small();
            radar.Pattern = ScreenPattern.Table;
            _screen.PatternTable = new TextAsset(EchoAntenna.TableHeader + "\n-3,-40,0\n0,0,0\n3,-40,0\n");
            _screen.Radar = radar;
            _screen.Advance(0.1);
            Assert.That(_screen.Geometry.BeamWidth, Is.EqualTo(1.775).Within(0.01));
            _screen.PatternTable = null;
            Assert.That(() => _screen.Advance(0.1), Throws.InstanceOf<GlintException>()
                .With.Message.StartsWith("RadarScreen of 'Radar': its pattern is that of a table"));
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

        GameObject Ship(string name, Vector3 position)
        {
            var ship = GameObject.CreatePrimitive(PrimitiveType.Cube);
            (ship.name, ship.layer) = (name, Layer);
            ship.transform.position = position;
            ship.transform.localScale = new Vector3(30, 30, 30);
            _made.Add(ship);
            return ship;
        }

        // The cells on the bearings of +X and -X, or those turned by some degrees against the clock, that are 40 dB over
        // noise: one at each place, x of its middle. The near side of a cube is 15 m nearer, in this cell or the last.
        void AssertEchoes(double turn, params double[] places)
        {
            TurnOnce();
            var levels = _screen.ReadLevels();
            var found = new List<double>();
            foreach (int side in new[] { 1, -1 })
            {
                int spoke = (int)Math.Round((side * 90 - turn + 360) % 360 / 360 * 1024);
                int before = -2;
                for (int cell = 0; cell < 256; cell++)
                    if (levels[256 * spoke + cell] > 40)
                    {
                        if (cell > before + 2)
                            found.Add(side * (cell + 0.5) * _screen.Geometry.CellSize);
                        before = cell;
                    }
            }
            Assert.That(found, Has.Count.EqualTo(places.Length));
            for (int i = 0; i < places.Length; i++)
                Assert.That(found[i], Is.EqualTo(places[i]).Within(70));
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
