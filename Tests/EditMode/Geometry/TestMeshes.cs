using System;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>Meshes that are hard on a BVH in different ways.</summary>
    static class TestMeshes
    {
        /// <summary>Waves over a grid of squares with shared vertices, two triangles each.</summary>
        public static TriangleMesh Sea(int across, int along, float square = 0.5f)
        {
            return Grid(across, along, (column, row) =>
            {
                float x = square * column, z = square * row;
                return float3(x, 0.3f * square * (sin(0.7f * x + 0.3f * z) + sin(0.2f * x - 1.1f * z)), z);
            });
        }

        /// <summary>A grid of cells with shared vertices, two triangles each.</summary>
        /// <param name="at">Vertex by column and row.</param>
        public static TriangleMesh Grid(int across, int along, Func<int, int, float3> at)
        {
            var vertices = new float3[(across + 1) * (along + 1)];
            for (int i = 0; i < vertices.Length; i++)
                vertices[i] = at(i % (across + 1), i / (across + 1));
            var indices = new int[6 * across * along];
            for (int i = 0; i < across * along; i++)
            {
                int a = i / across * (across + 1) + i % across, b = a + 1, c = a + across + 1, d = c + 1;
                new[] { a, c, b, b, c, d }.CopyTo(indices, 6 * i);
            }
            return new TriangleMesh(vertices, indices);
        }

        /// <summary>The same triangles without shared vertices, as in an STL file.</summary>
        public static TriangleMesh Soup(TriangleMesh mesh) =>
            new TriangleMesh(mesh.Indices.Select(index => mesh.Vertices[index]).ToArray(),
                Enumerable.Range(0, mesh.Indices.Length).ToArray());

        /// <summary>Small triangles on a grid, without shared vertices.</summary>
        public static TriangleMesh Apart(int across, int along, float step) =>
            Triangles(across * along, t => step * float3(t % across, 0, t / across), 0.4f * step);

        /// <summary>
        /// Most triangles in a clump, and the others so far apart that one bin of any split contains the clump.
        /// </summary>
        public static TriangleMesh Clump(int inside, int outside) => TestRadar.Join(
            Triangles(inside, t => 1e-3f * float3(t % 1000, 0, t / 1000), 4e-4f),
            Triangles(outside, t => 300f * float3(t % 100, t % 7, t / 100), 100));

        /// <summary>Many copies of one triangle.</summary>
        public static TriangleMesh Same(int count) => Triangles(count, t => float3(3, 4, 5), 1);

        /// <summary>Triangles of 10 km by a few micrometres.</summary>
        public static TriangleMesh Slivers(int count) =>
            Triangles(count, t => float3(0, 1e-3f * t, 0), float3(1e4f, 0, 0),
                t => float3(1e4f, t % 2 == 0 ? 4e-6f : -4e-6f, t % 5));

        /// <summary>A fan around one shared vertex, alternately up and down.</summary>
        public static TriangleMesh Fan(int count)
        {
            var vertices = new float3[count + 2];
            for (int i = 0; i <= count; i++)
                vertices[i + 1] = float3(100 * cos(2e-3f * i), i % 2, 100 * sin(2e-3f * i));
            return new TriangleMesh(vertices,
                Enumerable.Range(0, 3 * count).Select(i => i % 3 == 0 ? 0 : i / 3 + i % 3).ToArray());
        }

        /// <summary>
        /// Triangles whose size and distance grow from 10^-7 m to 10^7 m, and as many at the small end.
        /// </summary>
        public static TriangleMesh Ladder(int steps, int atTheFoot)
        {
            float Size(int t) => (float)Math.Pow(10, -7 + 14.0 * Math.Max(0, t) / steps);
            return TestRadar.Join(
                Triangles(steps, t => Size(t), t => float3(Size(t), 0, 0), t => float3(0, Size(t), Size(t))),
                Triangles(atTheFoot, t => 1e-7f * (1 + t % 97 / 97f), float3(3e-7f, 0, 0),
                    t => float3(0, 3e-7f, t % 89 * 1e-9f)));
        }

        static TriangleMesh Triangles(int count, Func<int, float3> corner, float size) =>
            Triangles(count, corner, float3(size, 0, 0), t => float3(0.3f * size, 0.2f * size, size));

        static TriangleMesh Triangles(int count, Func<int, float3> corner, float3 edge1, Func<int, float3> edge2) =>
            Triangles(count, corner, t => edge1, edge2);

        static TriangleMesh Triangles(int count, Func<int, float3> corner,
            Func<int, float3> edge1, Func<int, float3> edge2)
        {
            var vertices = new float3[3 * count];
            for (int t = 0; t < count; t++)
            {
                vertices[3 * t] = corner(t);
                vertices[3 * t + 1] = corner(t) + edge1(t);
                vertices[3 * t + 2] = corner(t) + edge2(t);
            }
            return new TriangleMesh(vertices, Enumerable.Range(0, 3 * count).ToArray());
        }
    }
}
