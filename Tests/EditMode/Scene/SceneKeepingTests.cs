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
    /// Objects reused from one gather to the next. The same TriangleMesh object means that no BVH is rebuilt.
    /// </summary>
    public sealed class SceneKeepingTests : GathererFixture
    {
        // Float32 steps of these scenes of some 10 m.
        const double Tolerance = 4e-6;

        [Test]
        public void Gather_UnchangedScene_IsTheSameObject()
        {
            AddShip();
            AddRocks();
            var first = Gather();
            Assert.That(Gather(), Is.SameAs(first));
        }

        [Test]
        public void Gather_ObjectsThatKeepStill_AreOneMesh()
        {
            AddShip();
            AddRocks();
            var scene = Gather();
            Assert.That(scene.Instances.Length, Is.EqualTo(1));
            Assert.That(scene.TriangleCount, Is.EqualTo(40));
            Assert.That(_gatherer.ObjectCount, Is.EqualTo(4));
        }

        [Test]
        public void Gather_ExpectedMotion_ChangesOneTransformFromTheFirstTurnOn()
        {
            AddRocks();
            var ship = AddShip();
            _gatherer.ExpectMotion(ship);
            var before = Gather();
            Assert.That(before.Instances.Length, Is.EqualTo(2));
            for (int pose = 1; pose < 4; pose++)
            {
                ship.localRotation = Quaternion.Euler(0, 10 * pose, 0);
                ship.localPosition = new Vector3(pose, 0, 0);
                var after = Gather();
                Assert.That(Meshes(after), Is.EqualTo(Meshes(before)));
                Assert.That(after.Instances[0].ToWorld, Is.EqualTo(before.Instances[0].ToWorld), "rocks");
                Assert.That(after.Instances[1].ToWorld, Is.Not.EqualTo(before.Instances[1].ToWorld), "ship");
                AssertWhereItBelongs(after);
            }
        }

        [Test]
        public void Gather_MotionNobodyAnnounced_IsSplitOffOnce()
        {
            AddRocks();
            var ship = AddShip();
            Assert.That(Gather().Instances.Length, Is.EqualTo(1));
            ship.localRotation = Quaternion.Euler(0, 10, 0);
            var split = Gather();
            Assert.That(split.Instances.Length, Is.EqualTo(2));
            AssertWhereItBelongs(split);
            ship.localRotation = Quaternion.Euler(0, 20, 0);
            var turned = Gather();
            Assert.That(Meshes(turned), Is.EqualTo(Meshes(split)));
            AssertWhereItBelongs(turned);
        }

        [Test]
        public void Gather_PartThatMovesOnAMovingObject_IsAMergedMeshOfItsOwn()
        {
            AddRocks();
            var ship = AddShip();
            var dish = _scene.Add("Dish", SceneBuilder.Mesh(5, 9), ship);
            _gatherer.ExpectMotion(ship);
            _gatherer.ExpectMotion(dish);
            var before = Gather();
            Assert.That(before.Instances.Length, Is.EqualTo(3));
            ship.localPosition = new Vector3(3, 0, 1);
            dish.localRotation = Quaternion.Euler(0, 90, 0);
            var after = Gather();
            Assert.That(Meshes(after), Is.EqualTo(Meshes(before)));
            AssertWhereItBelongs(after);
        }

        [Test]
        public void Gather_ScaleOfAMover_IsInTheVertices()
        {
            // The frame of a moving object keeps its meshes' coordinates, whatever its scale.
            var ship = AddShip();
            ship.localScale = new Vector3(30, 0.1f, 2);
            _gatherer.ExpectMotion(ship);
            ship.localRotation = Quaternion.Euler(10, 20, 30);
            var scene = Gather();
            Assert.That(abs(scene.Instances.Single().ToWorld.Determinant), Is.EqualTo(1).Within(1e-12));
            AssertWhereItBelongs(scene, 30 * Tolerance);
        }

        [Test]
        public void Gather_MeshChangedInPlace_IsNoticedAndRebuildsNothingElse()
        {
            AddRocks();
            var mesh = SceneBuilder.Mesh(30, 7);
            _scene.Add("Sea", mesh);
            var ship = AddShip();
            _gatherer.ExpectMotion(ship);
            Gather();
            Change(mesh, 0);
            var first = Gather();
            AssertWhereItBelongs(first);
            Change(mesh, 89);
            var second = Gather();
            AssertWhereItBelongs(second);
            Assert.That(Meshes(second).Intersect(Meshes(first)).Count(),
                Is.EqualTo(first.Instances.Length - 1), "all but the sea's");
            Assert.That(Gather(), Is.SameAs(second));
        }

        [Test]
        public void Gather_SameTrianglesInAnotherOrder_AreAnotherMesh()
        {
            var mesh = SceneBuilder.Mesh(2, 7);
            _scene.Add("Object", mesh);
            var before = Gather();
            mesh.triangles = new[] { 3, 4, 5, 0, 1, 2 };
            var after = Gather();
            Assert.That(after.Instances[0].Mesh, Is.Not.SameAs(before.Instances[0].Mesh));
            Assert.That(after.Instances[0].Mesh.Indices, Is.EqualTo(mesh.triangles));
        }

        [Test]
        public void Gather_OtherTopologyOfTheSameIndices_IsNoticed()
        {
            var mesh = new Mesh { name = "Twelve" };
            mesh.vertices = SceneBuilder.Mesh(4, 3).vertices;
            mesh.SetIndices(Enumerable.Range(0, 12).ToArray(), MeshTopology.Triangles, 0);
            _scene.Add("Object", mesh);
            Assert.That(Gather().TriangleCount, Is.EqualTo(4));
            mesh.SetIndices(Enumerable.Range(0, 12).ToArray(), MeshTopology.Quads, 0);
            Assert.That(Gather().TriangleCount, Is.EqualTo(6));
        }

        [Test]
        public void Gather_MeshThatBecomesUnfitAndFitAgain_IsRefusedAndThenTakenAsItIs()
        {
            var mesh = SceneBuilder.Mesh(2, 7);
            _scene.Add("Object", mesh);
            Gather();
            var vertices = mesh.vertices;
            mesh.vertices = vertices.Select((v, i) => i == 4 ? new Vector3(0, float.NaN, 0) : v).ToArray();
            Assert.That(Assert.Throws<GlintException>(() => Gather()).Message, Does.Contain("vertex 4"));
            Assert.That(Assert.Throws<GlintException>(() => Gather()).Message, Does.Contain("vertex 4"), "every time");
            mesh.vertices = vertices;
            AssertWhereItBelongs(Gather());
        }

        [Test]
        public void Gather_ObjectThatSwapsItsMesh_RebuildsNothingElse()
        {
            AddRocks();
            var filter = _scene.Add("Sea", SceneBuilder.Mesh(30, 7)).GetComponent<MeshFilter>();
            Gather();
            filter.sharedMesh = SceneBuilder.Mesh(30, 8);
            var first = Gather();
            AssertWhereItBelongs(first);
            filter.sharedMesh = SceneBuilder.Mesh(30, 9);
            var second = Gather();
            AssertWhereItBelongs(second);
            Assert.That(Meshes(second).Intersect(Meshes(first)).Count(), Is.EqualTo(1), "the rocks");
        }

        [Test]
        public void Gather_ChangingMeshOfAFlatMover_RebuildsNothingElse()
        {
            // Compressed too much for an instance: merged alone, in its own frame.
            var mesh = SceneBuilder.Mesh(10, 1);
            var sheet = _scene.Add("Sheet", mesh);
            sheet.localScale = new Vector3(1, 1, 1e-4f);
            _scene.Add("Mast", SceneBuilder.Mesh(10, 2), sheet);
            _gatherer.ExpectMotion(sheet);
            Gather();
            Change(mesh, 0);
            var first = Gather();
            AssertWhereItBelongs(first);
            Change(mesh, 1);
            var second = Gather();
            AssertWhereItBelongs(second);
            Assert.That(second.Instances.Length, Is.EqualTo(2));
            Assert.That(second.Instances[0].Mesh, Is.Not.SameAs(first.Instances[0].Mesh), "sheet");
            Assert.That(second.Instances[1].Mesh, Is.SameAs(first.Instances[1].Mesh), "mast");
        }

        [Test]
        public void Gather_MeshOfManyObjects_IsInstancedAboveSoManyTriangles()
        {
            const int triangles = 20000;
            var mesh = SceneBuilder.Mesh(triangles, 1);
            int limit = (int)(SceneGatherer.MaxMergedTriangles / triangles);
            for (int i = 0; i < limit; i++)
                _scene.Add($"Tile {i}", mesh).localPosition = new Vector3(3 * i, 0, 0);
            var merged = Gather();
            Assert.That(merged.Instances.Length, Is.EqualTo(1));

            // Mirrored and slightly stretched.
            var last = _scene.Add("Last", mesh);
            last.localPosition = new Vector3(-5, 0, 0);
            last.localScale = new Vector3(-1, 1.5f, 1);
            var instanced = Gather();
            Assert.That(instanced.Instances.Length, Is.EqualTo(limit + 1));
            Assert.That(Meshes(instanced).Distinct().Count(), Is.EqualTo(1));
            Assert.That(instanced.TriangleCount, Is.EqualTo(merged.TriangleCount + triangles));
            Assert.That(instanced.Instances[limit].ToWorld.Determinant, Is.EqualTo(-1.5).Within(1e-12));
        }

        [Test]
        public void Gather_MoversWithTheSameMesh_ShareIt()
        {
            var mesh = SceneBuilder.Mesh(10, 1);
            foreach (var ship in new[] { _scene.Add("A", mesh), _scene.Add("B", mesh) })
                _gatherer.ExpectMotion(ship);
            var scene = Gather();
            Assert.That(scene.Instances.Length, Is.EqualTo(2));
            Assert.That(scene.Instances[1].Mesh, Is.SameAs(scene.Instances[0].Mesh));
        }

        [Test]
        public void Gather_ObjectsFarFromEachOther_AreNotMerged()
        {
            foreach (float x in new[] { 0f, 5f, 40000f, 40005f })
                _scene.Add($"At {x}", SceneBuilder.Mesh(10, (int)x)).localPosition = new Vector3(x, 0, 0);
            var scene = Gather();
            Assert.That(scene.Instances.Length, Is.EqualTo(2));
            AssertWhereItBelongs(scene);
        }

        [Test]
        public void Gather_FlattenedParentOfAMover_IsMergedIntoTheWorld()
        {
            var flat = _scene.Empty("Flat");
            flat.localScale = new Vector3(1, 0, 1);
            var ship = _scene.Add("Ship", SceneBuilder.Mesh(10, 1), flat);
            _gatherer.ExpectMotion(ship);
            ship.localRotation = Quaternion.Euler(0, 0, 30);
            AssertTransformsHaveInverses(Gather());
            ship.localRotation = Quaternion.Euler(0, 0, 40);
            var scene = Gather();
            AssertTransformsHaveInverses(scene);
            AssertWhereItBelongs(scene);
        }

        [Test]
        public void Gather_RandomChanges_NeverLeaveAnythingStale([NUnit.Framework.Range(1, 8)] int seed)
        {
            var random = new System.Random(seed);
            var changes = new RandomChanges(_scene, random);
            for (int step = 0; step < 60; step++)
            {
                string what = changes.Next(_gatherer);
                var scene = Gather();
                AssertTransformsHaveInverses(scene);
                var expected = SceneBuilder.Corners(changes.Active);
                Assert.That(Unmatched(expected, SceneBuilder.Corners(scene), 1e-3), Is.Zero, $"step {step}: {what}");
            }
        }

        [Test]
        public void FrameCache_WhatIsNotAskedFor_IsForgotten()
        {
            var cache = new FrameCache<int, object>();
            cache.Begin();
            var one = cache.Get(1, out bool first);
            Assert.That(first);
            Assert.That(cache.Get(1, out first), Is.SameAs(one));
            Assert.That(first, Is.False);
            var two = cache.Get(2, out _);
            cache.End();
            cache.Begin();
            Assert.That(cache.Get(1, out first), Is.SameAs(one));
            Assert.That(first);
            cache.End();
            cache.Begin();
            Assert.That(cache.Get(2, out _), Is.Not.SameAs(two));
        }

        RadarScene Gather() => _scene.Gather(_gatherer);

        Transform AddShip()
        {
            var ship = _scene.Add("Hull", SceneBuilder.Mesh(10, 1));
            ship.localPosition = new Vector3(2, 1, 0);
            _scene.Add("Mast", SceneBuilder.Mesh(10, 2), ship).localPosition = new Vector3(0, 2, 0);
            return ship;
        }

        void AddRocks()
        {
            _scene.Add("Rock", SceneBuilder.Mesh(10, 3)).localPosition = new Vector3(-5, 0, 0);
            _scene.Add("Cliff", SceneBuilder.Mesh(10, 4)).localPosition = new Vector3(5, 0, 5);
        }

        // Moves one vertex slightly.
        static void Change(Mesh mesh, int vertex)
        {
            var vertices = mesh.vertices;
            vertices[vertex] += new Vector3(0, 0.001f, 0);
            mesh.vertices = vertices;
        }

        static TriangleMesh[] Meshes(RadarScene scene) => scene.Instances.Select(instance => instance.Mesh).ToArray();

        void AssertWhereItBelongs(RadarScene scene, double tolerance = Tolerance)
        {
            var objects = _scene.Root.GetComponentsInChildren<MeshFilter>().Select(filter => filter.transform);
            var corners = SceneBuilder.Corners(scene);
            Assert.That(Unmatched(SceneBuilder.Corners(objects), corners, tolerance), Is.Zero);
        }

        static void AssertTransformsHaveInverses(RadarScene scene)
        {
            foreach (var instance in scene.Instances)
                Assert.That(TransformMath.Conditioning(instance.ToWorld), Is.GreaterThan(9e-4));
        }

        // Triangles of one list that the other lacks, each matched once.
        static int Unmatched(double3[] expected, double3[] actual, double tolerance)
        {
            var left = new List<int>(Enumerable.Range(0, actual.Length / 3));
            int unmatched = abs(expected.Length - actual.Length) / 3;
            for (int t = 0; t < expected.Length; t += 3)
            {
                int match = left.FindIndex(f => distance(actual[3 * f], expected[t]) < tolerance
                    && distance(actual[3 * f + 1], expected[t + 1]) < tolerance
                    && distance(actual[3 * f + 2], expected[t + 2]) < tolerance);
                if (match < 0)
                    unmatched++;
                else
                    left.RemoveAt(match);
            }
            return unmatched;
        }
    }
}
