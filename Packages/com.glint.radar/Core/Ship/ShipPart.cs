using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// A closed solid made of patches: grids of points, each a surface without a crease.
    /// Patches that meet give the same points on their common edge.
    /// The orientation of patches is free, but must be the same for all patches of a part (seen from outside, rows turn
    /// left into columns, or right).
    /// </summary>
    sealed class ShipPart
    {
        // Resolution of coordinates, a power of two: float32 holds it up to 128 m, and axis-aligned faces stay exactly
        // flat.
        const double StepsPerMetre = 65536;

        readonly List<float3> _vertices = new List<float3>();
        readonly List<int> _indices = new List<int>();

        public int TriangleCount => _indices.Count / 3;

        /// <summary>
        /// A surface through rows of points. Rows or columns may shrink to a point.
        /// It shares no vertices: its edges are creases.
        /// </summary>
        public void AddPatch(double3[][] rows)
        {
            var known = new Dictionary<float3, int>();
            int[] above = null;
            foreach (var row in rows)
            {
                var here = Array.ConvertAll(row, point => Vertex(point, known));
                for (int i = 0; above != null && i + 1 < here.Length; i++)
                    AddCell(above[i], here[i], here[i + 1], above[i + 1]);
                above = here;
            }
        }

        /// <summary>
        /// The ruled surface between two curves with the same number of points, in a number of steps.
        /// </summary>
        public void AddRuled(double3[] from, double3[] to, int steps = 1)
        {
            var rows = new double3[steps + 1][];
            for (int i = 0; i <= steps; i++)
                rows[i] = Between(from, to, (double)i / steps);
            AddPatch(rows);
        }

        /// <summary>
        /// A solid through closed rings (the last point repeats the first) with the same number of points, with flat
        /// ends.
        /// </summary>
        /// <param name="creases">True if each ring is an edge, false if the side is round from ring to ring.</param>
        public static ShipPart Loft(double3[][] rings, bool creases = false)
        {
            var part = new ShipPart();
            if (creases)
                for (int i = 0; i + 1 < rings.Length; i++)
                    part.AddPatch(new[] { rings[i], rings[i + 1] });
            else
                part.AddPatch(rings);
            part.AddEnd(rings[0], isFirst: true);
            part.AddEnd(rings[rings.Length - 1], isFirst: false);
            return part;
        }

        /// <summary>
        /// A solid between two convex outlines (corners in order, the first not repeated), with flat sides.
        /// </summary>
        public static ShipPart Block(double3[] bottom, double3[] top)
        {
            var part = new ShipPart();
            double3[] lower = Closed(bottom), upper = Closed(top);
            for (int i = 0; i < bottom.Length; i++)
                part.AddPatch(new[] { new[] { lower[i], lower[i + 1] }, new[] { upper[i], upper[i + 1] } });
            part.AddEnd(lower, isFirst: true);
            part.AddEnd(upper, isFirst: false);
            return part;
        }

        /// <summary>An axis-aligned box.</summary>
        public static ShipPart Box(double3 boxMin, double3 boxMax)
        {
            double3[] Outline(double y) => new[]
            {
                new double3(boxMin.x, y, boxMin.z),
                new double3(boxMax.x, y, boxMin.z), new double3(boxMax.x, y, boxMax.z),
                new double3(boxMin.x, y, boxMax.z)
            };
            return Block(Outline(boxMin.y), Outline(boxMax.y));
        }

        /// <summary>The part on the ship's other side.</summary>
        public ShipPart Mirrored()
        {
            var other = new ShipPart();
            foreach (var vertex in _vertices)
                other._vertices.Add(new float3(-vertex.x + 0f, vertex.y, vertex.z));
            other._indices.AddRange(_indices);
            return other;
        }

        /// <summary>Adds the part to a mesh, with Unity's winding: the outer side is the front.</summary>
        public void AddTo(List<float3> vertices, List<int> indices)
        {
            bool isInsideOut = Volume() < 0;
            int first = vertices.Count;
            vertices.AddRange(_vertices);
            for (int i = 0; i < _indices.Count; i += 3)
            {
                indices.Add(first + _indices[i]);
                indices.Add(first + _indices[isInsideOut ? i + 2 : i + 1]);
                indices.Add(first + _indices[isInsideOut ? i + 1 : i + 2]);
            }
        }

        /// <summary>
        /// Interpolates between two curves; at 0 and 1 the points are exactly those of the curves.
        /// </summary>
        public static double3[] Between(double3[] from, double3[] to, double part)
        {
            var points = new double3[from.Length];
            for (int i = 0; i < points.Length; i++)
                points[i] = (1 - part) * from[i] + part * to[i];
            return points;
        }

        static double3[] Closed(double3[] outline)
        {
            var ring = new double3[outline.Length + 1];
            outline.CopyTo(ring, 0);
            ring[outline.Length] = outline[0];
            return ring;
        }

        // A convex flat end: a fan about its centre.
        void AddEnd(double3[] ring, bool isFirst)
        {
            double3 centre = 0;
            for (int i = 0; i + 1 < ring.Length; i++)
                centre += ring[i] / (ring.Length - 1);
            var point = new double3[ring.Length];
            for (int i = 0; i < point.Length; i++)
                point[i] = centre;
            AddPatch(isFirst ? new[] { point, ring } : new[] { ring, point });
        }

        // Cut along the shorter diagonal. A cell with an edge of length 0 gives one triangle.
        void AddCell(int a, int b, int c, int d)
        {
            bool alongAc = DistanceSquared(_vertices[a], _vertices[c]) <= DistanceSquared(_vertices[b], _vertices[d]);
            AddTriangle(a, b, alongAc ? c : d);
            AddTriangle(alongAc ? a : b, c, d);
        }

        // Each step rounded to float32, so that equal diagonals are cut alike everywhere: Unity's Mono computes floats
        // in double precision.
        static float DistanceSquared(float3 a, float3 b)
        {
            float3 to = b - a, squares = to * to;
            return (float)((float)(squares.x + squares.y) + squares.z);
        }

        void AddTriangle(int a, int b, int c)
        {
            if (a == b || b == c || c == a)
                return;
            _indices.Add(a);
            _indices.Add(b);
            _indices.Add(c);
        }

        int Vertex(double3 point, Dictionary<float3, int> known)
        {
            // Adding 0 turns -0 into 0, so that equal positions have equal bits.
            var position = (float3)(math.round(StepsPerMetre * point) / StepsPerMetre + 0.0);
            if (!known.TryGetValue(position, out int vertex))
            {
                known.Add(position, vertex = _vertices.Count);
                _vertices.Add(position);
            }
            return vertex;
        }

        double Volume()
        {
            double sum = 0;
            for (int i = 0; i < _indices.Count; i += 3)
                sum += math.dot(_vertices[_indices[i]],
                    math.cross((double3)_vertices[_indices[i + 1]], _vertices[_indices[i + 2]]));
            return sum / 6;
        }
    }
}
