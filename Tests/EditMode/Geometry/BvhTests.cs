using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    public sealed class BvhTests
    {
        [TestCase(1)]
        [TestCase(4)]
        [TestCase(5)]
        [TestCase(1009)] // a prime: no level of the tree divides evenly
        public void Build_RandomTriangles_EveryTriangleIsInOneLeafAndEveryBoxHoldsItsChildren(int count) =>
            Check(TestRadar.Clutter(count, seed: 1));

        [Test]
        public void Build_NoTriangles_HasNoNodes() => Assert.That(BvhBuilder.Build(TestRadar.Empty).Nodes, Is.Empty);

        [Test]
        public void Build_CoincidentTriangles_StillSplitsIntoSmallLeaves()
        {
            var corners = Enumerable.Range(0, 300).Select(i => float3(i % 3, i % 3 == 2 ? 1 : 0, 0)).ToArray();
            Check(new TriangleMesh(corners, Enumerable.Range(0, 300).ToArray()));
        }

        [Test]
        public void Build_SizesGrowingByPowersOfTwo_StaysWithinTheDepthOfTheKernelsStack()
        {
            // Each triangle is as large as all before it: a plain surface area heuristic would cut off one at a time.
            Check(TestRadar.PowersOfTwo(2000, sizes: 120));
        }

        [Test]
        public void Build_CoordinatesNearTheLargestFloat_EndsWithEveryTriangleInOneLeaf()
        {
            var corners = Enumerable.Range(0, 99).Select(i => (i % 2 == 0 ? 1 : -1) * float3(3e38f, i, 1e30f * i)).ToArray();
            Check(new TriangleMesh(corners, Enumerable.Range(0, 99).ToArray()));
        }

        [Test]
        public void Records_TriangleTooLargeForAFiniteArea_HasEdgesOfLengthZero()
        {
            var scene = new TriangleMesh(new[] { float3(0, 0, 0), float3(2e10f, 0, 0), float3(0, 2e10f, 0) }, new[] { 0, 1, 2 });
            Assert.That(BvhBuilder.Build(scene).Records(scene).Single().Edge1, Is.EqualTo(default(float3)));
        }

        [Test]
        public void Records_TriangleWithoutArea_HasEdgesOfLengthZeroSoThatNothingHitsIt()
        {
            var scene = new TriangleMesh(new[] { float3(0, 0, 0), float3(1, 1, 1), float3(2, 2, 2) }, new[] { 0, 1, 2 });
            var record = BvhBuilder.Build(scene).Records(scene).Single();
            Assert.That(record.Edge1, Is.EqualTo(default(float3)));
            Assert.That(record.Edge2, Is.EqualTo(default(float3)));
        }

        static void Check(TriangleMesh scene)
        {
            var bvh = BvhBuilder.Build(scene);
            Assert.That(bvh.TriangleOrder.OrderBy(t => t), Is.EqualTo(Enumerable.Range(0, scene.TriangleCount)), "every triangle once");
            var visited = new bool[scene.TriangleCount];
            int nodes = CheckNode(scene, bvh, 0, 1, visited);
            Assert.That(nodes, Is.EqualTo(bvh.Nodes.Length), "every node is reached");
            Assert.That(visited, Is.All.True, "every triangle is in a leaf");
        }

        static int CheckNode(TriangleMesh scene, Bvh bvh, int index, int level, bool[] visited)
        {
            Assert.That(level, Is.LessThanOrEqualTo(Bvh.MaxDepth), "levels");
            var node = bvh.Nodes[index];
            if (!node.IsLeaf)
            {
                int left = (int)node.First;
                foreach (int child in new[] { left, left + 1 })
                    Assert.That(all(bvh.Nodes[child].Min >= node.Min) && all(bvh.Nodes[child].Max <= node.Max), $"node {index} holds its child {child}");
                return 1 + CheckNode(scene, bvh, left, level + 1, visited) + CheckNode(scene, bvh, left + 1, level + 1, visited);
            }
            Assert.That(node.Count, Is.LessThanOrEqualTo(Bvh.MaxLeafSize), "triangles of a leaf");
            for (uint i = node.First; i < node.First + node.Count; i++)
            {
                Assert.That(visited[i], Is.False, $"place {i} is in one leaf only");
                visited[i] = true;
                scene.GetTriangle(bvh.TriangleOrder[i], out var a, out var b, out var c);
                foreach (var corner in new[] { a, b, c })
                    Assert.That(all(corner >= node.Min) && all(corner <= node.Max), $"leaf {index} holds its triangle {bvh.TriangleOrder[i]}");
            }
            return 1;
        }
    }
}
