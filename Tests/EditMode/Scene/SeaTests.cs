using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Glint.Tests
{
    /// <summary>A sea of tiles as gathered for the radar.</summary>
    public sealed class SeaTests : GathererFixture
    {
        const double Tile = 32;
        const int Cells = 16;

        Sea _sea;

        [SetUp]
        public void MakeSea()
        {
            _sea = _scene.Empty("Sea").gameObject.AddComponent<Sea>();
            _sea.Waves = Settings(1);
        }

        [Test]
        public void Extent_OfWholeTiles_IsCoveredOnceAboutTheOrigin()
        {
            Rebuild(64, 128);

            var scene = _scene.Gather(_gatherer);
            Assert.That(scene.Instances.Sum(instance => instance.Mesh.TriangleCount),
                Is.EqualTo(2 * 4 * 2 * Cells * Cells));
            var corners = SceneBuilder.Corners(scene);
            Assert.That(corners.Min(p => p.x), Is.EqualTo(-32).Within(3));
            Assert.That(corners.Max(p => p.x), Is.EqualTo(32).Within(3));
            Assert.That(corners.Min(p => p.z), Is.EqualTo(-64).Within(3));
            Assert.That(corners.Max(p => p.z), Is.EqualTo(64).Within(3));
            // A closed surface from above: the signed areas of its triangles add up to the rectangle, without overlaps
            // or gaps.
            Assert.That(Area(corners), Is.EqualTo(64 * 128).Within(1e-3));
        }

        [Test]
        public void Layer_Changed_IsThatOfTheTilesToo()
        {
            Rebuild(64, 64);
            _sea.gameObject.layer = 4;
            _sea.Rebuild();
            var shown = _sea.GetComponentsInChildren<MeshRenderer>().Where(renderer => renderer.enabled);
            Assert.That(shown.Select(renderer => renderer.gameObject.layer), Is.EqualTo(new[] { 4, 4, 4, 4 }));
        }

        [Test]
        public void Extent_Large_IsInstancesOfOneMesh()
        {
            Rebuild(1024, 1024);

            var scene = _scene.Gather(_gatherer);
            Assert.That(scene.Instances.Count, Is.EqualTo(1024));
            Assert.That(scene.Instances.Select(instance => instance.Mesh).Distinct().Count(), Is.EqualTo(1));
        }

        [Test]
        public void Centre_Elsewhere_TakesTheTilesAlongAndLeavesTheWavesWhereTheyAre()
        {
            Rebuild(96, 96);
            var before = Heights();
            _sea.Centre = _scene.Empty("Radar");
            _sea.Centre.localPosition = new Vector3(40, 7, -20);
            _sea.Rebuild();
            var after = Heights();

            var common = before.Keys.Intersect(after.Keys).ToArray();
            Assert.That(common.Length, Is.GreaterThan(before.Count / 4).And.LessThan(before.Count));
            foreach (var position in common)
                Assert.That(after[position], Is.EqualTo(before[position]));
            Assert.That(after.Keys.Average(at => at.x), Is.EqualTo(32).Within(1), "the nearest tile to 40 m");
        }

        // A centre that moves, such as a ship's, costs no new waves.
        [Test]
        public void Centre_Elsewhere_LeavesTheMeshAsItIs()
        {
            Rebuild(1024, 1024);
            var mesh = _scene.Gather(_gatherer).Instances[0].Mesh;
            _sea.Centre = _scene.Empty("Radar");
            _sea.Centre.localPosition = new Vector3(40, 7, -20);
            _sea.Rebuild();
            Assert.That(_scene.Gather(_gatherer).Instances[0].Mesh, Is.SameAs(mesh));
            _sea.TimeSeconds = 1;
            Assert.That(_scene.Gather(_gatherer).Instances[0].Mesh, Is.Not.SameAs(mesh));
        }

        [Test]
        public void TimeSeconds_Later_ShowsTheSeaOfThatMoment()
        {
            Rebuild(32, 32);
            _sea.TimeSeconds = 2.5;

            var expected = new SeaSurface(Settings(1)).Mesh(2.5);
            Assert.That(SceneBuilder.Corners(_scene.Gather(_gatherer)),
                Is.EquivalentTo(expected.Indices.Select(index => (double3)expected.Vertices[index])));
        }

        [Test]
        public void Snapshot_Chosen_ShowsItsTile()
        {
            AddSnapshots();
            Rebuild(32, 32);
            _sea.Snapshot = 2;

            var expected = new SeaSurface(Settings(2)).Mesh(0);
            Assert.That(SceneBuilder.Corners(_scene.Gather(_gatherer)),
                Is.EquivalentTo(expected.Indices.Select(index => (double3)expected.Vertices[index])));
        }

        [TestCase(0, "has no snapshot 0: it has 1 to 2")]
        [TestCase(3, "has no snapshot 3: it has 1 to 2")]
        public void Snapshot_ThatIsNotThere_IsRefused(int number, string part)
        {
            AddSnapshots();
            Assert.That(Assert.Throws<GlintException>(() => _sea.Snapshot = number).Message,
                Does.Contain("'Sea'").And.Contain(part));
            Assert.That(_sea.Snapshot, Is.EqualTo(1));
        }

        [Test]
        public void Snapshot_OfASeaWithout_IsRefused() =>
            Assert.That(Assert.Throws<GlintException>(() => _sea.Snapshot = 1).Message,
                Does.Contain("'Sea' has no snapshots").And.Contain("glint sea"));

        [Test]
        public void Enabled_OffAndOnAgain_RebuildsTheTilesOnce()
        {
            Rebuild(64, 64);
            int triangles = Triangles();
            _sea.enabled = false;
            Assert.That(Triangles(), Is.Zero);
            _sea.Rebuild();
            Assert.That(Triangles(), Is.Zero, "a sweep rebuilds all seas");
            _sea.enabled = true;
            Assert.That(Triangles(), Is.EqualTo(triangles));
            _sea.Extent = new Vector2(32, 32);
            _sea.Rebuild();
            Assert.That(Triangles(), Is.EqualTo(triangles / 4));
        }

        [Test]
        public void Copy_OfASea_RebuildsItsTilesOnce()
        {
            Rebuild(64, 64);
            int triangles = Triangles();
            Object.Instantiate(_sea.gameObject, _scene.Root);
            Assert.That(Triangles(), Is.EqualTo(2 * triangles));
        }

        // A player does not store hide flags.
        [Test]
        public void Copy_OfASeaThatLostItsHideFlags_RebuildsItsTilesOnce()
        {
            Rebuild(64, 64);
            int triangles = Triangles();
            var parent = _scene.Empty("Parent");
            parent.gameObject.SetActive(false); // the copy wakes after the flags are lost
            var copy = Object.Instantiate(_sea.gameObject, parent);
            foreach (var below in copy.GetComponentsInChildren<Transform>(true))
                below.hideFlags = below.gameObject.hideFlags = HideFlags.None;
            parent.gameObject.SetActive(true);
            Assert.That(Triangles(), Is.EqualTo(2 * triangles));
        }

        [Test]
        public void Tiles_AreTracedThoughHidden_AndOtherHiddenObjectsAreNot()
        {
            Rebuild(64, 64);
            int triangles = Triangles();
            var hidden = GameObject.CreatePrimitive(PrimitiveType.Cube);
            hidden.transform.SetParent(_scene.Root);
            hidden.hideFlags = HideFlags.HideInHierarchy;
            Assert.That(Tiles().Select(tile => tile.gameObject.hideFlags & HideFlags.HideInHierarchy),
                Is.Not.Empty.And.All.EqualTo(HideFlags.HideInHierarchy));
            var loaded = new VisibleRenderers().Find(~0, new Transform[0], null)
                .Where(renderer => renderer.transform.IsChildOf(_scene.Root));
            Assert.That(loaded, Is.EquivalentTo(Tiles()));
            Assert.That(triangles, Is.EqualTo(4 * 2 * Cells * Cells));
        }

        [Test]
        public void DrawInScene_Off_OmitsTheTilesFromThePictureOnly()
        {
            Rebuild(64, 64);
            int triangles = Triangles();
            Assert.That(Tiles().Select(tile => tile.forceRenderingOff), Has.All.False);
            _sea.DrawInScene = false;
            _sea.Rebuild();
            Assert.That(Tiles().Select(tile => tile.forceRenderingOff), Has.All.True);
            Assert.That(Triangles(), Is.EqualTo(triangles));
            _sea.DrawInScene = true;
            _sea.Rebuild();
            Assert.That(Tiles().Select(tile => tile.forceRenderingOff), Has.All.False);
        }

        [Test]
        public void Material_WithoutInstancing_IsReplacedByOneCopyThatHasIt()
        {
            var material = new Material(Shader.Find("Hidden/Internal-Colored"));
            _sea.Material = material;
            Rebuild(64, 64);
            var copy = Tiles().Select(tile => tile.sharedMaterial).Distinct().Single();
            Assert.That((copy.enableInstancing, copy.shader, material.enableInstancing),
                Is.EqualTo((true, material.shader, false)));
            _sea.Rebuild();
            Assert.That(Tiles()[0].sharedMaterial, Is.SameAs(copy));

            material.enableInstancing = true;
            _sea.Rebuild();
            Assert.That(Tiles().Select(tile => tile.sharedMaterial), Has.All.SameAs(material));
            Object.DestroyImmediate(_sea);
            Assert.That(copy == null, "it goes with the sea");
            Object.DestroyImmediate(material);
        }

        [TestCase(0, 64, "a side of 0 m")]
        [TestCase(-5, 64, "a side of -5 m")]
        [TestCase(float.NaN, 64, "a side of NaN m")]
        [TestCase(1e6f, 1e6f, "takes 976562500 tiles")]
        public void Extent_Unfit_IsRefused(float x, float z, string part)
        {
            _sea.Extent = new Vector2(x, z);
            Assert.That(Assert.Throws<GlintException>(() => _sea.Rebuild()).Message,
                Does.Contain("'Sea'").And.Contain(part));
        }

        [TestCase(float.NaN, 32, 7)]
        [TestCase(-1, 32, 7)]
        [TestCase(1, 0, 7)]
        [TestCase(1, 32, -7)]
        public void Waves_Unfit_AreRefusedByName(double height, double tile, double wind)
        {
            var bad = Settings(1);
            (bad.SignificantWaveHeight, bad.TileSize, bad.WindSpeed) = (height, tile, wind);
            Assert.That(Assert.Throws<GlintException>(() => _sea.Waves = bad).Message,
                Does.StartWith("Sea of 'Sea': "));
        }

        [Test]
        public void Motion_WavesWithSnapshots_IsRefused()
        {
            AddSnapshots();
            _sea.Motion = SeaMotion.Waves;
            Assert.That(Assert.Throws<GlintException>(() => _sea.Rebuild()).Message,
                Does.Contain("'Sea'").And.Contain("Waves"));
        }

        [Test]
        public void Clutter_Off_LeavesMirrorsAndNoSeas()
        {
            Rebuild(64, 64);
            Assert.That(_sea.Clutter.IsOn, Is.False);
            Assert.That(_sea.CurrentClutter(), Is.Null);
            var scene = _scene.Gather(_gatherer);
            Assert.That(scene.Seas, Is.Empty);
            Assert.That(scene.Surfaces, Is.EqualTo(new[] { SurfaceMaterial.PerfectConductor }));
            Assert.That(scene.Instances.Length, Is.EqualTo(1), "tiles of few triangles are merged");
        }

        [Test]
        public void Clutter_On_MakesEachTileAnInstanceOfSeaWater()
        {
            TurnClutterOn(64, 96);
            var scene = _scene.Gather(_gatherer);
            var sea = scene.Seas.Single();
            Assert.That(sea.Clutter, Is.SameAs(_sea.CurrentClutter()));
            Assert.That(sea.Tiles.Select(tile => tile.Instance), Is.EqualTo(Enumerable.Range(0, 6)));
            Assert.That(sea.Tiles.Select(tile => tile.Number), Is.Unique);
            Assert.That(scene.Instances.Select(instance => instance.Mesh).Distinct().Count(), Is.EqualTo(1));
            // Tiles 32 m apart have numbers 1 apart.
            double3 first = scene.Instances[0].ToWorld.Origin;
            foreach (var tile in sea.Tiles)
                Assert.That((scene.Instances[tile.Instance].ToWorld.Origin - first).xz / Tile,
                    Is.EqualTo((double2)(tile.Number - sea.Tiles[0].Number)));
            foreach (var instance in scene.Instances)
                Assert.That(instance.Ranges.Select(range => scene.Surfaces[range.Surface]),
                    Is.EqualTo(new[] { sea.Clutter.Surface }));
            Assert.That(_scene.Gather(_gatherer), Is.SameAs(scene), "nothing has changed");
            Assert.That(MaterialAssignment.Apply(scene, new MaterialAssignment[0]).Seas, Is.SameAs(scene.Seas));
        }

        // Waves of 4 m have 16 times the energy of those of 1 m, 12 dB; 5 m/s do not raise them.
        [Test]
        public void Clutter_OfAWindThatDoesNotFit_IsWarnedOfInEachGather()
        {
            TurnClutterOn(32, 32);
            _scene.Gather(_gatherer);
            Assert.That(_gatherer.Warnings, Is.Empty);
            var settings = SeaClutterSettings.On;
            settings.Wind = 5;
            _sea.Clutter = settings;
            var waves = Settings(1);
            waves.SignificantWaveHeight = 4;
            _sea.Waves = waves;
            _sea.Rebuild();
            _scene.Gather(_gatherer);
            Assert.That(_gatherer.Warnings.Single(),
                Does.StartWith("Sea of 'Sea': where its mesh ends").And.Contain("a clutter wind of 5 m/s").And.Contain("below"));
        }

        // The facets of the tile's mesh are those that break.
        [Test]
        public void Clutter_OnOfARadarWithoutItsKernel_IsRefusedBeforeThePoseIsTraced()
        {
            TurnClutterOn(32, 32);
            var radar = _scene.Empty("Radar").gameObject.AddComponent<RadarController>();
            radar.Receiver = radar.transform;
            (radar.Kernel, radar.ClutterKernel) = (TestKernels.Trace, null);
            radar.Roots.Add(_sea.transform);
            Assert.That(() => radar.StartTrace(RayReadback.None),
                Throws.TypeOf<GlintException>().With.Message.Contains("Tubes.compute to Clutter Kernel"));
        }

        [Test]
        public void Clutter_On_HasTheTrianglesOfTheTileInTheirOrder()
        {
            TurnClutterOn(32, 32);
            var scene = _scene.Gather(_gatherer);
            var expected = new SeaSurface(Settings(1)).Mesh(0);
            Assert.That(scene.Instances.Single().Mesh.Indices, Is.EqualTo(expected.Indices));
            Assert.That(scene.Seas[0].Clutter.BreakingFacets.Count, Is.EqualTo(expected.TriangleCount));
        }

        [Test]
        public void Clutter_WithAnotherCentre_KeepsTheNumberOfEachPlace([Values(64, 96)] int extent)
        {
            TurnClutterOn(extent, extent);
            var before = Numbers();
            _sea.Centre = _scene.Empty("Radar");
            _sea.Centre.localPosition = new Vector3(40, 7, -20);
            _sea.Rebuild();
            var after = Numbers();
            var common = before.Keys.Intersect(after.Keys).ToArray();
            Assert.That(common.Length, Is.GreaterThan(0).And.LessThan(before.Count));
            foreach (var place in common)
                Assert.That(after[place], Is.EqualTo(before[place]));
        }

        [Test]
        public void Clutter_BelowARadarSurface_HasItsMaterial()
        {
            TurnClutterOn(32, 32);
            var oil = new SurfaceMaterial("oil", null, Medium.Constant(2, 0.1));
            _sea.gameObject.AddComponent<RadarSurface>().Material = RadarMaterial.Of(oil);
            var scene = _scene.Gather(_gatherer);
            Assert.That(scene.Surfaces[scene.Instances[0].Ranges[0].Surface], Is.EqualTo(oil));
            Assert.That(scene.Seas.Count, Is.EqualTo(1));
        }

        [TestCase(0, 0, 1)]
        [TestCase(90, 1, 0)]
        public void Clutter_OfATurnedSea_HasATurnedWind(float degrees, double x, double z)
        {
            TurnClutterOn(32, 32);
            _sea.transform.localRotation = Quaternion.Euler(0, degrees, 0);
            Assert.That(math.distance(_sea.CurrentClutter().Wind, new double3(x, 0, z)), Is.LessThan(1e-6));
        }

        [Test]
        public void Clutter_AtAnotherTime_KeepsItsTables()
        {
            TurnClutterOn(32, 32);
            var before = _sea.CurrentClutter();
            _sea.TimeSeconds = 3;
            var after = _sea.CurrentClutter();
            Assert.That((before.Time, after.Time), Is.EqualTo((0.0, 3.0)));
            Assert.That(after.TableAt(10e9), Is.SameAs(before.TableAt(10e9)));
            var settings = _sea.Clutter;
            settings.Wind = 12;
            _sea.Clutter = settings;
            Assert.That(_sea.CurrentClutter().ShortWaves.Wind, Is.EqualTo(12));
        }

        [Test]
        public void Content_KnowsTheSettingsOfClutter()
        {
            TurnClutterOn(32, 32);
            ulong Content(int seed)
            {
                var settings = _sea.Clutter;
                settings.Seed = seed;
                _sea.Clutter = settings;
                _scene.Gather(_gatherer);
                return _gatherer.Content();
            }

            ulong first = Content(1), other = Content(2);
            Assert.That(other, Is.Not.EqualTo(first));
            Assert.That(Content(1), Is.EqualTo(first));
        }

        [Test]
        public void Clutter_OfASnapshot_IsThatOfItsSettings()
        {
            AddSnapshots();
            _sea.Snapshot = 2;
            TurnClutterOn(32, 32);
            Assert.That(_sea.CurrentClutter().LongWaves.Settings.Seed, Is.EqualTo(2));
            Assert.That(_scene.Gather(_gatherer).Seas.Count, Is.EqualTo(1));
            _sea.Snapshots[1].Set(MeshMaker.Make("Flat", new float3[3], new[] { 0, 1, 2 }), Settings(2), 0, 0);
            _sea.Rebuild();
            Assert.That(Assert.Throws<GlintException>(() => _scene.Gather(_gatherer)).Message,
                Is.EqualTo("Sea of 'Sea': its tile has 1 triangles, and its settings make 512: store the snapshot "
                    + "again with glint sea, or turn clutter off"));
        }

        [TestCase(0.1f, 1, "horizontal sea")]
        [TestCase(0, 2, "horizontal sea in metres")]
        public void Clutter_OfATiltedOrScaledSea_IsRefused(float degrees, float scale, string part)
        {
            TurnClutterOn(32, 32);
            _sea.transform.localRotation = Quaternion.Euler(degrees, 0, 0);
            _sea.transform.localScale = scale * Vector3.one;
            Assert.That(Assert.Throws<GlintException>(() => _scene.Gather(_gatherer)).Message,
                Does.StartWith("Sea of 'Sea': ").And.Contain(part).And.Contain("turn clutter off"));
        }

        [Test]
        public void Clutter_OutOfRange_IsRefusedWithTheSeasName()
        {
            var settings = SeaClutterSettings.On;
            settings.Salinity = 50;
            Assert.That(Assert.Throws<GlintException>(() => _sea.Clutter = settings).Message,
                Does.StartWith("Sea of 'Sea': salinity 50 psu must be from 0 to 40"));
            settings = SeaClutterSettings.On;
            settings.Wind = 2;
            _sea.Clutter = settings;
            Assert.That(Assert.Throws<GlintException>(() => _sea.CurrentClutter()).Message,
                Does.StartWith("Sea of 'Sea': sea: clutter wind 2 m/s must be from 3 to 20"));
        }

        static SeaSettings Settings(int seed)
        {
            var settings = SeaSettings.Default;
            (settings.TileSize, settings.GridSize, settings.Cells, settings.SignificantWaveHeight, settings.Seed) =
                (Tile, 16, Cells, 1, seed);
            return settings;
        }

        void TurnClutterOn(float x, float z)
        {
            _sea.Clutter = SeaClutterSettings.On;
            Rebuild(x, z);
        }

        Dictionary<double2, int2> Numbers()
        {
            var scene = _scene.Gather(_gatherer);
            return scene.Seas.Single().Tiles.ToDictionary(
                tile => scene.Instances[tile.Instance].ToWorld.Origin.xz, tile => tile.Number);
        }

        void Rebuild(float x, float z)
        {
            _sea.Extent = new Vector2(x, z);
            _sea.Rebuild();
        }

        MeshRenderer[] Tiles() =>
            _sea.GetComponentsInChildren<MeshRenderer>().Where(tile => tile.enabled).ToArray();

        int Triangles() => _scene.Gather(_gatherer).Instances.Sum(instance => instance.Mesh.TriangleCount);

        void AddSnapshots()
        {
            for (int seed = 1; seed <= 2; seed++)
            {
                // A prefab, which is not part of the scene.
                var snapshot = new GameObject("Snapshot").AddComponent<SeaSnapshot>();
                snapshot.transform.SetParent(_scene.Root);
                var tile = new SeaSurface(Settings(seed)).Mesh(0);
                snapshot.Set(MeshMaker.Make("Tile", tile.Vertices, tile.Indices), Settings(seed), 0, 0);
                _sea.Snapshots.Add(snapshot);
            }
        }

        // Sorted by position in the plane.
        Dictionary<double2, double> Heights() =>
            SceneBuilder.Corners(_scene.Gather(_gatherer)).GroupBy(p => p.xz)
                .ToDictionary(group => group.Key, group => group.First().y);

        static double Area(double3[] corners)
        {
            double sum = 0;
            for (int i = 0; i < corners.Length; i += 3)
            {
                double2 a = corners[i + 1].xz - corners[i].xz, b = corners[i + 2].xz - corners[i].xz;
                sum += (a.y * b.x - a.x * b.y) / 2;
            }
            return sum;
        }
    }
}
