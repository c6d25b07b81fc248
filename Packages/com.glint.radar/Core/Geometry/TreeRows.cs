using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>Trees as the kernel reads them.</summary>
    static class TreeRows
    {
        // A tree stays within the 128 MiB that the smallest devices let one binding hold,
        // and a record's number within 20 bits.
        const int MostRows = 96 << 20 >> 4;
        const int MostRecords = 1 << 20;

        /// <summary>Most leaves of one tree.</summary>
        public static int MostLeaves(TreeShape shape) =>
            shape == TreeShape.Wide ? WideEncoder.MostLeaves(MostRecords) : BinaryEncoder.MostLeaves(MostRows);

        /// <summary>Rows that a leaf takes at least, with its share of the nodes when these are full.</summary>
        public static double LeastRowsPerLeaf(TreeShape shape) =>
            shape == TreeShape.Wide ? WideEncoder.LeastRowsPerLeaf : BinaryEncoder.LeastRowsPerLeaf;

        /// <summary>The rows of a subtree with at most <see cref="MostLeaves"/> leaves.</summary>
        public static uint4[] Encode(BoxTree tree, int root, TreeShape shape, ILeafWriter writer) =>
            shape == TreeShape.Wide ? WideEncoder.Encode(tree, root, writer) : BinaryEncoder.Encode(tree, root, writer);
    }
}
