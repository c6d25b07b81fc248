using static Unity.Mathematics.math;

namespace Glint.Core
{
    /// <summary>A tree of boxes over a scene's triangles; node 0 is the root. A scene without triangles has no nodes.</summary>
    public sealed class Bvh
    {
        /// <summary>Levels a tree may have; the kernel's stack holds as many (STACK_DEPTH in Shaders/Traversal.hlsl).</summary>
        public const int MaxDepth = 48;

        /// <summary>Most triangles a leaf holds.</summary>
        public const int MaxLeafSize = 4;

        // Square of the least cross product of edges, m4, that float32 can make a normal of: the triangle's area is then half of 1e-16 m2.
        const float LeastNormalSquared = 1e-32f;

        internal Bvh(BvhNode[] nodes, int[] triangleOrder)
        {
            Nodes = nodes;
            TriangleOrder = triangleOrder;
        }

        public BvhNode[] Nodes { get; }

        /// <summary>Scene triangle of each place in the leaves.</summary>
        public int[] TriangleOrder { get; }

        /// <summary>
        /// The scene's triangles as the kernel reads them, in the order of the leaves.
        /// Triangles of less than 5e-17 m2, or so large that their area is not finite, reflect nothing.
        /// </summary>
        public TriangleRecord[] Records(TriangleMesh scene)
        {
            var records = new TriangleRecord[TriangleOrder.Length];
            for (int i = 0; i < records.Length; i++)
            {
                scene.GetTriangle(TriangleOrder[i], out var a, out var b, out var c);
                var record = new TriangleRecord { Corner = a, Edge1 = b - a, Edge2 = c - a };
                // Edges of zero length are never hit.
                float normalSquared = lengthsq(cross(record.Edge1, record.Edge2));
                if (!(normalSquared >= LeastNormalSquared && normalSquared <= float.MaxValue))
                    record.Edge1 = record.Edge2 = 0;
                records[i] = record;
            }
            return records;
        }
    }
}
