using System;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Core
{
    /// <summary>Builds a tree by the surface area heuristic over bins of triangle centres.</summary>
    public sealed class BvhBuilder
    {
        const int Bins = 16;

        // Cost of visiting a node, in triangle tests.
        const float NodeCost = 1;

        readonly Box[] _boxes;
        readonly float3[] _centres;
        readonly int[] _order;
        readonly BvhNode[] _nodes;
        readonly Box[] _binBoxes = new Box[Bins];
        readonly int[] _binCounts = new int[Bins];
        readonly float[] _leftCosts = new float[Bins];
        int _nodeCount;

        BvhBuilder(TriangleMesh scene)
        {
            int count = scene.TriangleCount;
            _boxes = new Box[count];
            _centres = new float3[count];
            _order = new int[count];
            _nodes = new BvhNode[Math.Max(0, 2 * count - 1)];
            for (int i = 0; i < count; i++)
            {
                scene.GetTriangle(i, out var a, out var b, out var c);
                _boxes[i] = new Box(min(a, min(b, c)), max(a, max(b, c)));
                _centres[i] = 0.5f * _boxes[i].Min + 0.5f * _boxes[i].Max;
                _order[i] = i;
            }
        }

        /// <summary>The tree of a scene whose coordinates are finite.</summary>
        public static Bvh Build(TriangleMesh scene)
        {
            var builder = new BvhBuilder(scene);
            if (scene.TriangleCount > 0)
            {
                builder._nodeCount = 1;
                builder.BuildNode(0, 0, scene.TriangleCount, Bvh.MaxDepth - 1);
            }
            var nodes = new BvhNode[builder._nodeCount];
            Array.Copy(builder._nodes, nodes, nodes.Length);
            return new Bvh(nodes, builder._order);
        }

        // Node over _order[first .. first + count), with this many levels left below it.
        void BuildNode(int node, int first, int count, int levelsLeft)
        {
            var box = Box.Empty;
            var centres = Box.Empty;
            for (int i = first; i < first + count; i++)
            {
                box.Add(_boxes[_order[i]]);
                centres.Add(_centres[_order[i]]);
            }
            _nodes[node] = new BvhNode { Min = box.Min, Max = box.Max, First = (uint)first, Count = (uint)count };

            int left = Split(first, count, box, centres, levelsLeft);
            if (left == 0)
                return;
            int child = _nodeCount;
            _nodeCount += 2;
            _nodes[node].First = (uint)child;
            _nodes[node].Count = 0;
            BuildNode(child, first, left, levelsLeft - 1);
            BuildNode(child + 1, first + left, count - left, levelsLeft - 1);
        }

        // Orders the node's triangles into a left and a right part and returns the size of the left one; 0 for a leaf.
        int Split(int first, int count, in Box box, in Box centres, int levelsLeft)
        {
            if (count == 1)
                return 0;
            // Halving is the only split that is sure to end within the levels left.
            if (HalvingsToLeaf(count) >= levelsLeft)
                return count <= Bvh.MaxLeafSize ? 0 : count / 2;

            float bestCost = float.PositiveInfinity;
            int bestAxis = 0, bestBin = 0;
            for (int axis = 0; axis < 3; axis++)
                if (centres.Max[axis] > centres.Min[axis])
                    FindCheapestPlane(first, count, centres, axis, ref bestCost, ref bestAxis, ref bestBin);

            float area = box.HalfArea;
            bool leafIsCheaper = !(NodeCost * area + bestCost < count * area);
            if (count <= Bvh.MaxLeafSize && leafIsCheaper)
                return 0;
            if (float.IsPositiveInfinity(bestCost))
                return count / 2; // all centres coincide
            return Partition(first, count, centres, bestAxis, bestBin);
        }

        static int HalvingsToLeaf(int count)
        {
            int halvings = 0;
            for (long size = Bvh.MaxLeafSize; size < count; size *= 2)
                halvings++;
            return halvings;
        }

        // Cost of a plane: area times triangles on each side of it, in tests per ray that reaches area 1.
        void FindCheapestPlane(int first, int count, in Box centres, int axis, ref float bestCost, ref int bestAxis, ref int bestBin)
        {
            Array.Clear(_binCounts, 0, Bins);
            for (int bin = 0; bin < Bins; bin++)
                _binBoxes[bin] = Box.Empty;
            for (int i = first; i < first + count; i++)
            {
                int bin = BinOf(_order[i], centres, axis);
                _binCounts[bin]++;
                _binBoxes[bin].Add(_boxes[_order[i]]);
            }

            var left = Box.Empty;
            int leftCount = 0;
            for (int bin = 0; bin < Bins - 1; bin++)
            {
                left.Add(_binBoxes[bin]);
                leftCount += _binCounts[bin];
                _leftCosts[bin] = leftCount == 0 ? float.PositiveInfinity : left.HalfArea * leftCount;
            }
            var right = Box.Empty;
            int rightCount = 0;
            for (int bin = Bins - 1; bin > 0; bin--)
            {
                right.Add(_binBoxes[bin]);
                rightCount += _binCounts[bin];
                if (rightCount == 0 || rightCount == count)
                    continue;
                float cost = _leftCosts[bin - 1] + right.HalfArea * rightCount;
                if (cost < bestCost)
                {
                    bestCost = cost;
                    bestAxis = axis;
                    bestBin = bin;
                }
            }
        }

        int BinOf(int triangle, in Box centres, int axis)
        {
            float low = centres.Min[axis];
            float place = (_centres[triangle][axis] - low) / (centres.Max[axis] - low) * Bins;
            return place < Bins - 1 ? Math.Max(0, (int)place) : Bins - 1;
        }

        // Puts triangles of bins below the given one first; returns how many.
        int Partition(int first, int count, in Box centres, int axis, int bin)
        {
            int left = first, right = first + count - 1;
            while (left <= right)
            {
                if (BinOf(_order[left], centres, axis) < bin)
                    left++;
                else
                    (_order[left], _order[right]) = (_order[right--], _order[left]);
            }
            int size = left - first;
            // A runtime may compute with more digits here than when the bins were filled.
            return size == 0 || size == count ? count / 2 : size;
        }

        struct Box
        {
            public float3 Min, Max;

            public Box(float3 low, float3 high)
            {
                Min = low;
                Max = high;
            }

            public static Box Empty => new Box(float.PositiveInfinity, float.NegativeInfinity);

            public float HalfArea
            {
                get
                {
                    var size = Max - Min;
                    return size.x * size.y + size.y * size.z + size.z * size.x;
                }
            }

            public void Add(float3 point)
            {
                Min = min(Min, point);
                Max = max(Max, point);
            }

            public void Add(in Box other)
            {
                Min = min(Min, other.Min);
                Max = max(Max, other.Max);
            }
        }
    }
}
