using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Glint.Tests
{
    /// <summary>
    /// The lines that Ray Paths draws of a radar before two walls at a right angle, and a plate beside them.
    /// </summary>
    public sealed class RayPathsTests
    {
        const float Side = 4;

        GameObject _camera;
        Transform _root, _floor, _wall, _plate;
        RadarController _radar;
        RayPaths _paths;

        [SetUp]
        public void MakeScene()
        {
            _root = new GameObject("Root").transform;
            _floor =
                Plate("Floor", new Vector3(-Side / 2, 0, 40 - Side), new Vector3(Side, 0, 0), new Vector3(0, 0, Side));
            _wall = Plate("Wall", new Vector3(-Side / 2, 0, 40), new Vector3(Side, 0, 0), new Vector3(0, Side, 0));
            _plate = Plate("Plate", new Vector3(4, 2, 40), new Vector3(1, 0, 0), new Vector3(0, 1, 0));
            _camera = new GameObject("Radar", typeof(Camera));
            _camera.transform.SetParent(_root, false);
            _camera.transform.localPosition = new Vector3(0, 12, 0);
            _camera.transform.localRotation = Quaternion.LookRotation(new Vector3(0, -11, 39));
            _camera.GetComponent<Camera>().fieldOfView = 12;
            _radar = _camera.AddComponent<RadarController>();
            _radar.Kernel = TestKernels.Trace;
            _radar.Receiver = new GameObject("Receiver").transform;
            _radar.Receiver.SetParent(_camera.transform, false);
            _radar.Receiver.localPosition = new Vector3(0, 0, -0.2f);
            _radar.Settings = TestRadar.Settings();
            _radar.Roots.AddRange(new[] { _floor, _wall, _plate });
            _paths = _camera.AddComponent<RayPaths>();
        }

        [TearDown]
        public void RemoveScene() => Object.DestroyImmediate(_root.gameObject);

        [Test]
        public void Lines_BeforeAPose_AreNone()
        {
            Assert.That(_paths.Lines(), Is.Null);
            Assert.That(_paths.Count, Is.Zero);
        }

        [Test]
        public void Lines_OfReceivedRays_AreSegmentsInTheirColoursFromRadarToReceiver()
        {
            var result = _radar.Trace();
            var mesh = _paths.Lines();
            Assert.That(mesh.GetTopology(0), Is.EqualTo(MeshTopology.Lines));
            Assert.That(_paths.Count, Is.EqualTo(result.RaysReceived).And.GreaterThan(200));
            var lines = Lines(mesh);
            Assert.That(Of(lines, PathLines.White).Sum(line => line.Length), Is.EqualTo(12).Within(1e-4),
                "around the receiver of 3 x 3 m");
            // Only the right angle returns rays: two bounces, three segments.
            var (first, second, third) =
                (Of(lines, Color.red), Of(lines, PathLines.SegmentColours[1]), Of(lines, PathLines.SegmentColours[2]));
            Assert.That(new[] { first.Count, second.Count, third.Count }, Is.All.EqualTo(_paths.Count));
            Assert.That(Of(lines, PathLines.SegmentColours[3]), Is.Empty);
            double lengths = result.Rays.Sum(ray => ray.RefinedPathLength);
            Assert.That(first.Concat(second).Concat(third).Sum(line => line.Length),
                Is.EqualTo(lengths).Within(1e-6 * lengths));
            for (int i = 0; i < first.Count; i++)
                Assert.That((first[i].To, second[i].To),
                    Is.EqualTo((second[i].From, third[i].From)), "one after the other");
            Assert.That(first.Select(line => line.From).Distinct().Count(), Is.EqualTo(1), "from the radar");
        }

        // Ray tubes keep no rays: those of one a pixel are shown.
        [Test]
        public void Lines_OfAPoseWithATolerance_AreThoseOfOneWithout()
        {
            var rays = _radar.Trace();
            _paths.Lines();
            int count = _paths.Count;
            var settings = _radar.Settings;
            settings.ToleranceDb = 1;
            (_radar.Settings, _radar.TubeKernel) = (settings, TestKernels.Amplitude);
            var tubes = _radar.Trace();
            _paths.Lines();
            Assert.That((_paths.Count, _paths.IsOutdated), Is.EqualTo((count, false)));
            Assert.That(_radar.ReceivedPixels().Length,
                Is.EqualTo(rays.RaysReceived).And.Not.EqualTo(tubes.RaysReceived));
            Assert.That(_radar.Result, Is.SameAs(tubes));
            _plate.position += Vector3.up;
            _paths.ReceivedOnly = false;
            _paths.Lines();
            Assert.That(_paths.IsOutdated);
        }

        [Test]
        public void Lines_OfAllRays_AreOfThoseThatMeetTheObjectSoOften()
        {
            _radar.Trace(RayReadback.None);
            _paths.ReceivedOnly = false;
            _paths.Lines();
            int all = _paths.Count;
            Assert.That(all, Is.EqualTo(_radar.Result.RaysHit).Within(1));
            _paths.MinBounces = 2;
            _paths.Lines();
            int twice = _paths.Count;
            Assert.That(twice, Is.EqualTo(_radar.Result.Bounces - _radar.Result.RaysHit).Within(1),
                "none bounces three times");
            _paths.MinBounces = 1;
            _paths.MaxBounces = 1;
            _paths.Lines();
            Assert.That(_paths.Count, Is.EqualTo(all - twice));
            _paths.MaxBounces = RadarSettings.BounceLimit;

            _paths.Meeting = _plate;
            var red = Of(Lines(_paths.Lines()), PathLines.SegmentColours[0]);
            Assert.That(_paths.Count, Is.EqualTo(red.Count).And.InRange(1, all / 4));
            int plate = _paths.Count;
            _paths.Meeting = _wall;
            _paths.Lines();
            int wall = _paths.Count;
            _paths.Meeting = _floor;
            _paths.Lines();
            Assert.That(_paths.Count + wall - twice + plate, Is.EqualTo(all), "what meets both is counted twice");
            _paths.Meeting = _root;
            _paths.Lines();
            Assert.That(_paths.Count, Is.EqualTo(all));
        }

        [Test]
        public void Lines_OfEveryThirdRay_AreAThirdOfThem()
        {
            _radar.Trace();
            _paths.Lines();
            int all = _paths.Count;
            _paths.Every = 3;
            _paths.HitPoints = true;
            var lines = Lines(_paths.Lines());
            Assert.That(_paths.Count, Is.EqualTo(all / 3));
            Assert.That(Of(lines, PathLines.White).Count, Is.EqualTo(4 + 3 * 2 * _paths.Count),
                "a cross at each of two bounces");
            Assert.That(_paths.LeftOut, Is.Zero);
        }

        [Test]
        public void Lines_OfMoreRaysThanAreFollowed_AreTakenEvenlyInOneMesh()
        {
            _radar.Settings = TestRadar.Settings(640, 360);
            _radar.Trace(RayReadback.None);
            _paths.ReceivedOnly = false;
            var mesh = _paths.Lines();
            Assert.That(_paths.LeftOut, Is.EqualTo(640 * 360 - RayPaths.MaxRays));
            Assert.That(_paths.Count, Is.EqualTo(_radar.Result.RaysHit * RayPaths.MaxRays / (640.0 * 360))
                .Within(0.02 * _paths.Count).And.GreaterThan(5000));
            Assert.That(mesh.subMeshCount, Is.EqualTo(1));
        }

        [Test]
        public void Lines_ThatCannotBeTraced_AreGone()
        {
            _radar.Trace();
            Assert.That(_paths.Lines().vertexCount, Is.GreaterThan(0));
            var mesh = _paths.Lines();
            _radar.Receiver = null;
            _paths.Every = 2;
            LogAssert.Expect(LogType.Warning, new Regex("Ray Paths of 'Radar': .*has no receiver"));
            Camera.onPreCull(_camera.GetComponent<Camera>());
            Assert.That((_paths.Count, mesh.vertexCount), Is.EqualTo((0, 8)), "the receiver alone");
        }

        // Ray Paths that are shown after the receiver of the radar has gone.
        [Test]
        public void Lines_WhoseFirstPoseCannotBeTraced_AreNone()
        {
            _radar.Trace();
            _radar.Receiver = null;
            LogAssert.Expect(LogType.Warning, new Regex("Ray Paths of 'Radar': .*has no receiver"));
            for (int frame = 0; frame < 2; frame++)
                Assert.That(() => Camera.onPreCull(_camera.GetComponent<Camera>()), Throws.Nothing);
            Assert.That(_paths.Count, Is.Zero);
        }

        [Test]
        public void Lines_AfterAnotherPose_AreThoseOfThatPose()
        {
            _radar.Trace();
            int before = _paths.Lines().vertexCount;
            _wall.localRotation = Quaternion.Euler(0, 20, 0);
            Assert.That(_paths.Lines().vertexCount, Is.EqualTo(before), "not before it is traced");
            _radar.Trace();
            Assert.That(_paths.Lines().vertexCount, Is.LessThan(before));
            Assert.That(_paths.Count, Is.EqualTo(_radar.Result.RaysReceived));
        }

        [Test]
        public void Bounces_ChosenWhenTheSceneHasMovedOn_AreOfThePoseAndTraceNothing()
        {
            _radar.Trace();
            _paths.ReceivedOnly = false;
            _paths.Lines();
            int all = _paths.Count;
            _wall.localRotation = Quaternion.Euler(0, 20, 0);
            _paths.MinBounces = 2;
            _paths.Lines();
            Assert.That(_paths.Count, Is.EqualTo(_radar.Result.Bounces - _radar.Result.RaysHit).Within(1));
            // Set as by the inspector.
            Set("_fewestBounces", 1);
            Set("_hitPoints", true);
            _paths.Lines();
            Assert.That(_paths.Count, Is.EqualTo(all));
            Assert.That(_paths.IsOutdated, Is.False);
            Set("_every", 2);
            _paths.Lines();
            Assert.That(_paths.IsOutdated, Is.True, "other rays, to be traced");
        }

        [Test]
        public void Lines_OfOtherRaysAfterASweep_AreNoneUntilTheSceneIsThatOfThePoseAgain()
        {
            using (var sweep =
                new SweepRun(new SweepSetup(_radar, new SweepPlan(new double[] { 5, 0.5 })) { Target = _wall }))
                while (!sweep.IsComplete)
                    sweep.Step();
            var turn = Quaternion.Euler(0, 0.5f, 0);
            _wall.localRotation = turn;
            _paths.Lines();
            int received = _paths.Count;
            Assert.That(received, Is.EqualTo(_radar.Result.RaysReceived).And.GreaterThan(100),
                "as the last pose had it");

            _wall.localRotation = Quaternion.identity; // as reset by the sweep
            _paths.HitPoints = true;
            _paths.Lines();
            Assert.That(_paths.Count, Is.EqualTo(received), "only drawn otherwise");
            _paths.Every = 2;
            var lines = Lines(_paths.Lines());
            Assert.That((_paths.Count, _paths.LeftOut, lines.Count), Is.EqualTo((0, 0, 4)), "the receiver");
            Assert.That(_paths.IsOutdated, Is.True);

            _radar.Release();
            _wall.localRotation = turn;
            _paths.Every = 1;
            _paths.Lines();
            Assert.That(_paths.Count, Is.EqualTo(received), "also of a radar that was released");
            Assert.That(_paths.IsOutdated, Is.False);
        }

        [TestCase("another mesh")]
        [TestCase("a mesh that changed")]
        [TestCase("an object less")]
        [TestCase("another place of the radar")]
        [TestCase("another field of view")]
        [TestCase("more rays")]
        public void Lines_OfOtherRaysAfterAChange_AreNone(string change)
        {
            _radar.Trace();
            _paths.Lines();
            var filter = _plate.GetComponent<MeshFilter>();
            switch (change)
            {
                case "another mesh": filter.sharedMesh = _floor.GetComponent<MeshFilter>().sharedMesh; break;
                case "a mesh that changed":
                    filter.sharedMesh.vertices =
                    filter.sharedMesh.vertices.Select(position => position + Vector3.right).ToArray(); break;
                case "an object less": _plate.gameObject.SetActive(false); break;
                case "another place of the radar": _camera.transform.localPosition += Vector3.up; break;
                case "another field of view": _camera.GetComponent<Camera>().fieldOfView = 11; break;
                case "more rays": _radar.Settings = TestRadar.Settings(320, 180); break;
            }
            _paths.ReceivedOnly = false;
            _paths.Lines();
            Assert.That((_paths.Count, _paths.IsOutdated), Is.EqualTo((0, true)));
            _radar.Trace();
            _paths.Lines();
            Assert.That(_paths.Count, Is.GreaterThan(200));
            Assert.That(_paths.IsOutdated, Is.False);
        }

        [Test]
        public void Lines_SceneFarFromTheOrigin_AreTheSame()
        {
            _radar.Trace();
            var near = _paths.Lines().vertices;
            _root.position = new Vector3(1e6f, 0, 1e6f);
            _radar.Trace();
            Assert.That(_paths.Lines().vertices, Is.EqualTo(near));
        }

        void Set(string field, object value)
        {
            const BindingFlags Private = BindingFlags.Instance | BindingFlags.NonPublic;
            typeof(RayPaths).GetField(field, Private).SetValue(_paths, value);
            typeof(RayPaths).GetMethod("OnValidate", Private).Invoke(_paths, null);
        }

        Transform Plate(string name, Vector3 corner, Vector3 edge1, Vector3 edge2)
        {
            var plate = new GameObject(name, typeof(MeshFilter), typeof(MeshRenderer)).transform;
            plate.SetParent(_root, false);
            plate.GetComponent<MeshFilter>().sharedMesh = new Mesh
            {
                vertices = new[] { corner, corner + edge1, corner + edge1 + edge2, corner + edge2 },
                triangles = new[] { 0, 1, 2, 0, 2, 3 }
            };
            return plate;
        }

        static List<(Vector3 From, Vector3 To, double Length, Color32 Colour)> Lines(Mesh mesh)
        {
            var (positions, colours, indices) = (mesh.vertices, mesh.colors32, mesh.GetIndices(0));
            return Enumerable.Range(0, indices.Length / 2).Select(i =>
                (positions[indices[2 * i]], positions[indices[2 * i + 1]],
                    math.distance((double3)(float3)positions[indices[2 * i]], (float3)positions[indices[2 * i + 1]]),
                    colours[indices[2 * i]])).ToList();
        }

        static List<(Vector3 From, Vector3 To, double Length, Color32 Colour)> Of(
            List<(Vector3 From, Vector3 To, double Length, Color32 Colour)> lines, Color32 colour) =>
            lines.Where(line => line.Colour.Equals(colour)).ToList();
    }
}
