using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    [TestFixture(TreeShape.Binary)]
    [TestFixture(TreeShape.Wide)]
    public sealed class TopTreeTests
    {
        readonly TreeShape _shape;

        public TopTreeTests(TreeShape shape) => _shape = shape;

        [TestCase(1)]
        [TestCase(2)]
        [TestCase(3)]
        [TestCase(1009)]
        [TestCase(100000)]
        public void Build_Boxes_EveryBoxIsInOneLeaf(int count)
        {
            var random = new System.Random(count);
            float Next() => (float)(2000 * random.NextDouble() - 1000);
            var low = Enumerable.Range(0, count).Select(i => float3(Next(), Next(), Next())).ToArray();
            Check(low, low.Select(place => place + abs(float3(Next(), Next(), Next()))).ToArray());
        }

        [Test]
        public void Build_NoBoxes_HasNoRows() =>
            Assert.That(TopTree.Build(new float3[0], new float3[0], _shape), Is.Empty);

        [Test]
        public void Build_BoxesWithoutSizeAtOnePlace_StillSplits()
        {
            var places = Enumerable.Repeat(float3(1, 2, 3), 3000).ToArray();
            Check(places, places);
        }

        [Test]
        public void Build_SizesGrowingByPowersOfTwo_StaysWithinTheStacksOfTheKernels()
        {
            // Each box is as large as all before it: a plain surface area heuristic would cut off a few at a time,
            // and come to the bulk at the small end last.
            var sizes = Enumerable.Range(0, 60000)
                .Select(i => (float)Math.Pow(2, Math.Max(-60, i / 2 % 6000 - 5880) + 1e-4 * (i % 1000))).ToArray();
            int levels = Check(sizes.Select(size => float3(size)).ToArray(),
                sizes.Select(size => float3(1.5f * size)).ToArray());
            Assert.That(levels, Is.GreaterThan(_shape == TreeShape.Wide ? 10 : 24), "the case is a hard one");
        }

        int Check(float3[] low, float3[] high)
        {
            var rows = TopTree.Build(low, high, _shape);
            var seen = new bool[low.Length];
            var tree = TreeReader.Read(rows, _shape, row =>
            {
                int item = (int)rows[row].x;
                if (seen[item] || any(rows[row].yzw != 0) || any(rows[row + 1] != 0) || any(rows[row + 2] != 0))
                    Assert.Fail($"leaf at row {row}");
                seen[item] = true;
                return new Bounds3 { Low = low[item], High = high[item] };
            });
            Assert.That(seen.Count(one => !one), Is.Zero, "boxes in no leaf");
            Assert.That(tree.Levels, Is.LessThanOrEqualTo(_shape == TreeShape.Wide ? 16 : 32), "levels");
            return tree.Levels;
        }
    }
}
