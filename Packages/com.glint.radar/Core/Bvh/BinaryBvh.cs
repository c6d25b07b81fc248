using System;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Core
{
    /// <summary>
    /// A binary BVH over boxes with one box a leaf. n leaves always have n - 1 inner nodes, so the position of each
    /// node is known before the BVH is built: a node precedes its left subtree, which precedes the right subtree.
    /// Cores that build subtrees therefore need no synchronisation.
    /// A child is the number of an inner node, or ~ (the complement of) the number of a leaf.
    /// </summary>
    sealed class BinaryBvh
    {
        public BinaryBvh(BvhLeaf[] leaves)
        {
            Leaves = leaves;
            Nodes = new BinaryNode[Math.Max(0, leaves.Length - 1)];
        }

        /// <summary>Leaves from left to right.</summary>
        public BvhLeaf[] Leaves { get; }

        public BinaryNode[] Nodes { get; }

        /// <summary>The root of a BVH that is not empty.</summary>
        public int Root => Nodes.Length > 0 ? 0 : ~0;

        public int Left(int node) => Nodes[node].LeftCount == 1 ? ~Nodes[node].First : node + 1;

        public int Right(int node)
        {
            int left = Nodes[node].LeftCount;
            return Nodes[node].Count - left == 1 ? ~(Nodes[node].First + left) : node + left;
        }

        public Box BoxOf(int child) => child < 0 ? Leaves[~child].Box : Nodes[child].Box;

        /// <summary>
        /// Metres by which stored boxes are larger on each side. float32 rays deviate from the true rays by some
        /// ten-millionths (ERROR_PER_SEGMENT in the kernels) of the lengths and coordinates of a segment.
        /// </summary>
        public double Margin => MarginOf(BoxOf(Root));

        /// <summary>The same of a BVH with a box around all.</summary>
        public static double MarginOf(in Box all)
        {
            double3 boxMin = all.Min, boxMax = all.Max;
            return 4e-6 * cmax(boxMax - boxMin) + 4e-7 * cmax(max(abs(boxMin), abs(boxMax)));
        }

        public int FirstLeaf(int child) => child < 0 ? ~child : Nodes[child].First;

        public int LeafCount(int child) => child < 0 ? 1 : Nodes[child].Count;
    }

    /// <summary>An inner node of a <see cref="BinaryBvh"/>.</summary>
    struct BinaryNode
    {
        public Box Box;

        /// <summary>Index of its first leaf.</summary>
        public int First;

        /// <summary>Number of its leaves, at least 2.</summary>
        public int Count;

        /// <summary>Number of leaves of the left child, which come first.</summary>
        public int LeftCount;
    }

    /// <summary>An item of a BVH: its box and its number.</summary>
    struct BvhLeaf
    {
        public Box Box;

        public int Item;
    }
}
