using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>A tree over boxes, such as those of instances, in the nodes of a mesh's tree.</summary>
    public static class TopTree
    {
        /// <summary>Rows that a box takes at least, with its share of the nodes.</summary>
        public static double LeastRowsPerBox(TreeShape shape) => TreeRows.LeastRowsPerLeaf(shape);

        /// <summary>
        /// Rows of 16 bytes of the tree over the boxes;
        /// a leaf holds a box's number in its first component. No boxes: no rows.
        /// </summary>
        public static uint4[] Build(float3[] low, float3[] high, TreeShape shape)
        {
            if (low.Length == 0)
                return new uint4[0];
            int most = TreeRows.MostLeaves(shape);
            if (low.Length > most)
                throw new GlintException($"the scene has {low.Length} meshes or parts of meshes, "
                    + $"more than the {most} that one tree holds; join small meshes");
            var leaves = new BoxLeaf[low.Length];
            for (int i = 0; i < leaves.Length; i++)
                leaves[i] = new BoxLeaf { Box = new Box(low[i], high[i]), Item = i };
            var tree = BoxTreeBuilder.Build(leaves, most);
            return TreeRows.Encode(tree, tree.Root, shape, new NumberWriter());
        }
    }
}
