using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Tests
{
    /// <summary>
    /// Hits name the object that reflects, whether objects are merged, move independently or share a mesh.
    /// </summary>
    public sealed class HitObjectTests
    {
        // Plates of 2 m, 4 m apart: a ray's column gives its plate.
        const int Plates = 5;
        const float Apart = 4, Depth = 60;

        readonly List<Transform> _plates = new List<Transform>();
        RadarController _radar;

        [SetUp]
        public void MakeScene()
        {
            var mesh = new Mesh
            {
                name = "Plate", vertices = new[]
            {
                new Vector3(-1, -1, 0), new Vector3(-1, 1, 0), new Vector3(1, 1, 0), new Vector3(1, -1, 0)
            }, triangles = new[] { 0, 1, 2, 0, 2, 3 }
            };
            var row = new GameObject("Row").transform;
            for (int i = 0; i < Plates; i++)
            {
                var plate = new GameObject($"Plate {i}", typeof(MeshFilter), typeof(MeshRenderer)).transform;
                plate.SetParent(row, false);
                plate.localPosition = new Vector3(Apart * (i - Plates / 2), 0, Depth);
                plate.GetComponent<MeshFilter>().sharedMesh = mesh;
                _plates.Add(plate);
            }
            var camera = new GameObject("Radar", typeof(Camera));
            camera.GetComponent<Camera>().fieldOfView = 10;
            _radar = camera.AddComponent<RadarController>();
            _radar.Kernel = TestKernels.Trace;
            _radar.Receiver = new GameObject("Receiver").transform;
            _radar.Receiver.SetParent(camera.transform, false);
            _radar.Receiver.localPosition = new Vector3(0, 0, -0.2f);
            _radar.Settings = TestRadar.Settings(160, 90);
            _radar.Roots.Add(row);
        }

        [TearDown]
        public void RemoveScene()
        {
            Object.DestroyImmediate(_radar.gameObject);
            Object.DestroyImmediate(_plates[0].parent.gameObject);
            _plates.Clear();
        }

        [Test]
        public void TracePaths_PlatesMerged_NamesThePlateOfEachColumn()
        {
            Assert.That(_radar.Gather().Scene.Instances, Has.Length.EqualTo(1), "merged");
            AssertEachColumnHasItsPlate();
        }

        [Test]
        public void TracePaths_OnePlateMoves_NamesThePlateOfEachColumn()
        {
            _radar.ExpectMotion(_plates[3]);
            _radar.Trace();
            _plates[3].localPosition += new Vector3(0, 0.5f, 0);
            AssertEachColumnHasItsPlate();
            Assert.That(_radar.Gather().Scene.Instances, Has.Length.EqualTo(2), "one apart");
        }

        [Test]
        public void TracePaths_PlateGone_NumbersAreThoseOfNow()
        {
            AssertEachColumnHasItsPlate();
            _plates[1].gameObject.SetActive(false);
            AssertEachColumnHasItsPlate();
        }

        [Test]
        public void TracePaths_SurfacesOfAMergedMesh_AreInheritedAndGivenToSubmeshes()
        {
            RadarMaterial Material(string name)
            {
                var material = ScriptableObject.CreateInstance<RadarMaterial>();
                material.name = name;
                return material;
            }
            void Give(Transform item, string name, int submesh = RadarSurface.AllSubmeshes)
            {
                var surface = item.gameObject.AddComponent<RadarSurface>();
                (surface.Material, surface.Submesh) = (Material(name), submesh);
            }
            Give(_plates[0].parent, "steel");
            Give(_plates[1], "sea");
            var filter = _plates[2].GetComponent<MeshFilter>();
            var halves = Object.Instantiate(filter.sharedMesh);
            halves.subMeshCount = 2;
            halves.SetIndices(new[] { 0, 1, 2 }, MeshTopology.Triangles, 0);
            halves.SetIndices(new[] { 0, 2, 3 }, MeshTopology.Triangles, 1);
            filter.sharedMesh = halves;
            Give(_plates[2], "wood", 1);
            _plates[3].gameObject.AddComponent<RadarSurface>(); // without a material: a perfect conductor

            var pose = _radar.Gather();
            Assert.That(pose.Scene.Instances, Has.Length.EqualTo(1), "merged");
            Assert.That(pose.Scene.Surfaces[0], Is.SameAs(SurfaceMaterial.PerfectConductor));
            var paths = _radar.TracePaths(Enumerable.Range(0, (int)pose.Settings.RayCount)
                .Select(pixel => (uint)pixel).ToArray());
            var reference = new ReferenceTracer(pose);
            var seen = new Dictionary<string, int>();
            foreach (var path in paths.Where(path => path.Bounces > 0))
            {
                var hit = path.Hits[0];
                int plate = _plates.IndexOf(_radar.ObjectAt(hit.Object));
                // The triangles of the halved plate share its diagonal from the lower left to the upper right.
                bool isBelow = hit.Position.y < hit.Position.x;
                string expected = plate == 1 ? "sea" : plate == 2 && isBelow ? "wood"
                    : plate == 3 ? "perfect conductor" : "steel";
                string found = pose.Scene.Surfaces[hit.Surface].Name;
                if (plate == 2 && math.abs(hit.Position.y - hit.Position.x) < 1e-4)
                    continue; // either object on the diagonal
                Assert.That(found, Is.EqualTo(expected), $"plate {plate} at {hit.Position}");
                seen[found] = seen.TryGetValue(found, out int count) ? count + 1 : 1;
                var ray = reference.Trace(path.Pixel % pose.Settings.RaysAcross, path.Pixel / pose.Settings.RaysAcross);
                if (path.Bounces == 1)
                    Assert.That((ray.LastObject, ray.LastSurface), Is.EqualTo((hit.Object, hit.Surface)));
            }
            Assert.That(seen.Keys, Is.EquivalentTo(new[] { "steel", "sea", "wood", "perfect conductor" }));
            Assert.That(seen["steel"], Is.EqualTo(5 * seen["wood"]).Within(seen["wood"]));
        }

        [Test]
        public void TracePreview_ShowsThePartThatMeetsAnything()
        {
            var preview = _radar.TracePreview();
            Assert.That(preview.Objects().Select(number => _radar.ObjectAt(number)), Is.EqualTo(_plates));
            // The plates cover 18 of the view's 18.7 m across, and about a tenth of its height.
            Assert.That((double)preview.Part.Width / preview.RaysAcross, Is.GreaterThan(0.95));
            Assert.That((double)preview.Part.Height / preview.RaysDown, Is.InRange(0.19, 0.4));
            int seen = 0, received = 0;
            for (int y = 0; y < preview.Part.Height; y++)
                for (int x = 0; x < preview.Part.Width; x++)
                {
                    if (preview.Bounces(x, y) == 0)
                    {
                        Assert.That(preview.Object(x, y), Is.EqualTo(MeshRange.NoObject));
                        continue;
                    }
                    seen++;
                    received += preview.IsReceived(x, y) ? 1 : 0;
                    Assert.That(preview.Facing(x, y), Is.GreaterThan(math.cos(math.radians(12))), "head-on");
                    Assert.That(_radar.ObjectAt(preview.Object(x, y)),
                        Is.EqualTo(PlateAt((preview.Part.Left + x + 0.5) / preview.RaysAcross)));
                }
            // Five plates of 4 m2 in a view of 10.5 x 18.66 m.
            double height = 2 * Depth * math.tan(math.radians(5)), share = Plates * 4 / (height * height * 16 / 9);
            Assert.That(seen, Is.EqualTo(share * preview.RaysAcross * preview.RaysDown).Within(0.03 * seen));
            // A ray returns at twice its offset, so the 3 m receiver takes rays within 0.75 m of the centre.
            Assert.That(received, Is.EqualTo(1.5 * 1.5 / (Plates * 4) * seen).Within(0.1 * received));
        }

        void AssertEachColumnHasItsPlate()
        {
            var settings = _radar.Settings;
            var pixels = Enumerable.Range(0, settings.RaysAcross)
                .Select(x => (uint)(x + settings.RaysDown / 2 * settings.RaysAcross)).ToArray();
            var paths = _radar.TracePaths(pixels);
            for (int x = 0; x < paths.Length; x++)
            {
                var expected = PlateAt((x + 0.5) / settings.RaysAcross);
                var met = paths[x].Bounces == 0 ? null : _radar.ObjectAt(paths[x].Hits[0].Object);
                Assert.That(met, Is.EqualTo(expected), $"column {x}");
            }
            Assert.That(paths.Count(path => path.Bounces > 0), Is.GreaterThan(60));
        }

        // Object at a share of the picture's width; null between the plates.
        Transform PlateAt(double share)
        {
            double x = (2 * share - 1) * Depth * math.tan(math.radians(5)) * 16 / 9;
            var plate = _plates[math.clamp((int)math.round(x / Apart) + Plates / 2, 0, Plates - 1)];
            return plate.gameObject.activeSelf && math.abs(x - plate.localPosition.x) <= 1 ? plate : null;
        }
    }
}
