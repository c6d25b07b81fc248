using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Tests
{
    /// <summary>
    /// A change of a mesh is in the next row, and a row without a change hashes no mesh before it traces.
    /// </summary>
    public sealed class MeshWatchTests
    {
        // The radar's axis runs along Z. The tent's top is on an axis beside it.
        const float Distance = 20, Side = 0.5f;

        // Seven vertices and five triangles.
        const long TentBytes = 7 * 12 + 15 * 4;

        Transform _root;
        RadarController _radar;

        [SetUp]
        public void MakeRadar()
        {
            _root = new GameObject("Root").transform;
            var camera = Child("Radar").gameObject;
            camera.AddComponent<Camera>().fieldOfView = 20;
            _radar = camera.AddComponent<RadarController>();
            _radar.Kernel = TestKernels.Trace;
            _radar.Receiver = Child("Receiver");
            _radar.Receiver.localPosition = new Vector3(500, 0, 0); // no ray returns there
            _radar.Roots.Add(_root);
            // One ray, along the axis, to its first hit.
            _radar.Settings = TestRadar.Settings(1, 1, 1);
            _radar.RayReadback = RayReadback.None;
        }

        [TearDown]
        public void RemoveScene() => Object.DestroyImmediate(_root.gameObject);

        [Test]
        public void Trace_MeshMadeAtRunTime_IsHashedBesideAndItsMovedVertexIsInTheNextRow()
        {
            var mesh = RunTimeTent();
            Show(mesh);
            Assert.That(Hashed(_radar.Trace()), Is.EqualTo((TentBytes, 0L)), "read for the first pose");
            var second = _radar.Trace();
            Assert.That(Hashed(second), Is.EqualTo((0L, TentBytes)));
            AssertTop(second, 0);

            MoveTop(mesh, 0.4f);
            var third = _radar.Trace();
            AssertTop(third, 0.4f);
            Assert.That(Hashed(third), Is.EqualTo((TentBytes, TentBytes)), "traced again, of what it then read");
            Assert.That(_radar.Result, Is.SameAs(third));
            Assert.That(_radar.IsAsTraced(_radar.Gather()));
        }

        [Test]
        public void Gather_ForOtherWorkThanARow_SeesAMovedVertexAtOnce()
        {
            var mesh = RunTimeTent();
            Show(mesh);
            _radar.Trace();
            MoveTop(mesh, 0.4f);
            var corners = SceneBuilder.Corners(_radar.Gather().Scene);
            Assert.That(corners.Any(corner => math.abs(corner.z - (Distance - 0.4f)) < 1e-5));
        }

        [Test]
        public void Trace_MeshThatChangesDuringATrace_ShowsInTheNext()
        {
            var mesh = RunTimeTent();
            Show(mesh);
            _radar.Trace();
            int reports = 0;
            _radar.Trace(new OnReport(() => MoveTop(mesh, 0.1f * (1 + reports++ % 5))));
            Assert.That(reports, Is.GreaterThan(0));
            AssertTop(_radar.Trace(), 0.1f * (1 + (reports - 1) % 5));
        }

        [Test]
        public void Trace_MeshFileChangedByAScript_IsReadWhenItsBoundsChangeOrItIsMarked()
        {
            var mesh = MeshFileScene.MakeObject(new MeshFile("Tent", Vertices(0), Indices)).GetComponent<MeshFilter>();
            mesh.transform.SetParent(_root, false);
            mesh.transform.localPosition = new Vector3(Side, 0, Distance);
            _radar.Trace();
            var second = _radar.Trace();
            Assert.That(Hashed(second), Is.EqualTo((0L, 0L)));
            AssertTop(second, 0);

            MoveTop(mesh.sharedMesh, 0.4f);
            AssertTop(_radar.Trace(), 0); // its maker said nothing
            RadarController.MarkChanged(mesh.sharedMesh);
            var marked = _radar.Trace();
            AssertTop(marked, 0.4f);
            Assert.That(Hashed(marked), Is.EqualTo((TentBytes, 0L)));

            MoveTop(mesh.sharedMesh, 3);
            mesh.sharedMesh.RecalculateBounds();
            AssertTop(_radar.Trace(), 3);
            MeshMaker.Fill(mesh.sharedMesh, Vertices(0.2f), Indices);
            AssertTop(_radar.Trace(), 0.2f);
        }

        [Test]
        public void Trace_Declared_HashesNothingUntilTheMeshIsMarked()
        {
            var mesh = RunTimeTent();
            Show(mesh);
            _radar.MeshChanges = MeshChanges.Declared;
            _radar.Trace();
            MoveTop(mesh, 0.4f);
            var unmarked = _radar.Trace();
            Assert.That(Hashed(unmarked), Is.EqualTo((0L, 0L)));
            AssertTop(unmarked, 0);

            RadarController.MarkChanged(mesh);
            AssertTop(_radar.Trace(), 0.4f);
            MoveTop(mesh, 0.3f);
            _radar.MeshChanges = MeshChanges.Watched;
            AssertTop(_radar.Trace(), 0.3f);
        }

        [Test]
        public void Trace_StoredMeshInEditMode_IsHashedAgainWhenItIsMarkedDirty()
        {
            var ship = AssetDatabase.LoadAssetAtPath<Mesh>("Packages/com.glint.meshes/Ship/Ship.asset");
            LookAtShip(Show(ship));
            var stored = ship.vertices;
            try
            {
                AssertNextRowShows(() =>
                {
                    ship.vertices = Array.ConvertAll(stored, vertex => vertex + new Vector3(0, 0, 0.001f * vertex.y));
                    EditorUtility.SetDirty(ship);
                });
            }
            finally
            {
                ship.vertices = stored;
                EditorUtility.ClearDirty(ship);
            }
        }

        [Test]
        public void Trace_ShipMadeByOtherMeasures_IsSeen()
        {
            var ship = Child("Ship").gameObject.AddComponent<Ship>();
            ship.GetComponent<MeshFilter>().sharedMesh = ShipFigures.Make(ship.Settings);
            LookAtShip(ship.transform);
            AssertNextRowShows(() =>
            {
                var longer = ship.Settings;
                longer.Length += 3;
                ship.Settings = longer;
                ShipFigures.Remake(ship).Apply();
            });
        }

        [Test]
        public void Trace_SeaAtAnotherTime_IsSeen()
        {
            var sea = Child("Sea").gameObject.AddComponent<Sea>();
            var waves = SeaSettings.Default;
            (waves.TileSize, waves.Cells) = (32, 16);
            sea.Extent = new Vector2(32, 32);
            sea.Waves = waves;
            _radar.transform.localPosition = new Vector3(0, 30, -30);
            _radar.transform.localRotation = Quaternion.Euler(45, 0, 0);
            _radar.Settings = TestRadar.Settings();
            AssertNextRowShows(() => sea.TimeSeconds += 1);
        }

        [Test]
        public void ConfirmMeshes_TwoThatChanged_AreBothReadByTheNextGather()
        {
            Mesh one = RunTimeTent(), other = RunTimeTent();
            Show(one);
            Show(other).localPosition += new Vector3(10, 0, 0);
            var gatherer = new SceneGatherer();
            var roots = new List<Transform> { _root };
            gatherer.Gather(~0, roots, null);
            MoveTop(one, 0.4f);
            MoveTop(other, 0.3f);
            gatherer.Gather(~0, roots, null, null, confirmLater: true);
            Assert.That(gatherer.ConfirmMeshes(), Is.False);
            var scene = gatherer.Gather(~0, roots, null, null, confirmLater: true);
            Assert.That(gatherer.ConfirmMeshes());
            var depths = SceneBuilder.Corners(scene).Select(corner => Math.Round(Distance - corner.z, 4)).ToArray();
            Assert.That(depths, Has.Member(0.4).And.Member(0.3));
        }

        [Test]
        public void MarkChanged_WithoutAMesh_SaysSo()
        {
            Assert.That(Assert.Throws<GlintException>(() => RadarController.MarkChanged(null)).Message,
                Does.Contain("MarkChanged").And.Contain("mesh"));
        }

        // A second pose that hashes nothing; then a row that equals that of a radar that knows nothing of before.
        void AssertNextRowShows(Action change)
        {
            _radar.Trace();
            var before = _radar.Trace();
            Assert.That(Hashed(before), Is.EqualTo((0L, 0L)));
            Assert.That(before.RaysHit, Is.GreaterThan(100));
            change();
            var after = _radar.Trace();
            _radar.Release();
            var fresh = _radar.Trace();
            Assert.That(after.PathLengthMeters, Is.Not.EqualTo(before.PathLengthMeters));
            Assert.That((after.RaysHit, after.Bounces), Is.EqualTo((fresh.RaysHit, fresh.Bounces)));
            // A mesh that has changed is placed in another frame, which rounds otherwise.
            Assert.That(after.PathLengthMeters, Is.EqualTo(fresh.PathLengthMeters).Within(1e-6 * fresh.RaysHit));
        }

        void LookAtShip(Transform ship)
        {
            ship.localPosition = new Vector3(0, -3, 80);
            ship.localRotation = Quaternion.Euler(0, 90, 0);
            _radar.Settings = TestRadar.Settings();
        }

        Transform Child(string name)
        {
            var child = new GameObject(name).transform;
            child.SetParent(_root, false);
            return child;
        }

        Transform Show(Mesh mesh)
        {
            var shown = Child(mesh.name);
            shown.gameObject.AddComponent<MeshFilter>().sharedMesh = mesh;
            shown.gameObject.AddComponent<MeshRenderer>();
            shown.localPosition = new Vector3(Side, 0, Distance);
            return shown;
        }

        // A square of 4 m with a top in its middle, and a wing beside it, so that the top stays within the bounds.
        static float3[] Vertices(float top) => new[]
        {
            new float3(0, 0, -top), new float3(-2, -2, 0), new float3(-2, 2, 0), new float3(2, 2, 0),
            new float3(2, -2, 0), new float3(3, 0, -1), new float3(3, 1, -1)
        };

        static readonly int[] Indices = { 0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1, 3, 5, 6 };

        static Mesh RunTimeTent() => new Mesh
        {
            name = "Tent", vertices = Array.ConvertAll(Vertices(0), v => (Vector3)v), triangles = Indices
        };

        static void MoveTop(Mesh mesh, float top)
        {
            var vertices = mesh.vertices;
            vertices[0].z = -top;
            mesh.vertices = vertices;
        }

        // The ray meets the facet a quarter of the way from the top to the edge 2 m away.
        static void AssertTop(RadarResult result, float top)
        {
            Assert.That(result.RaysHit, Is.EqualTo(1));
            Assert.That(result.PathLengthMeters, Is.EqualTo(Distance - (1 - Side / 2) * top).Within(1e-4));
        }

        static (long, long) Hashed(RadarResult result) =>
            (result.Statistics.BytesHashed, result.Statistics.BytesHashedBeside);

        sealed class OnReport : IProgress<double>
        {
            readonly Action _work;

            public OnReport(Action work) => _work = work;

            public void Report(double value) => _work();
        }
    }
}
