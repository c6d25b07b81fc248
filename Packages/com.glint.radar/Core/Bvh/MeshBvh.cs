using System.Collections.Generic;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Core
{
    /// <summary>
    /// The bottom-level BVHs over a mesh: one, or several for a mesh too large for one. A mesh without triangles has
    /// no BVH.
    /// </summary>
    public sealed class MeshBvh
    {
        const int MaxCoverBoxes = 64;

        MeshBvh()
        {
        }

        /// <summary>The BVHs; together they hold every triangle that reflects, each once.</summary>
        public BvhPart[] Parts { get; private set; }

        /// <summary>Lower corner of the box around all triangles, metres.</summary>
        public float3 Min { get; private set; }

        /// <summary>Upper corner of the same box, metres.</summary>
        public float3 Max { get; private set; }

        /// <summary>Lower corners of at most 64 boxes that together hold all triangles, metres.</summary>
        public float3[] CoverMin { get; private set; }

        /// <summary>Upper corners of the same boxes, metres.</summary>
        public float3[] CoverMax { get; private set; }

        /// <summary>Triangles in the BVHs, without those that reflect nothing.</summary>
        public int TriangleCount { get; private set; }

        /// <summary>
        /// Builds the BVHs of a mesh whose coordinates are finite. The same mesh always gives the same BVHs.
        /// </summary>
        /// <exception cref="System.OperationCanceledException">
        /// Cancelled, within a tenth of a second per million triangles.
        /// </exception>
        public static MeshBvh Build(TriangleMesh mesh, BvhLayout layout, CancellationToken cancel = default)
        {
            var pairs = TrianglePairs.Find(mesh, cancel);
            int leavesPerPart = BvhRows.MaxLeaves(layout);
            var bvh = BinaryBvhBuilder.Build(BoxesOf(mesh.Vertices, pairs), leavesPerPart, cancel);
            var roots = PartRoots(bvh, leavesPerPart);
            var parts = new BvhPart[roots.Count];
            var writer = new PairWriter(mesh.Vertices, pairs);
            Parallel.For(0, parts.Length, new ParallelOptions { CancellationToken = cancel }, part =>
            {
                var box = bvh.BoxOf(roots[part]);
                var rows = BvhRows.Encode(bvh, roots[part], layout, writer, out int firstRecord, out int identity);
                parts[part] = new BvhPart
                {
                    Rows = rows, FirstRecordRow = firstRecord, FirstIdentityRow = identity, Min = box.Min, Max = box.Max
                };
            });
            var cover = Cover(bvh);
            return new MeshBvh
            {
                Parts = parts,
                Min = bvh.Leaves.Length > 0 ? bvh.BoxOf(bvh.Root).Min : 0,
                Max = bvh.Leaves.Length > 0 ? bvh.BoxOf(bvh.Root).Max : 0,
                CoverMin = cover.Select(box => box.Min).ToArray(),
                CoverMax = cover.Select(box => box.Max).ToArray(),
                TriangleCount = pairs.Sum(pair => pair.IsSingle ? 1 : 2),
            };
        }

        /// <summary>Triangles of a mesh that its BVHs would hold.</summary>
        public static int CountReflecting(TriangleMesh mesh) => TrianglePairs.CountReflecting(mesh);

        /// <summary>Rows of 16 bytes that a triangle takes at least: all triangles in pairs, all nodes full.</summary>
        public static double MinRowsPerTriangle(BvhLayout layout) =>
            BvhRows.MinRowsPerLeaf(layout, hasIdentity: true) / 2;

        static BvhLeaf[] BoxesOf(float3[] vertices, TrianglePair[] pairs)
        {
            var leaves = new BvhLeaf[pairs.Length];
            Blocks.For(leaves.Length, (from, to) =>
            {
                for (int i = from; i < to; i++)
                {
                    var box = Box.Empty;
                    box.Add(vertices[pairs[i].Corners.x]);
                    box.Add(vertices[pairs[i].Corners.y]);
                    box.Add(vertices[pairs[i].Corners.z]);
                    box.Add(vertices[pairs[i].Corners.w]);
                    leaves[i] = new BvhLeaf { Box = box, Item = i };
                }
            });
            return leaves;
        }

        // The largest subtrees that fit into a part, from left to right.
        static List<int> PartRoots(BinaryBvh bvh, int leavesPerPart)
        {
            var roots = new List<int>();
            if (bvh.Leaves.Length == 0)
                return roots;
            var open = new Stack<int>();
            open.Push(bvh.Root);
            while (open.Count > 0)
            {
                int subtree = open.Pop();
                if (bvh.LeafCount(subtree) <= leavesPerPart)
                {
                    roots.Add(subtree);
                    continue;
                }
                open.Push(bvh.Right(subtree));
                open.Push(bvh.Left(subtree));
            }
            return roots;
        }

        // Boxes obtained by repeatedly opening the largest inner node.
        static List<Box> Cover(BinaryBvh bvh)
        {
            var subtrees = new List<int>();
            if (bvh.Leaves.Length > 0)
                subtrees.Add(bvh.Root);
            while (subtrees.Count < MaxCoverBoxes && subtrees.Any(subtree => subtree >= 0))
            {
                int largest = -1;
                for (int i = 0; i < subtrees.Count; i++)
                    if (subtrees[i] >= 0
                        && (largest < 0 || bvh.BoxOf(subtrees[i]).HalfArea > bvh.BoxOf(subtrees[largest]).HalfArea))
                        largest = i;
                subtrees.Add(bvh.Right(subtrees[largest]));
                subtrees[largest] = bvh.Left(subtrees[largest]);
            }
            return subtrees.ConvertAll(bvh.BoxOf);
        }
    }

    /// <summary>
    /// Leaves of a mesh's BVH: the corners of a pair of triangles, x, y, z of four in turn.
    /// Their identity rows hold the numbers of both triangles in the mesh, two leaves a row.
    /// </summary>
    sealed class PairWriter : ILeafWriter
    {
        readonly float3[] _vertices;
        readonly TrianglePair[] _pairs;

        public PairWriter(float3[] vertices, TrianglePair[] pairs)
        {
            _vertices = vertices;
            _pairs = pairs;
        }

        public int IdentityRows(int records) => (records + 1) / 2;

        public void Write(int item, uint4[] rows, int row, int record, int firstIdentityRow)
        {
            var pair = _pairs[item].Corners;
            float3 a = _vertices[pair.x], b = _vertices[pair.y], c = _vertices[pair.z], d = _vertices[pair.w];
            rows[row] = uint4(asuint(a.x), asuint(a.y), asuint(a.z), asuint(b.x));
            rows[row + 1] = uint4(asuint(b.y), asuint(b.z), asuint(c.x), asuint(c.y));
            rows[row + 2] = uint4(asuint(c.z), asuint(d.x), asuint(d.y), asuint(d.z));

            // Leaves are written by several threads: each writes its own half of a row.
            ref var identity = ref rows[firstIdentityRow + record / 2];
            if (record % 2 == 0)
                (identity.x, identity.y) = ((uint)_pairs[item].First, (uint)_pairs[item].Second);
            else
                (identity.z, identity.w) = ((uint)_pairs[item].First, (uint)_pairs[item].Second);
        }
    }
}
