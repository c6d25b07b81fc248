using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    [TestFixture(BvhLayout.Binary)]
    [TestFixture(BvhLayout.Wide)]
    public sealed class InstanceBvhTests
    {
        readonly BvhLayout _layout;

        public InstanceBvhTests(BvhLayout layout) => _layout = layout;

        [TestCase(1)]
        [TestCase(2)]
        [TestCase(3)]
        [TestCase(1009)]
        [TestCase(100000)]
        public void Build_Boxes_EveryBoxIsInOneLeaf(int count)
        {
            var random = new System.Random(count);
            float Next() => (float)(2000 * random.NextDouble() - 1000);
            var boxMins = Enumerable.Range(0, count).Select(i => float3(Next(), Next(), Next())).ToArray();
            Check(boxMins, boxMins.Select(position => position + abs(float3(Next(), Next(), Next()))).ToArray());
        }

        [Test]
        public void Build_NoBoxes_HasNoRows() =>
            Assert.That(InstanceBvh.Build(new float3[0], new float3[0], _layout), Is.Empty);

        [Test]
        public void Build_BoxesWithoutSizeAtOnePlace_StillSplits()
        {
            var positions = Enumerable.Repeat(float3(1, 2, 3), 3000).ToArray();
            Check(positions, positions);
        }

        [Test]
        public void Build_SizesGrowingByPowersOfTwo_StaysWithinTheStacksOfTheKernels()
        {
            // Each box is as large as all before it. A plain surface area heuristic would split off a few at a time,
            // and reach the bulk at the small end last.
            var sizes = Enumerable.Range(0, 60000)
                .Select(i => (float)Math.Pow(2, Math.Max(-60, i / 2 % 6000 - 5880) + 1e-4 * (i % 1000))).ToArray();
            int levels = Check(sizes.Select(size => float3(size)).ToArray(),
                sizes.Select(size => float3(1.5f * size)).ToArray());
            Assert.That(levels, Is.GreaterThan(_layout == BvhLayout.Wide ? 10 : 24), "the case is a hard one");
        }

        int Check(float3[] boxMins, float3[] boxMaxes)
        {
            var rows = InstanceBvh.Build(boxMins, boxMaxes, _layout);
            var seen = new bool[boxMins.Length];
            var bvh = BvhReader.Read(rows, _layout, row =>
            {
                int item = (int)rows[row].x;
                if (seen[item] || any(rows[row].yzw != 0) || any(rows[row + 1] != 0) || any(rows[row + 2] != 0))
                    Assert.Fail($"leaf at row {row}");
                seen[item] = true;
                return new Bounds3 { Min = boxMins[item], Max = boxMaxes[item] };
            });
            Assert.That(seen.Count(one => !one), Is.Zero, "boxes in no leaf");
            Assert.That(bvh.Levels, Is.LessThanOrEqualTo(_layout == BvhLayout.Wide ? 16 : 32), "levels");
            return bvh.Levels;
        }
    }
}
