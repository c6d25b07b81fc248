using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>
    /// Vertex positions against transforms computed independently in double. Float32 rounds them relative to their
    /// body: a single mesh keeps its vertices exactly, and merged ones are accurate to half a step of float32 at the
    /// body's size. The body's distance does not matter.
    /// </summary>
    public sealed class SceneGeometryTests : GathererFixture
    {
        // Step of float32 at 100 km.
        const double WorldStep = 1.0 / 128;

        [Test]
        public void ToWorld_OfALoneMeshAt100Kilometres_IsExact()
        {
            var node = Chain(Vector3.one * 1.1f);
            var mesh = SceneBuilder.Mesh(20, 1);
            var item = _scene.Add("Object", mesh, node);
            var scene = _scene.Gather(_gatherer);
            Assert.That(scene.Instances[0].Mesh.Vertices, Is.EqualTo(mesh.vertices.Select(v => (float3)v)));
            Assert.That(SceneBuilder.Apart(SceneBuilder.Corners(scene), SceneBuilder.Corners(new[] { item })),
                Is.LessThan(1e-9));
        }

        [TestCase(false)]
        [TestCase(true)]
        public void ToWorld_NestedStretchedAndMirroredAt100Kilometres_IsRightToTheStepOfTheMergedMesh(bool moves)
        {
            var node = Chain(new Vector3(-1.5f, 0.7f, 2));
            var items = new[] { Turned("A", 1, node), Turned("B", 2, node), Turned("C", 3, node) };
            if (moves)
                _gatherer.ExpectMotion(node);
            var scene = _scene.Gather(_gatherer);
            Assert.That(scene.Instances.Length, Is.EqualTo(1), "merged");
            double largest = scene.Instances[0].Mesh.Vertices.Max(v => cmax(abs(v)));
            Assert.That(largest, Is.LessThan(32), "small numbers, for a scene of some 20 m");
            double error = SceneBuilder.Apart(SceneBuilder.Corners(scene), SceneBuilder.Corners(items));
            Assert.That(error, Is.LessThan(1e-3 * WorldStep));
            Assert.That(error, Is.LessThan(2 * sqrt(3) * largest * pow(2.0, -24)), "half a step a coordinate");
        }

        [Test]
        public void ToWorld_ObjectsOnAGridOfPowersOfTwo_StayOnIt()
        {
            // Multiples of 1/16 m at 1,000 km.
            _scene.Root.localPosition = new Vector3(1e6f, 0, -1e6f);
            var mesh = SceneBuilder.Mesh(20, 1);
            mesh.vertices = mesh.vertices.Select(v => (Vector3)(round((float3)v * 16) / 16)).ToArray();
            var items = new[] { _scene.Add("A", mesh), _scene.Add("B", mesh) };
            items[1].localPosition = new Vector3(7.25f, 0.0625f, -3);
            var scene = _scene.Gather(_gatherer);
            Assert.That(SceneBuilder.Corners(scene), Is.EqualTo(SceneBuilder.Corners(items)));
        }

        [Test]
        public void ToWorld_MergedMeshesAboutTheOrigin_KeepTheirVertices()
        {
            var items = new[] { _scene.Add("A", SceneBuilder.Mesh(20, 1)), _scene.Add("B", SceneBuilder.Mesh(20, 2)) };
            var scene = _scene.Gather(_gatherer);
            Assert.That(scene.Instances.Single().ToWorld, Is.EqualTo(Affine.Identity));
            Assert.That(SceneBuilder.Corners(scene), Is.EqualTo(SceneBuilder.Corners(items)));
        }

        [Test]
        public void ToWorld_MeshFarFromItsOwnOrigin_IsBroughtNearWithoutRounding()
        {
            var mesh = SceneBuilder.Mesh(20, 1, float3(60000, 0, -50000));
            var item = _scene.Add("Object", mesh);
            var scene = _scene.Gather(_gatherer);
            Assert.That(scene.Instances[0].Mesh.Vertices.Max(v => cmax(abs(v))), Is.LessThan(4));
            Assert.That(SceneBuilder.Corners(scene), Is.EqualTo(SceneBuilder.Corners(new[] { item })));
        }

        [Test]
        public void ToWorld_MeshInKilometresOrMillimetres_HasVerticesInMetres([Values(1e4f, 1e-3f)] float metres)
        {
            var mesh = SceneBuilder.Mesh(20, 1);
            mesh.vertices = mesh.vertices.Select(v => v / metres).ToArray();
            var item = _scene.Add("Object", mesh);
            item.localScale = Vector3.one * metres;
            var scene = _scene.Gather(_gatherer);
            Assert.That(scene.Instances[0].Mesh.Vertices.Max(v => cmax(abs(v))), Is.InRange(0.5f, 2f));
            Assert.That(SceneBuilder.Apart(SceneBuilder.Corners(scene), SceneBuilder.Corners(new[] { item })),
                Is.LessThan(1e-12));
        }

        // Rotated and scaled parents, 100 km from the origin.
        Transform Chain(Vector3 scale)
        {
            _scene.Root.localPosition = new Vector3(80000.25f, 1234.5f, -60000);
            _scene.Root.localRotation = Quaternion.Euler(20, -70, 5);
            var centre = _scene.Empty("Middle");
            centre.localPosition = new Vector3(3, 4, -5);
            centre.localRotation = Quaternion.Euler(-33, 120, 61);
            centre.localScale = scale;
            var node = _scene.Empty("Place", centre);
            node.localPosition = new Vector3(0.1f, -2, 1.7f);
            node.localRotation = Quaternion.Euler(1, 2, 3);
            return node;
        }

        Transform Turned(string name, int seed, Transform parent)
        {
            var item = _scene.Add(name, SceneBuilder.Mesh(20, seed), parent);
            item.localPosition = new Vector3(2 * seed, -seed, 0.3f);
            item.localRotation = Quaternion.Euler(40 * seed, 11, -70);
            item.localScale = new Vector3(1, 1.3f, -0.8f);
            return item;
        }
    }
}
