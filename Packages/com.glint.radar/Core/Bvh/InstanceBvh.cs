using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>The top-level BVH, over the boxes of instances, with the nodes of a mesh BVH.</summary>
    public static class InstanceBvh
    {
        /// <summary>Minimum number of rows of a box, with its share of the nodes.</summary>
        public static double MinRowsPerBox(BvhLayout layout) => BvhRows.MinRowsPerLeaf(layout, hasIdentity: false);

        /// <summary>
        /// Rows of 16 bytes of the BVH over the boxes;
        /// a leaf holds a box's number in its first component. No boxes: no rows.
        /// </summary>
        public static uint4[] Build(float3[] boxMins, float3[] boxMaxes, BvhLayout layout)
        {
            if (boxMins.Length == 0)
                return new uint4[0];
            int max = BvhRows.MaxLeaves(layout);
            if (boxMins.Length > max)
                throw new GlintException($"the scene has {boxMins.Length} meshes or parts of meshes, "
                    + $"more than the {max} that one BVH holds; join small meshes");
            var leaves = new BvhLeaf[boxMins.Length];
            for (int i = 0; i < leaves.Length; i++)
                leaves[i] = new BvhLeaf { Box = new Box(boxMins[i], boxMaxes[i]), Item = i };
            var bvh = BinaryBvhBuilder.Build(leaves, max);
            return BvhRows.Encode(bvh, bvh.Root, layout, new NumberWriter(), out _, out _);
        }

        /// <summary>
        /// Writes moved boxes into rows of <see cref="BvhLayout.Binary"/>. It allocates nothing. The tree stays that of
        /// the boxes before: rays visit more nodes the farther boxes have moved.
        /// </summary>
        public static void Refit(uint4[] rows, float3[] boxMins, float3[] boxMaxes) =>
            BinaryEncoder.Refit(rows, boxMins, boxMaxes);
    }

    /// <summary>Leaves of a BVH over instances: their numbers.</summary>
    sealed class NumberWriter : ILeafWriter
    {
        public int IdentityRows(int records) => 0;

        public void Write(int item, uint4[] rows, int row, int record, int firstIdentityRow) =>
            rows[row].x = (uint)item;
    }
}
