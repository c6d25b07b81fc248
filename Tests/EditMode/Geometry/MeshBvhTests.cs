using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using Glint.Core;
using NUnit.Framework;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    [TestFixture(BvhLayout.Binary)]
    [TestFixture(BvhLayout.Wide)]
    public sealed class MeshBvhTests
    {
        readonly BvhLayout _layout;

        public MeshBvhTests(BvhLayout layout) => _layout = layout;

        static readonly Dictionary<string, Func<TriangleMesh>> HardMeshes = new Dictionary<string, Func<TriangleMesh>>
        {
            ["one triangle"] = () => TestRadar.Clutter(1, seed: 1),
            ["two triangles"] = () => TestRadar.Clutter(2, seed: 1),
            ["plate"] = () => TestRadar.FacingPlate(side: 1, z: 5),
            ["clutter"] = () => TestRadar.Clutter(10007, seed: 1), // a prime: no level divides evenly
            ["far clutter"] = () => TestRadar.Clutter(1009, seed: 2, halfSide: 1e7f, largest: 1e3f),
            ["same triangle"] = () => TestMeshes.Same(20000),
            ["slivers"] = () => TestMeshes.Slivers(3000),
            ["fan"] = () => TestMeshes.Fan(3000),
            ["powers of two"] = () => TestRadar.PowersOfTwo(3000, sizes: 46),
            ["ladder"] = () => TestMeshes.Ladder(1000, atTheFoot: 40000),
            ["huge plate over sea"] = () =>
                TestRadar.Join(TestRadar.FacingPlate(side: 1e6f, z: 0), TestMeshes.Sea(50, 50)),
        };

        static IEnumerable<string> HardMeshNames => HardMeshes.Keys;

        [TestCaseSource(nameof(HardMeshNames))]
        public void Build_HardMesh_EveryTriangleIsInOneLeafAndEveryBoxHoldsItsChildren(string name) =>
            MeshBvhReader.Check(HardMeshes[name](), _layout);

        [Test]
        public void Build_NoTriangles_HasNoParts()
        {
            var bvh = MeshBvh.Build(TestRadar.Empty, _layout);
            Assert.That(bvh.Parts, Is.Empty);
            Assert.That(bvh.CoverMin, Is.Empty);
            Assert.That(bvh.CoverMax, Is.Empty);
            Assert.That(bvh.TriangleCount, Is.Zero);
        }

        [Test]
        public void Build_TrianglesWithoutAreaOrOfInfiniteArea_AreLeftOut()
        {
            var nothing = new TriangleMesh(
                new[]
                {
                    float3(0, 0, 0), float3(1, 1, 1), float3(2, 2, 2), float3(2e10f, 0, 0), float3(0, 2e10f, 0),
                    float3(1e-9f, 0, 0), float3(0, 1e-9f, 0)
                },
                new[] { 0, 1, 2, 0, 3, 4, 0, 5, 6, 1, 1, 2 });
            Assert.That(MeshBvh.Build(nothing, _layout).Parts, Is.Empty);
            MeshBvhReader.Check(TestRadar.Join(nothing, TestMeshes.Sea(3, 3), nothing), _layout);
        }

        [Test]
        public void Build_CoordinatesNearTheLargestFloat_KeepsTrianglesOfFiniteArea()
        {
            var corners = Enumerable.Range(0, 999)
                .Select(i => float3(i % 2 == 0 ? 3e38f : -3e38f, i % 3, i * i % 7)).ToArray();
            var order = Enumerable.Range(0, 999).OrderBy(i => i % 2).ToArray();
            Assert.That(MeshBvh.Build(new TriangleMesh(corners, order), BvhLayout.Binary).TriangleCount,
                Is.GreaterThan(100));
        }

        [Test]
        public void Build_Sea_LeavesNoTriangleAlone()
        {
            var sea = TestMeshes.Sea(60, 40);
            Assert.That(MeshBvhReader.Check(sea, _layout).Leaves, Is.EqualTo(60 * 40));
        }

        [Test]
        public void Build_SeaWhoseTrianglesShareNoVertices_LeavesNoTriangleAlone()
        {
            var sea = TestMeshes.Soup(TestMeshes.Sea(60, 40));
            Assert.That(MeshBvhReader.Check(sea, _layout).Leaves, Is.EqualTo(60 * 40));
        }

        [Test]
        public void Build_TrianglesApart_PairsNone() =>
            Assert.That(MeshBvhReader.Check(TestMeshes.Apart(30, 30, step: 1), _layout).Leaves, Is.EqualTo(900));

        [Test]
        public void Build_TrianglesAcrossACorner_AreNotPairedBecauseTheirBoxIsMostlyEmpty()
        {
            var step =
                new TriangleMesh(new[] { float3(0, 0, 0), float3(1, 0, 0), float3(0.5f, 1, 0), float3(0.5f, 0, 1) },
                    new[] { 0, 1, 2, 0, 1, 3 });
            Assert.That(MeshBvhReader.Check(step, _layout).Leaves, Is.EqualTo(2));
        }

        [Test]
        public void Build_ThreeTrianglesAtAnEdge_PairsTwo()
        {
            var leaf = new TriangleMesh(
                new[] { float3(0, 0, 0), float3(1, 0, 0), float3(0, 1, 0), float3(1, 1.1f, 0), float3(1, 1.2f, 0.1f) },
                new[] { 0, 1, 2, 1, 2, 3, 2, 1, 4 });
            Assert.That(MeshBvhReader.Check(leaf, _layout).Leaves, Is.EqualTo(2));
        }

        [Test]
        public void MaxLeaves_WithNodesAndNumbers_FitInAPart()
        {
            // Nodes and leaves of 3 rows, then a row with the triangles' numbers of two leaves or of two records.
            long leaves = BvhRows.MaxLeaves(_layout), nodes = leaves - 1;
            long rows = _layout == BvhLayout.Binary
                ? 1 + 3 * nodes + 3 * leaves + (leaves + 1) / 2
                : 3 * (nodes + leaves) + (nodes + leaves + 1) / 2;
            Assert.That(16 * rows, Is.LessThanOrEqualTo(96 << 20));
        }

        [Test]
        public void Build_PairsOrNoPairs_TakesAtMost120BytesATriangle([Values] bool paired)
        {
            var mesh = paired ? TestMeshes.Sea(200, 100) : TestMeshes.Apart(200, 200, step: 1);
            Assert.That(MeshBvhReader.Check(mesh, _layout).Bytes, Is.LessThanOrEqualTo(120L * mesh.TriangleCount));
        }

        [Test]
        public void Build_LargeMeshMostlyInAClump_IsCutIntoFewParts()
        {
            var mesh = TestMeshes.Clump(inside: 1_100_000, outside: 5000);
            var bvh = MeshBvh.Build(mesh, _layout);
            Assert.That(bvh.Parts.Length, Is.InRange(2, 8));
            Assert.That(bvh.Parts.Min(part => part.Rows.Length),
                Is.GreaterThan(bvh.Parts.Max(part => part.Rows.Length) / 16), "no part is a scrap");
            MeshBvhReader.Check(mesh, _layout, bvh);
        }

        [Test]
        public void Build_OnOneThreadOrSeveral_GivesTheSameBvh()
        {
            var mesh = TestRadar.Join(TestMeshes.Soup(TestMeshes.Sea(200, 150)), TestRadar.Clutter(20000, seed: 3));
            var several = MeshBvh.Build(mesh, _layout);
            var oneAtATime = new ConcurrentExclusiveSchedulerPair(TaskScheduler.Default, 1).ConcurrentScheduler;
            var one = Task.Factory.StartNew(() => MeshBvh.Build(mesh, _layout), CancellationToken.None,
                TaskCreationOptions.None, oneAtATime).Result;
            Assert.That(one.Parts.Length, Is.EqualTo(several.Parts.Length));
            for (int i = 0; i < one.Parts.Length; i++)
                Assert.That(one.Parts[i].Rows.SequenceEqual(several.Parts[i].Rows), $"words of part {i}");
        }
    }
}
