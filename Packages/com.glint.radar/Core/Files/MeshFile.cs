using System.Collections.Generic;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>The triangles of a mesh file in Unity's axes and metres.</summary>
    public sealed class MeshFile
    {
        /// <param name="name">Name without folder and extension.</param>
        /// <param name="vertices">Positions in metres, all finite.</param>
        /// <param name="indices">Vertex numbers, three a triangle.</param>
        /// <param name="surfaces">Surfaces in the order of the triangles; null for one without a name.</param>
        public MeshFile(string name, float3[] vertices, int[] indices, MeshFileSurface[] surfaces = null)
        {
            Surfaces = surfaces ?? new[] { new MeshFileSurface(0, null) };
            Name = name;
            Vertices = vertices;
            Indices = indices;
        }

        /// <summary>Name of the file without folder and extension.</summary>
        public string Name { get; }

        /// <summary>Positions in metres; every component finite.</summary>
        public float3[] Vertices { get; }

        /// <summary>Vertex numbers, three a triangle, each below the number of vertices.</summary>
        public int[] Indices { get; }

        /// <summary>Triangles of each material, in their order; the first begins at triangle 0.</summary>
        public IReadOnlyList<MeshFileSurface> Surfaces { get; }

        /// <summary>Triangles, those without area included.</summary>
        public int TriangleCount => Indices.Length / 3;

        /// <summary>
        /// Triangles without area: corners coincide or lie on one line. They are kept, and no ray hits them.
        /// </summary>
        public int CountDegenerate()
        {
            int count = 0;
            for (int i = 0; i < Indices.Length; i += 3)
                if (IsDegenerate(Vertices[Indices[i]], Vertices[Indices[i + 1]], Vertices[Indices[i + 2]]))
                    count++;
            return count;
        }

        // In double the products of two float edges neither overflow nor underflow.
        static bool IsDegenerate(float3 a, float3 b, float3 c)
        {
            double ux = (double)b.x - a.x, uy = (double)b.y - a.y, uz = (double)b.z - a.z;
            double vx = (double)c.x - a.x, vy = (double)c.y - a.y, vz = (double)c.z - a.z;
            return uy * vz == uz * vy && uz * vx == ux * vz && ux * vy == uy * vx;
        }
    }

    /// <summary>Triangles of a mesh file, in a row, of one material.</summary>
    public readonly struct MeshFileSurface
    {
        internal MeshFileSurface(int firstTriangle, string material) =>
            (FirstTriangle, Material) = (firstTriangle, material);

        /// <summary>Number of the first triangle; the surface ends where the next one begins.</summary>
        public int FirstTriangle { get; }

        /// <summary>Name of the material; null if the file gives none.</summary>
        public string Material { get; }
    }
}
