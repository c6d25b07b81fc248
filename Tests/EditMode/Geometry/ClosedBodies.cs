using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>
    /// Closed bodies around the origin: the surface of a cube with n x n cells a face, each corner moved along its
    /// direction. Rows and columns of corners coincide with rays of a square picture of 90 degrees, so that rays from
    /// the origin hit corners and edges and run along edges.
    /// </summary>
    static class ClosedBodies
    {
        /// <summary>An approximate sphere of radius 1; 12 n^2 triangles.</summary>
        public static TriangleMesh Sphere(int cells, int rays) =>
            Make(cells, rays, (at, direction) => normalize(direction));

        /// <summary>A convex body with three unequal axes that are not at right angles.</summary>
        public static TriangleMesh Skewed(int cells, int rays) => Make(cells, rays, (at, direction) =>
        {
            double3 p = normalize(direction);
            return double3(3 * p.x + p.y, p.y + 0.2 * p.z, 0.3 * p.z);
        });

        /// <summary>A very concave body: each corner has a random distance.</summary>
        public static TriangleMesh Jagged(int cells, int rays, int seed, double depth = 0.5) =>
            Make(cells, rays, (at, direction) => (1 + depth * (2 * Chance(at, seed) - 1)) * direction);

        /// <summary>
        /// A cube with dents whose walls point at the origin, so that rays run along walls and their edges.
        /// </summary>
        public static TriangleMesh Dented(int cells, int rays, int seed)
        {
            var cube = new Builder(cells, rays, (at, direction) => direction);
            cube.AddFaces((face, column, row) =>
                column > 0 && row > 0 && column < cells - 1 && row < cells - 1 && column % 2 == 1
                && row % 2 == 1 ? 0.4 + Chance(int3(column, row, face), seed) : 1);
            return cube.ToMesh();
        }

        static TriangleMesh Make(int cells, int rays, Func<int3, double3, double3> position)
        {
            var body = new Builder(cells, rays, position);
            body.AddFaces((face, column, row) => 1);
            return body.ToMesh();
        }

        // A pseudo-random number from 0 to 1 that depends only on the position.
        static double Chance(int3 at, int seed) =>
            new System.Random(seed * 7919 + at.x * 73856093 ^ at.y * 19349663 ^ at.z * 83492791).NextDouble();

        sealed class Builder
        {
            readonly int _cells;
            readonly double[] _tangents;
            readonly Func<int3, double3, double3> _position;
            readonly Dictionary<int3, int> _known = new Dictionary<int3, int>();
            readonly List<float3> _vertices = new List<float3>();
            readonly List<int> _indices = new List<int>();

            public Builder(int cells, int rays, Func<int3, double3, double3> position)
            {
                _cells = cells;
                _position = position;
                // Tangents of the rays through pixel centres nearest to the cells' edges; the cube's own edges are
                // between rays.
                _tangents = Enumerable.Range(0, cells + 1).Select(
                    i => i == 0 ? -1.0 : i == cells ? 1.0 : (2.0 * (i * rays / cells) + 1 - rays) / rays).ToArray();
            }

            /// <param name="lift">
            /// Distance of a face's cell relative to its surroundings; not 1 for a dent or a hump with walls.
            /// </param>
            public void AddFaces(Func<int, int, int, double> lift)
            {
                for (int face = 0; face < 6; face++)
                    for (int row = 0; row < _cells; row++)
                        for (int column = 0; column < _cells; column++)
                            AddCell(face, column, row, lift(face, column, row));
            }

            public TriangleMesh ToMesh() => new TriangleMesh(_vertices.ToArray(), _indices.ToArray());

            void AddCell(int face, int column, int row, double lift)
            {
                var at = new[]
                {
                    Corner(face, column, row), Corner(face, column + 1, row), Corner(face, column + 1, row + 1),
                    Corner(face, column, row + 1)
                };
                var rim = at.Select(Vertex).ToArray();
                if (lift == 1)
                {
                    AddQuad(rim);
                    return;
                }
                var floor = at.Select(corner => Add((float3)(lift * _position(corner, Direction(corner))))).ToArray();
                AddQuad(floor);
                for (int i = 0; i < 4; i++)
                    AddQuad(rim[i], rim[(i + 1) % 4], floor[(i + 1) % 4], floor[i]);
            }

            int3 Corner(int face, int column, int row)
            {
                int side = face < 3 ? 0 : _cells;
                return face % 3 == 0 ? int3(column, row, side)
                    : face % 3 == 1 ? int3(side, column, row)
                    : int3(row, side, column);
            }

            double3 Direction(int3 corner) => double3(_tangents[corner.x], _tangents[corner.y], _tangents[corner.z]);

            int Vertex(int3 corner)
            {
                if (!_known.TryGetValue(corner, out int index))
                    _known.Add(corner, index = Add((float3)_position(corner, Direction(corner))));
                return index;
            }

            int Add(float3 vertex)
            {
                _vertices.Add(vertex);
                return _vertices.Count - 1;
            }

            void AddQuad(params int[] q) => _indices.AddRange(new[] { q[0], q[1], q[2], q[0], q[2], q[3] });
        }
    }
}
