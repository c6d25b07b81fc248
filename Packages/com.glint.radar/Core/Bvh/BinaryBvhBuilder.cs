using System;
using System.Threading;
using System.Threading.Tasks;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// Builds a <see cref="BinaryBvh"/> from the root down by the surface area heuristic.
    /// The BVH does not depend on the number of cores.
    /// </summary>
    sealed class BinaryBvhBuilder
    {
        /// <summary>Maximum number of inner levels of a part: the stack size of the kernels.</summary>
        public const int MaxLevels = 28;

        // Above parts, the smaller side of a split gets at least 1 / this of the leaves, which keeps the number of
        // parts low.
        const int MinFractionOfParts = 8;

        // Subtrees of more leaves are built in parallel.
        const int ParallelFrom = 8192;

        readonly BinaryBvh _bvh;
        readonly BvhLeaf[] _leaves;
        readonly int _leavesPerPart;
        readonly ParallelOptions _parallel;

        BinaryBvhBuilder(BvhLeaf[] leaves, int leavesPerPart, CancellationToken cancel)
        {
            _leaves = leaves;
            _leavesPerPart = leavesPerPart;
            _bvh = new BinaryBvh(leaves);
            _parallel = new ParallelOptions { CancellationToken = cancel };
        }

        /// <summary>
        /// Builds the BVH and orders <paramref name="leaves"/>. A subtree with at most
        /// <paramref name="leavesPerPart"/> leaves, a part, has at most <see cref="MaxLevels"/> inner levels.
        /// </summary>
        /// <exception cref="OperationCanceledException">Cancelled; the leaves are in any order.</exception>
        public static BinaryBvh Build(BvhLeaf[] leaves, int leavesPerPart, CancellationToken cancel = default)
        {
            var builder = new BinaryBvhBuilder(leaves, leavesPerPart, cancel);
            if (leaves.Length > 1)
                builder.BuildNode(0, 0, leaves.Length, builder.Measure(0, leaves.Length), MaxLevels, new SplitFinder());
            return builder._bvh;
        }

        // Inner node over _leaves[first .. first + count), which may have this many inner levels, itself included.
        void BuildNode(int node, int first, int count, in BoxExtent extent, int levels, SplitFinder finder)
        {
            bool abovePart = count > _leavesPerPart;
            int levelsBelow = abovePart ? MaxLevels : levels - 1;
            // Maximum number of leaves of a side that fit into the remaining levels.
            int maxPerSide = abovePart ? count - count / MinFractionOfParts : 1 << Math.Min(30, levelsBelow);
            int left = Split(first, count, extent, maxPerSide, finder, out var leftExtent, out var rightExtent);
            _bvh.Nodes[node] = new BinaryNode { Box = extent.Box, First = first, Count = count, LeftCount = left };
            if (count > ParallelFrom)
                BuildBoth(node, leftExtent, rightExtent, levelsBelow);
            else
            {
                if (left > 1)
                    BuildNode(node + 1, first, left, leftExtent, levelsBelow, finder);
                if (count - left > 1)
                    BuildNode(node + left, first + left, count - left, rightExtent, levelsBelow, finder);
            }
        }

        void BuildBoth(int node, BoxExtent leftExtent, BoxExtent rightExtent, int levelsBelow)
        {
            int first = _bvh.Nodes[node].First, left = _bvh.Nodes[node].LeftCount,
                right = _bvh.Nodes[node].Count - left;
            Parallel.Invoke(
                _parallel,
                () =>
                {
                    if (left > 1)
                        BuildNode(node + 1, first, left, leftExtent, levelsBelow, new SplitFinder());
                },
                () =>
                {
                    if (right > 1)
                        BuildNode(node + left, first + left, right, rightExtent, levelsBelow, new SplitFinder());
                });
        }

        // Orders a node's leaves into a left and a right side and returns the size of the left one.
        int Split(int first, int count, in BoxExtent extent, int maxPerSide, SplitFinder finder,
            out BoxExtent leftExtent, out BoxExtent rightExtent)
        {
            if (count > 2 && finder.Find(_leaves, first, count, extent.Centres, maxPerSide))
            {
                int left = Partition(first, count, finder, out leftExtent, out rightExtent);
                // Guards against runtimes that round differently here than when the bins were filled.
                if (Math.Min(left, count - left) > 0 && Math.Max(left, count - left) <= maxPerSide)
                    return left;
            }
            int half = count / 2;
            if (count > 2)
                LeafSelection.PutMedianInPlace(_leaves, first, count, extent.LongestAxis);
            leftExtent = Measure(first, half);
            rightExtent = Measure(first + half, count - half);
            return half;
        }

        int Partition(int first, int count, SplitFinder finder, out BoxExtent leftExtent, out BoxExtent rightExtent)
        {
            leftExtent = rightExtent = BoxExtent.Empty;
            int left = first, right = first + count - 1;
            while (left <= right)
            {
                if (finder.IsLeft(_leaves[left].Box))
                    leftExtent.Add(_leaves[left++].Box);
                else
                {
                    rightExtent.Add(_leaves[left].Box);
                    (_leaves[left], _leaves[right]) = (_leaves[right], _leaves[left]);
                    right--;
                }
            }
            return left - first;
        }

        BoxExtent Measure(int first, int count)
        {
            var extent = BoxExtent.Empty;
            for (int i = first; i < first + count; i++)
                extent.Add(_leaves[i].Box);
            return extent;
        }
    }

    /// <summary>The box around some boxes, and the box around their centres.</summary>
    struct BoxExtent
    {
        public Box Box;

        /// <summary>In coordinates twice as large: a centre is the sum of a box's corners.</summary>
        public Box Centres;

        public static BoxExtent Empty => new BoxExtent { Box = Box.Empty, Centres = Box.Empty };

        public readonly int LongestAxis
        {
            get
            {
                var size = Centres.Max - Centres.Min;
                return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
            }
        }

        public void Add(in Box box)
        {
            Box.Add(box);
            Centres.Add(new float3(box.Min.x + box.Max.x, box.Min.y + box.Max.y, box.Min.z + box.Max.z));
        }
    }

    /// <summary>
    /// Quickselect: moves the median of some leaves, by their centres, to the position it has in sorted order.
    /// Linear time.
    /// </summary>
    static class LeafSelection
    {
        /// <summary>
        /// Afterwards no centre before index <paramref name="first"/> + <paramref name="count"/> / 2 is
        /// above one from there on.
        /// </summary>
        public static void PutMedianInPlace(BvhLeaf[] leaves, int first, int count, int axis)
        {
            int left = first, right = first + count - 1, mid = first + count / 2;
            while (left < right)
            {
                float pivot = MedianOfThree(Centre(leaves, left, axis), Centre(leaves, left + (right - left) / 2, axis),
                    Centre(leaves, right, axis));
                int i = left, j = right;
                while (i <= j)
                {
                    while (Centre(leaves, i, axis) < pivot)
                        i++;
                    while (Centre(leaves, j, axis) > pivot)
                        j--;
                    if (i > j)
                        break;
                    (leaves[i], leaves[j]) = (leaves[j], leaves[i]);
                    i++;
                    j--;
                }
                // Up to j: at most the pivot. From i on: at least the pivot. Between them: the pivot.
                if (mid <= j)
                    right = j;
                else if (mid >= i)
                    left = i;
                else
                    return;
            }
        }

        static float Centre(BvhLeaf[] leaves, int index, int axis) =>
            leaves[index].Box.Min[axis] + leaves[index].Box.Max[axis];

        static float MedianOfThree(float a, float b, float c) =>
            a < b ? b < c ? b : a < c ? c : a : a < c ? a : b < c ? c : b;
    }
}
