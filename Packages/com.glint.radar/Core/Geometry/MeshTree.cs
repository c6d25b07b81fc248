using System.Collections.Generic;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// The trees over a mesh: one, or several where a mesh is too large for one. A mesh without triangles has none.
    /// </summary>
    public sealed class MeshTree
    {
        const int MostCoverBoxes = 64;

        MeshTree()
        {
        }

        /// <summary>The trees; together they hold every triangle that reflects, each once.</summary>
        public TreePart[] Parts { get; private set; }

        /// <summary>Lower corner of the box around all triangles, metres.</summary>
        public float3 Low { get; private set; }

        /// <summary>Upper corner of the same box, metres.</summary>
        public float3 High { get; private set; }

        /// <summary>Lower corners of at most 64 boxes that together hold all triangles, metres.</summary>
        public float3[] CoverLow { get; private set; }

        /// <summary>Upper corners of the same boxes, metres.</summary>
        public float3[] CoverHigh { get; private set; }

        /// <summary>Triangles in the trees. Those that reflect nothing are not.</summary>
        public int TriangleCount { get; private set; }

        /// <summary>
        /// Builds the trees of a mesh whose coordinates are finite. The same mesh always gives the same trees.
        /// </summary>
        /// <exception cref="System.OperationCanceledException">
        /// Cancelled: a tenth of a second later per million triangles at most.
        /// </exception>
        public static MeshTree Build(TriangleMesh mesh, TreeShape shape, CancellationToken cancel = default)
        {
            var pairs = TrianglePairs.Find(mesh, cancel);
            int leavesPerPart = TreeRows.MostLeaves(shape);
            var tree = BoxTreeBuilder.Build(BoxesOf(mesh.Vertices, pairs), leavesPerPart, cancel);
            var roots = PartRoots(tree, leavesPerPart);
            var parts = new TreePart[roots.Count];
            var writer = new PairWriter(mesh.Vertices, pairs);
            Parallel.For(0, parts.Length, new ParallelOptions { CancellationToken = cancel }, part =>
            {
                var box = tree.BoxOf(roots[part]);
                parts[part] = new TreePart
                {
                    Words = TreeRows.Encode(tree, roots[part], shape, writer), Low = box.Low, High = box.High
                };
            });
            var cover = Cover(tree);
            return new MeshTree
            {
                Parts = parts,
                Low = tree.Leaves.Length > 0 ? tree.BoxOf(tree.Root).Low : 0,
                High = tree.Leaves.Length > 0 ? tree.BoxOf(tree.Root).High : 0,
                CoverLow = cover.Select(box => box.Low).ToArray(),
                CoverHigh = cover.Select(box => box.High).ToArray(),
                TriangleCount = pairs.Sum(pair => pair.z == pair.w ? 1 : 2),
            };
        }

        /// <summary>Triangles of a mesh that its trees would hold.</summary>
        public static int CountReflecting(TriangleMesh mesh) => TrianglePairs.CountReflecting(mesh);

        /// <summary>Rows of 16 bytes that a triangle takes at least: all triangles in pairs, all nodes full.</summary>
        public static double LeastRowsPerTriangle(TreeShape shape) => TreeRows.LeastRowsPerLeaf(shape) / 2;

        static BoxLeaf[] BoxesOf(float3[] vertices, int4[] pairs)
        {
            var leaves = new BoxLeaf[pairs.Length];
            Blocks.For(leaves.Length, (from, to) =>
            {
                for (int i = from; i < to; i++)
                {
                    var box = Box.Empty;
                    box.Add(vertices[pairs[i].x]);
                    box.Add(vertices[pairs[i].y]);
                    box.Add(vertices[pairs[i].z]);
                    box.Add(vertices[pairs[i].w]);
                    leaves[i] = new BoxLeaf { Box = box, Item = i };
                }
            });
            return leaves;
        }

        // The largest subtrees that fit into a part, from left to right.
        static List<int> PartRoots(BoxTree tree, int leavesPerPart)
        {
            var roots = new List<int>();
            if (tree.Leaves.Length == 0)
                return roots;
            var open = new Stack<int>();
            open.Push(tree.Root);
            while (open.Count > 0)
            {
                int subtree = open.Pop();
                if (tree.LeafCount(subtree) <= leavesPerPart)
                {
                    roots.Add(subtree);
                    continue;
                }
                open.Push(tree.Right(subtree));
                open.Push(tree.Left(subtree));
            }
            return roots;
        }

        // The boxes left when the largest inner node is opened again and again.
        static List<Box> Cover(BoxTree tree)
        {
            var subtrees = new List<int>();
            if (tree.Leaves.Length > 0)
                subtrees.Add(tree.Root);
            while (subtrees.Count < MostCoverBoxes && subtrees.Any(subtree => subtree >= 0))
            {
                int largest = -1;
                for (int i = 0; i < subtrees.Count; i++)
                    if (subtrees[i] >= 0
                        && (largest < 0 || tree.BoxOf(subtrees[i]).HalfArea > tree.BoxOf(subtrees[largest]).HalfArea))
                        largest = i;
                subtrees.Add(tree.Right(subtrees[largest]));
                subtrees[largest] = tree.Left(subtrees[largest]);
            }
            return subtrees.ConvertAll(tree.BoxOf);
        }
    }
}
