using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>The traced triangles of a scene and their positions.</summary>
    public sealed class SceneGathererTests
    {
        readonly SceneGatherer _gatherer = new SceneGatherer();
        Transform _root;

        [SetUp]
        public void MakeRoot() => _root = new GameObject("Root").transform;

        [TearDown]
        public void RemoveRoot() => Object.DestroyImmediate(_root.gameObject);

        [Test]
        public void Gather_ScaledCube_IsWorldSpace()
        {
            var cube = AddPrimitive(PrimitiveType.Cube);
            cube.localPosition = new Vector3(1, 2, 3);
            cube.localScale = new Vector3(2, 4, 6);
            var scene = Gather();
            Assert.That(scene.TriangleCount, Is.EqualTo(12));
            Bounds(scene, out var boxMin, out var boxMax);
            Assert.That(distance(boxMin, float3(0, 0, 0)), Is.LessThan(1e-6f));
            Assert.That(distance(boxMax, float3(2, 4, 6)), Is.LessThan(1e-6f));
        }

        [Test]
        public void Gather_TurnedChildOfANonUniformlyScaledParent_IsSheared()
        {
            // A unit cube rotated by 45 deg about z, then stretched by 3 along x: its corner (0.5, 0.5) moves to (0,
            // 0.7071), (0.5, -0.5) to (3 * 0.7071, 0).
            _root.localScale = new Vector3(3, 1, 1);
            AddPrimitive(PrimitiveType.Cube).localRotation = Quaternion.Euler(0, 0, 45);
            Bounds(Gather(), out var boxMin, out var boxMax);
            Assert.That(distance(boxMax, float3(3 * sqrt(0.5f), sqrt(0.5f), 0.5f)), Is.LessThan(1e-5f));
            Assert.That(distance(boxMin, -boxMax), Is.LessThan(1e-5f));
        }

        // Two sheets bent by 15 deg, stretched by 3: 2 atan(3 tan(7.5 deg)) = 43.1 deg are a crease.
        [TestCase(false)]
        [TestCase(true)]
        public void Gather_ABendThatIsStretched_HasPatchesOfTheBendInTheScene(bool moves)
        {
            float rise = tan(radians(7.5f));
            var mesh = new Mesh { name = "Bend" };
            mesh.vertices = new[]
            {
                new Vector3(-1, -rise, 0), new Vector3(-1, -rise, 1), new Vector3(0, 0, 0), new Vector3(0, 0, 1),
                new Vector3(1, -rise, 0), new Vector3(1, -rise, 1)
            };
            mesh.triangles = new[] { 0, 1, 2, 2, 1, 3, 2, 3, 4, 4, 3, 5 };
            AddMesh(mesh);
            var item = _root.GetChild(0);
            item.localScale = new Vector3(1, 3, 1);
            int PatchCount(RadarScene scene) => SurfacePatches.Find(scene.Instances.Single().Mesh).PatchCount;
            Assert.That(PatchCount(Gather()), Is.EqualTo(2));
            if (!moves)
                return;
            item.localRotation = Quaternion.Euler(0, 30, 0);
            var turned = Gather().Instances.Single().Mesh;
            item.localRotation = Quaternion.Euler(0, 60, 0);
            Assert.That(Gather().Instances.Single().Mesh, Is.SameAs(turned), "its vertices are not made again");
        }

        // A file that was deleted: the surface would count as metal.
        [Test]
        public void Gather_ASurfaceWhoseMaterialIsGone_IsRefused()
        {
            var surface = AddPrimitive(PrimitiveType.Cube).gameObject.AddComponent<RadarSurface>();
            surface.name = "Hull";
            Assert.That(Gather().TriangleCount, Is.EqualTo(12), "none was assigned");
            surface.Material = ScriptableObject.CreateInstance<RadarMaterial>();
            Gather();
            Object.DestroyImmediate(surface.Material);
            Assert.That(Assert.Throws<GlintException>(() => Gather()).Message, Is.EqualTo("RadarSurface of 'Hull' "
                + "refers to a radar material that is gone: assign another one, or None for a perfect conductor"));
        }

        [Test]
        public void Gather_ASurfaceOfASubmeshThatTheMeshLacks_IsWarnedOf()
        {
            var surface = AddPrimitive(PrimitiveType.Cube).gameObject.AddComponent<RadarSurface>();
            (surface.name, surface.Submesh) = ("Hull", 0);
            Gather();
            Assert.That(_gatherer.Warnings, Is.Empty);
            surface.Submesh = 1;
            Gather();
            Assert.That(_gatherer.Warnings.Single(),
                Does.StartWith("RadarSurface of 'Hull' is that of submesh 1, and mesh 'Cube").And.Contain("has 1,"));
        }

        [Test]
        public void Gather_MirroredObject_IsMirrored()
        {
            var quad = AddPrimitive(PrimitiveType.Quad);
            quad.localPosition = new Vector3(2, 0, 0);
            _root.localScale = new Vector3(-1, 1, 1);
            Bounds(Gather(), out var boxMin, out var boxMax);
            Assert.That(distance(boxMin, float3(-2.5f, -0.5f, 0)), Is.LessThan(1e-6f));
            Assert.That(distance(boxMax, float3(-1.5f, 0.5f, 0)), Is.LessThan(1e-6f));
        }

        [Test]
        public void Gather_QuadTopology_IsSplitInTwoTrianglesOfTheSameArea()
        {
            var mesh = new Mesh { name = "Quads" };
            mesh.vertices =
                new[] { new Vector3(0, 0, 0), new Vector3(0, 2, 0), new Vector3(3, 2, 0), new Vector3(3, 0, 0) };
            mesh.SetIndices(new[] { 0, 1, 2, 3 }, MeshTopology.Quads, 0);
            AddMesh(mesh);
            var scene = Gather();
            Assert.That(scene.TriangleCount, Is.EqualTo(2));
            Assert.That(Area(scene), Is.EqualTo(6).Within(1e-6));
        }

        [Test]
        public void Gather_SeveralSubmeshes_AreAllTaken()
        {
            var mesh = new Mesh { name = "Two parts" };
            mesh.vertices =
                new[] { new Vector3(0, 0, 0), new Vector3(0, 1, 0), new Vector3(1, 0, 0), new Vector3(0, 0, 1) };
            mesh.subMeshCount = 2;
            mesh.SetIndices(new[] { 0, 1, 2 }, MeshTopology.Triangles, 0);
            mesh.SetIndices(new[] { 0, 1, 3 }, MeshTopology.Triangles, 1);
            AddMesh(mesh);
            Assert.That(Gather().TriangleCount, Is.EqualTo(2));
        }

        [Test]
        public void Gather_DisabledRenderersInactiveObjectsAndOtherLayers_AreLeftOut()
        {
            AddPrimitive(PrimitiveType.Cube).GetComponent<MeshRenderer>().enabled = false;
            AddPrimitive(PrimitiveType.Cube).gameObject.SetActive(false);
            AddPrimitive(PrimitiveType.Cube).gameObject.layer = 4;
            AddPrimitive(PrimitiveType.Quad);
            Assert.That(Gather(layers: 1).TriangleCount, Is.EqualTo(2));
            Assert.That(Gather(layers: 1 << 4).TriangleCount, Is.EqualTo(12));
            Assert.That(_gatherer.ObjectCount, Is.EqualTo(1));
        }

        [Test]
        public void Gather_ReceiverAndWhatHangsOnIt_AreNoPartOfTheScene()
        {
            var receiver = AddPrimitive(PrimitiveType.Quad);
            AddPrimitive(PrimitiveType.Cube).SetParent(receiver);
            AddPrimitive(PrimitiveType.Quad);
            Assert.That(Gather(receiver: receiver).TriangleCount, Is.EqualTo(2));
        }

        [Test]
        public void Gather_LevelsOfDetail_OnlyTheFirstIsTaken()
        {
            var fine = AddPrimitive(PrimitiveType.Cube).GetComponent<Renderer>();
            var coarse = AddPrimitive(PrimitiveType.Quad).GetComponent<Renderer>();
            _root.gameObject.AddComponent<LODGroup>()
                .SetLODs(new[] { new LOD(0.5f, new[] { fine }), new LOD(0.1f, new[] { coarse }) });
            Assert.That(Gather().TriangleCount, Is.EqualTo(12));
        }

        [Test]
        public void Gather_NoRoots_TakesTheWholeSceneInTheOrderOfTheHierarchy()
        {
            var second = AddPrimitive(PrimitiveType.Cube);
            var first = AddPrimitive(PrimitiveType.Quad);
            first.SetSiblingIndex(0);
            second.localPosition = new Vector3(100, 0, 0);
            var corners = SceneBuilder.Corners(_gatherer.Gather(~0, new List<Transform>(), null));
            int quad = System.Array.FindIndex(corners, v => abs(v.x) < 1),
                cube = System.Array.FindIndex(corners, v => v.x > 99);
            Assert.That(quad, Is.GreaterThanOrEqualTo(0));
            Assert.That(cube, Is.GreaterThan(quad));
        }

        [Test]
        public void Gather_NestedRoots_CountOnce()
        {
            var cube = AddPrimitive(PrimitiveType.Cube);
            Assert.That(_gatherer.Gather(~0, new List<Transform> { _root, cube }, null).TriangleCount, Is.EqualTo(12));
        }

        [Test]
        public void Gather_MeshThatIsNotReadable_IsRefusedByNameWithTheRemedy()
        {
            var mesh = SingleTriangle("Hull");
            mesh.UploadMeshData(true);
            AddMesh(mesh);
            AssertRefused("mesh 'Hull' of 'Object'", "not readable", "Read/Write");
        }

        [TestCase(MeshTopology.Lines)]
        [TestCase(MeshTopology.Points)]
        public void Gather_TopologyWithoutFaces_IsRefusedByName(MeshTopology topology)
        {
            var mesh = SingleTriangle("Wire");
            mesh.SetIndices(new[] { 0, 1 }, topology, 0);
            AddMesh(mesh);
            AssertRefused("submesh 0", "mesh 'Wire' of 'Object'", topology.ToString());
        }

        [Test]
        public void Gather_VertexThatIsNoNumber_IsRefusedByName()
        {
            var mesh = SingleTriangle("Broken");
            mesh.vertices = new[] { Vector3.zero, new Vector3(float.NaN, 1, 0), Vector3.right };
            AddMesh(mesh);
            AssertRefused("mesh 'Broken' of 'Object'", "vertex 1");
        }

        [Test]
        public void Gather_ScaleBeyondWhatFloatsCanPlace_IsRefusedByName()
        {
            AddMesh(SingleTriangle("Plate")).localScale = new Vector3(1e8f, 1, 1);
            AssertRefused("mesh 'Plate' of 'Object'", "scale", "vertex 2");
        }

        [Test]
        public void Gather_OneVertexTooFarAway_IsRefusedByName([Values(0, 1, 2)] int axis)
        {
            var far = Vector3.zero;
            far[axis] = -2000;
            var mesh = SingleTriangle("Plate");
            mesh.vertices = new[] { Vector3.zero, far, -far };
            var item = AddMesh(mesh);
            var position = Vector3.zero;
            position[axis] = 9_999_000;
            item.localPosition = position;
            AssertRefused("mesh 'Plate' of 'Object'", "vertex 2");
            item.localPosition = position / 2;
            Assert.That(Gather().TriangleCount, Is.EqualTo(1));
        }

        [Test]
        public void Gather_FilterWithoutMesh_IsNamedInAWarning()
        {
            AddMesh(null);
            Assert.That(Gather().TriangleCount, Is.Zero);
            Assert.That(_gatherer.Warnings.Single(), Does.Contain("'Object'").And.Contain("no mesh"));
        }

        [Test]
        public void Gather_SkinnedMeshes_AreNamedInAWarning()
        {
            var skinned = new GameObject("Sailor").AddComponent<SkinnedMeshRenderer>();
            skinned.transform.SetParent(_root);
            Assert.That(Gather().TriangleCount, Is.Zero);
            Assert.That(_gatherer.Warnings.Single(), Does.Contain("'Sailor'").And.Contain("skinned"));
        }

        RadarScene Gather(int layers = ~0, Transform receiver = null) =>
            _gatherer.Gather(layers, new List<Transform> { _root }, receiver);

        void AssertRefused(params string[] fragments)
        {
            string message = Assert.Throws<GlintException>(() => Gather()).Message;
            foreach (string fragment in fragments)
                Assert.That(message, Does.Contain(fragment));
        }

        Transform AddPrimitive(PrimitiveType type)
        {
            var primitive = GameObject.CreatePrimitive(type).transform;
            primitive.SetParent(_root, false);
            return primitive;
        }

        Transform AddMesh(Mesh mesh)
        {
            var added = new GameObject("Object");
            added.transform.SetParent(_root, false);
            added.AddComponent<MeshFilter>().sharedMesh = mesh;
            added.AddComponent<MeshRenderer>();
            return added.transform;
        }

        static Mesh SingleTriangle(string name) => new Mesh
        {
            name = name, vertices = new[] { Vector3.zero, Vector3.up, Vector3.right }, triangles = new[] { 0, 1, 2 }
        };

        static void Bounds(RadarScene scene, out float3 boxMin, out float3 boxMax)
        {
            var corners = SceneBuilder.Corners(scene);
            boxMin = (float3)corners.Aggregate(min);
            boxMax = (float3)corners.Aggregate(max);
        }

        static double Area(RadarScene scene)
        {
            var corners = SceneBuilder.Corners(scene);
            return Enumerable.Range(0, corners.Length / 3)
                .Sum(t => length(cross(corners[3 * t + 1] - corners[3 * t], corners[3 * t + 2] - corners[3 * t])) / 2);
        }
    }
}
