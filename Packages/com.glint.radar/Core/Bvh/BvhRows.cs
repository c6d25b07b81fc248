using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>BVHs as the kernel reads them.</summary>
    static class BvhRows
    {
        // A BVH stays within the 128 MiB that the smallest devices let one binding hold,
        // and a record's number within 20 bits.
        const int MaxRows = 96 << 20 >> 4;
        const int MaxRecords = 1 << 20;

        /// <summary>Most leaves of one BVH.</summary>
        public static int MaxLeaves(BvhLayout layout) =>
            layout == BvhLayout.Wide ? WideEncoder.MaxLeaves(MaxRecords) : BinaryEncoder.MaxLeaves(MaxRows);

        /// <summary>Rows that a leaf takes at least, with its share of the nodes when these are full.</summary>
        public static double MinRowsPerLeaf(BvhLayout layout) =>
            layout == BvhLayout.Wide ? WideEncoder.MinRowsPerLeaf : BinaryEncoder.MinRowsPerLeaf;

        /// <summary>The rows of a subtree with at most <see cref="MaxLeaves"/> leaves.</summary>
        public static uint4[] Encode(BinaryBvh bvh, int root, BvhLayout layout, ILeafWriter writer) =>
            layout == BvhLayout.Wide ? WideEncoder.Encode(bvh, root, writer) : BinaryEncoder.Encode(bvh, root, writer);
    }

    /// <summary>Writes the leaves of a BVH as the kernel reads them.</summary>
    interface ILeafWriter
    {
        /// <summary>
        /// Writes item <paramref name="item"/> into three rows from <paramref name="row"/> on; they are 0 before.
        /// </summary>
        void Write(int item, uint4[] rows, int row);
    }
}
