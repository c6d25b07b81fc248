using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// Triangles in the mesh's own frame, metres, Unity's axes (left-handed, y up). Both sides of a triangle reflect.
    /// Immutable: a changed mesh is a new object.
    /// </summary>
    public sealed class TriangleMesh
    {
        /// <summary>Metres. Above it float32 coordinates are a metre apart, too coarse for path lengths.</summary>
        public const float LargestCoordinate = 1e7f;

        /// <summary>A mesh over the given arrays, which are kept, not copied.</summary>
        /// <param name="vertices">Positions in metres; every component finite.</param>
        /// <param name="indices">Three a triangle, each below the number of vertices.</param>
        public TriangleMesh(float3[] vertices, int[] indices)
        {
            Vertices = vertices;
            Indices = indices;
        }

        /// <summary>Positions in metres.</summary>
        public float3[] Vertices { get; }

        /// <summary>Vertex numbers, three a triangle.</summary>
        public int[] Indices { get; }

        /// <summary>Triangles, those without area included.</summary>
        public int TriangleCount => Indices.Length / 3;

        /// <summary>
        /// The box around all triangles; empty without triangles. Vertices without a triangle do not count.
        /// </summary>
        public Box Bound()
        {
            var box = Box.Empty;
            foreach (int index in Indices)
                box.Add(Vertices[index]);
            return box;
        }

        /// <summary>The corners of triangle <paramref name="triangle"/> in metres.</summary>
        public void GetTriangle(int triangle, out float3 a, out float3 b, out float3 c)
        {
            a = Vertices[Indices[3 * triangle]];
            b = Vertices[Indices[3 * triangle + 1]];
            c = Vertices[Indices[3 * triangle + 2]];
        }
    }
}
