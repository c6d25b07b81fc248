using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>BVHs in the format of the kernels.</summary>
    static class BvhRows
    {
        // A BVH stays within the 128 MiB that the smallest devices let one binding hold,
        // and a record's number within 20 bits.
        const int MaxRows = 96 << 20 >> 4;
        const int MaxRecords = 1 << 20;

        /// <summary>Maximum number of leaves of one BVH.</summary>
        public static int MaxLeaves(BvhLayout layout) =>
            layout == BvhLayout.Wide ? WideEncoder.MaxLeaves(MaxRecords) : BinaryEncoder.MaxLeaves(MaxRows);

        /// <summary>Minimum number of rows of a leaf, with its share of full nodes.</summary>
        /// <param name="hasIdentity">With its half of an identity row.</param>
        public static double MinRowsPerLeaf(BvhLayout layout, bool hasIdentity)
        {
            double rows = layout == BvhLayout.Wide ? WideEncoder.MinRowsPerLeaf : BinaryEncoder.MinRowsPerLeaf;
            // The wide layout numbers its leaves among all records, of 3 rows each.
            double records = layout == BvhLayout.Wide ? rows / 3 : 1;
            return hasIdentity ? rows + records / 2 : rows;
        }

        /// <summary>The rows of a subtree with at most <see cref="MaxLeaves"/> leaves.</summary>
        /// <param name="firstRecordRow">Row of the record that leaves are numbered from.</param>
        /// <param name="firstIdentityRow">First of the rows behind the BVH that name what is in its leaves.</param>
        public static uint4[] Encode(BinaryBvh bvh, int root, BvhLayout layout, ILeafWriter writer,
            out int firstRecordRow, out int firstIdentityRow)
        {
            firstRecordRow = 0;
            return layout == BvhLayout.Wide
                ? WideEncoder.Encode(bvh, root, writer, out firstIdentityRow)
                : BinaryEncoder.Encode(bvh, root, writer, out firstRecordRow, out firstIdentityRow);
        }
    }

    /// <summary>Format of BVH nodes on the device.</summary>
    public enum BvhLayout
    {
        /// <summary>Two children a node, float boxes, 48 bytes: for GPUs.</summary>
        Binary,

        /// <summary>
        /// Up to four children a node, 8-bit boxes, 48 bytes: for software devices, where fetches cost most.
        /// </summary>
        Wide,
    }

    /// <summary>Writes the leaves of a BVH as the kernel reads them.</summary>
    interface ILeafWriter
    {
        /// <summary>Rows behind the BVH that name what is in its leaves.</summary>
        /// <param name="records">Records that leaves are numbered among.</param>
        int IdentityRows(int records);

        /// <summary>
        /// Writes item <paramref name="item"/> into three rows from <paramref name="row"/> on; they are 0 before.
        /// </summary>
        /// <param name="record">The leaf's number.</param>
        /// <param name="firstIdentityRow">First of the identity rows.</param>
        void Write(int item, uint4[] rows, int row, int record, int firstIdentityRow);
    }
}
