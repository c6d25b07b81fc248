using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>
    /// The frame of a scene has the world's axes and metres. Its origin is the nearest common ancestor of radar,
    /// receiver and all traced objects. The origin's own position does not affect the result.
    /// </summary>
    public sealed class SceneFrameTests : GathererFixture
    {
        // Arbitrary coordinates; the step of float32 is 1/16 m there.
        static readonly Vector3 Far = new Vector3(1000003.3f, -999985.9f, 777777.1f);

        Transform _radar, _receiver, _ship;

        [SetUp]
        public void FillScene()
        {
            _scene.Root.localRotation = Quaternion.Euler(12, 200, -31);
            _scene.Root.localScale = new Vector3(1.25f, -0.8f, 1.1f);
            var mount = _scene.Empty("Mount");
            mount.localPosition = new Vector3(-40.1f, 3.7f, 5.3f);
            mount.localRotation = Quaternion.Euler(-7, 33, 4);
            mount.localScale = new Vector3(0.5f, 0.7f, 0.6f);
            _radar = Child("Radar", mount, new Vector3(0.3f, 0.1f, -0.7f), Quaternion.Euler(3, 88, 2));
            _receiver = Child("Receiver", _radar, new Vector3(0, 0, -0.2f), Quaternion.Euler(0.5f, 0, 0));
            _ship = _scene.Add("Hull", SceneBuilder.Mesh(10, 1));
            _ship.localRotation = Quaternion.Euler(2, 47, 1);
            _scene.Add("Mast", SceneBuilder.Mesh(10, 2), _ship).localPosition = new Vector3(0.1f, 2.3f, 0.7f);
            _scene.Add("Rock", SceneBuilder.Mesh(10, 3)).localPosition = new Vector3(-5.1f, 0.3f, 0.9f);
            _scene.Add("Cliff", SceneBuilder.Mesh(10, 4)).localPosition = new Vector3(493.3f, 0.7f, 5.9f);
        }

        [Test]
        public void Gather_CommonRootMovedBy1000Kilometres_IsTheSameBitForBit([Values] bool shipMoves,
            [Values(1f, 1e-5f)] float squeeze)
        {
            // No transform below so strong a compression can be a frame for merged meshes.
            var outer = new GameObject("Outer").transform;
            outer.localScale = new Vector3(1, 1, squeeze);
            _scene.Root.SetParent(outer, false);
            try
            {
                var near = Gather(new SceneGatherer(), shipMoves);
                outer.localPosition = Far;
                _scene.Root.localPosition = new Vector3(-0.3f, 0.1f, 12345.6f);
                var far = Gather(new SceneGatherer(), shipMoves);
                Assert.That(far.instances.Length, Is.EqualTo(near.instances.Length).And.GreaterThan(0));
                for (int i = 0; i < far.instances.Length; i++)
                {
                    Assert.That(far.instances[i].ToWorld, Is.EqualTo(near.instances[i].ToWorld));
                    Assert.That(far.instances[i].Mesh.Vertices, Is.EqualTo(near.instances[i].Mesh.Vertices));
                    Assert.That(far.instances[i].Mesh.Indices, Is.EqualTo(near.instances[i].Mesh.Indices));
                }
                Assert.That((far.radar, far.receiver), Is.EqualTo((near.radar, near.receiver)));
                Assert.That(distance(far.origin, SceneBuilder.ToWorld(_scene.Root, 0)), Is.LessThan(1e-9));
                Assert.That(near.origin, Is.EqualTo(new double3(0)));
            }
            finally
            {
                _scene.Root.SetParent(null, false);
                Object.DestroyImmediate(outer.gameObject);
            }
        }

        [Test]
        public void Gather_AfterTheCommonRootMovedAndTurned_BuildsNothingAnew()
        {
            _gatherer.ExpectMotion(_ship);
            var before = Gather(_gatherer, false);
            for (int i = 0; i < 3; i++)
            {
                _scene.Root.localPosition += new Vector3(100.1f, 0.3f, -700000.7f);
                var moved = Gather(_gatherer, false);
                Assert.That(moved.instances, Is.EqualTo(before.instances), "only the origin is another");
                Assert.That(distance(moved.origin, SceneBuilder.ToWorld(_scene.Root, 0)), Is.LessThan(1e-9));
            }
            _scene.Root.localRotation = Quaternion.Euler(50, 60, 70);
            Assert.That(Gather(_gatherer, false).instances.Select(instance => instance.Mesh),
                Is.EqualTo(before.instances.Select(instance => instance.Mesh)));
        }

        [Test]
        public void Gather_AfterTheRadarMoved_IsTheSameObject()
        {
            var before = GatherScene(_gatherer);
            _radar.localPosition = new Vector3(1, 2, 3);
            _receiver.localRotation = Quaternion.Euler(0, 1, 0);
            Assert.That(GatherScene(_gatherer), Is.SameAs(before));
        }

        [Test]
        public void Gather_AfterTheRadarLeftTheCommonRoot_HasTheSameMeshesAtPlacesInTheWorld()
        {
            _scene.Root.localPosition = Far;
            var below = GatherScene(_gatherer);
            _radar.SetParent(null, false);
            try
            {
                var apart = GatherScene(_gatherer);
                Assert.That(apart.Instances.Select(instance => instance.Mesh),
                    Is.EqualTo(below.Instances.Select(instance => instance.Mesh)));
                Assert.That(apart.Origin, Is.EqualTo(new double3(0)));
                Assert.That(SceneBuilder.Apart(SceneBuilder.Corners(apart),
                    SceneBuilder.Corners(below).Select(corner => corner + below.Origin).ToArray()), Is.LessThan(1e-9));
            }
            finally
            {
                _radar.SetParent(_scene.Root, false);
            }
        }

        [Test]
        public void Gather_RadarAmongTheObjects_HasItsOriginAtTheNearestCommonTransform()
        {
            // The radar is on the ship and only the ship is traced, so the ship's position is the origin.
            _radar.SetParent(_ship, false);
            var scene = _gatherer.Gather(~0, new List<Transform> { _ship }, _receiver, _radar);
            Assert.That(distance(scene.Origin, SceneBuilder.ToWorld(_ship, 0)), Is.LessThan(1e-12));
            AssertPositions(scene, _ship.GetComponentsInChildren<MeshFilter>());

            // With a receiver on the rock the root is the origin.
            _receiver.SetParent(_scene.Root.Find("Rock"), false);
            scene = _gatherer.Gather(~0, new List<Transform> { _ship }, _receiver, _radar);
            Assert.That(scene.Origin, Is.EqualTo((double3)(float3)_scene.Root.localPosition));
            AssertPositions(scene, _ship.GetComponentsInChildren<MeshFilter>());
        }

        [Test]
        public void Gather_ObjectsThatAreNotTraced_DoNotCountForTheOrigin()
        {
            var elsewhere = new GameObject("Elsewhere", typeof(MeshFilter), typeof(MeshRenderer));
            elsewhere.GetComponent<MeshFilter>().sharedMesh = SceneBuilder.Mesh(1, 8);
            try
            {
                _scene.Root.localPosition = Far;
                Assert.That(GatherScene(_gatherer).Origin, Is.EqualTo((double3)(float3)Far));
                elsewhere.transform.SetParent(_receiver, false);
                elsewhere.transform.SetParent(null, true);
                var roots = new List<Transform> { _scene.Root, elsewhere.transform };
                Assert.That(_gatherer.Gather(~0, roots, _receiver, _radar).Origin,
                    Is.EqualTo(new double3(0)), "traced");
                elsewhere.GetComponent<MeshRenderer>().enabled = false;
                Assert.That(_gatherer.Gather(~0, roots, _receiver, _radar).Origin,
                    Is.EqualTo((double3)(float3)Far), "disabled");
            }
            finally
            {
                Object.DestroyImmediate(elsewhere);
            }
        }

        [Test]
        public void Gather_SeparateRoots1000KilometresAway_AreWhereTheyBelongToANanometre()
        {
            // Multiples of 1/16 m, which float32 represents there.
            _scene.Root.localRotation = Quaternion.identity;
            _scene.Root.localScale = Vector3.one;
            _scene.Root.localPosition = new Vector3(1000000.0625f, 16.4375f, -999999.5f);
            var other = new GameObject("Stand").transform;
            other.localPosition = new Vector3(1000050.8125f, 20.125f, -1000001.25f);
            _radar.SetParent(other, false);
            try
            {
                var rock = _scene.Root.Find("Rock");
                rock.localPosition = new Vector3(-5.0625f, 0.125f, 1);
                var mesh = rock.GetComponent<MeshFilter>().sharedMesh;
                mesh.vertices = mesh.vertices.Select(v => (Vector3)(round((float3)v * 16) / 16)).ToArray();
                var scene = _gatherer.Gather(~0, new List<Transform> { rock }, _receiver, _radar);
                Assert.That(scene.Origin, Is.EqualTo(new double3(0)));

                var fromRadar = SceneBuilder.Corners(scene)
                    .Select(corner => corner - _gatherer.PoseOf(_radar).Origin).ToArray();
                double3 apart = new double3(1000000.0625 - 5.0625, 16.4375 + 0.125, -999999.5 + 1)
                    - new double3(1000050.8125, 20.125, -1000001.25) - (float3)_radar.localPosition;
                var expected = mesh.triangles.Select(index => apart + (float3)mesh.vertices[index]).ToArray();
                Assert.That(SceneBuilder.Apart(fromRadar, expected), Is.LessThan(1e-9));
            }
            finally
            {
                _radar.SetParent(_scene.Root, false);
                Object.DestroyImmediate(other.gameObject);
            }
        }

        [TestCase(1, 1, 1)]
        [TestCase(3, 0.2f, 1)]
        [TestCase(-1, 1, 1)]
        [TestCase(1, -2, -0.5f)]
        public void PoseOf_BelowScaledAndMirroredTransforms_HasUnitysAxesInDouble(float x, float y, float z)
        {
            _scene.Root.localScale = new Vector3(x, y, z);
            _radar.parent.localScale = new Vector3(y, z, 1.5f * x);
            GatherScene(_gatherer);
            foreach (var transform in new[] { _radar, _receiver })
            {
                var pose = _gatherer.PoseOf(transform);
                Assert.That(distance(pose.Origin, SceneBuilder.ToWorld(transform, 0)), Is.LessThan(1e-12),
                    "at the root's place, which is the world's origin");
                Assert.That(distance((float3)pose.X, transform.right), Is.LessThan(1e-6));
                Assert.That(distance((float3)pose.Y, transform.up), Is.LessThan(1e-6));
                Assert.That(distance((float3)pose.Z, transform.forward), Is.LessThan(1e-6));
                Assert.That(abs(new double3(length(pose.X), length(pose.Y), length(pose.Z)) - 1),
                    Is.EqualTo(new double3(0)).Using<double3>((a, b) => distance(a, b) < 1e-14 ? 0 : 1));
                Assert.That(distance(cross(pose.X, pose.Y), pose.Z), Is.LessThan(1e-14), "left-handed, as in Unity");
            }
        }

        [Test]
        public void Gather_RandomHierarchies_HaveEveryCornerWhereItBelongs([NUnit.Framework.Range(1, 12)] int seed)
        {
            var random = new System.Random(seed);
            float Number(double limit) => (float)((2 * random.NextDouble() - 1) * limit);
            var all = _scene.Root.GetComponentsInChildren<Transform>();
            foreach (var item in all)
            {
                item.localPosition = new Vector3(Number(30), Number(30), Number(30));
                item.localRotation = Quaternion.Euler(Number(180), Number(180), Number(180));
                // Uniform, stretched, mirrored or nearly flat.
                item.localScale = random.Next(3) == 0 ? new Vector3(1 + Number(0.5), 1 + Number(0.9),
                    random.Next(2) == 0 ? -1 : 0.01f) : Vector3.one;
                if (random.Next(3) == 0)
                    _gatherer.ExpectMotion(item);
            }
            _scene.Root.localPosition = Far;
            _radar.SetParent(
                all[random.Next(all.Length - 1)] is var parent && parent.IsChildOf(_radar) ? _scene.Root : parent,
                false);
            for (int step = 0; step < 4; step++)
            {
                var scene = GatherScene(_gatherer);
                var objects = _scene.Root.GetComponentsInChildren<MeshFilter>()
                    .Where(filter => !filter.transform.IsChildOf(_receiver));
                AssertPositions(scene, objects);
                Assert.That(distance(scene.Origin + _gatherer.PoseOf(_radar).Origin, SceneBuilder.ToWorld(_radar, 0)),
                    Is.LessThan(2e-9));
                all[random.Next(all.Length)].localPosition += new Vector3(Number(1), 0, Number(1));
            }
        }

        static Transform Child(string name, Transform parent, Vector3 position, Quaternion rotation)
        {
            var child = new GameObject(name).transform;
            child.SetParent(parent, false);
            child.localPosition = position;
            child.localRotation = rotation;
            return child;
        }

        RadarScene GatherScene(SceneGatherer gatherer) =>
            gatherer.Gather(~0, new List<Transform> { _scene.Root }, _receiver, _radar);

        (MeshInstance[] instances, double3 origin, Affine radar, Affine receiver) Gather(
            SceneGatherer gatherer, bool shipMoves)
        {
            if (shipMoves)
                gatherer.ExpectMotion(_ship);
            var scene = GatherScene(gatherer);
            return (scene.Instances, scene.Origin, gatherer.PoseOf(_radar), gatherer.PoseOf(_receiver));
        }

        // Within half a step of float32 at the size of the bodies, which have their own order in the scene.
        static void AssertPositions(RadarScene scene, IEnumerable<MeshFilter> objects)
        {
            var expected = SceneBuilder.Corners(objects.Select(filter => filter.transform));
            var found = SceneBuilder.Corners(scene);
            Assert.That(found.Length, Is.EqualTo(expected.Length).And.GreaterThan(0));
            foreach (var corner in expected)
                Assert.That(found.Min(other => distance(other + scene.Origin, corner)), Is.LessThan(1e-4));
        }
    }
}
