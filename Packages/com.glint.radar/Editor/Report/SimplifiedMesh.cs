using System;
using System.Collections.Generic;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Editor
{
    /// <summary>
    /// A mesh for display, with 16-bit coordinates and a maximum number of triangles. Above that number, all points in
    /// a cube of a grid are merged.
    /// </summary>
    public sealed class SimplifiedMesh
    {
        const int Steps = ushort.MaxValue;

        SimplifiedMesh(double3 boxMin, double3 size) => (Min, Size) = (boxMin, size);

        /// <summary>
        /// Corner and size of the box that the coordinates divide into 65,535 steps an axis,
        /// metres, in the mesh's frame.
        /// </summary>
        public double3 Min { get; }

        /// <inheritdoc cref="Min"/>
        public double3 Size { get; }

        /// <summary>x, y, z of each point.</summary>
        public List<ushort> Positions { get; } = new List<ushort>();

        /// <summary>Point numbers, three a triangle.</summary>
        public List<int> Indices { get; } = new List<int>();

        /// <summary>Triangles drawn.</summary>
        public int TriangleCount => Indices.Count / 3;

        /// <summary>Simplifies a mesh.</summary>
        /// <param name="max">Maximum number of triangles; at least 12.</param>
        public static SimplifiedMesh Of(TriangleMesh mesh, int max)
        {
            double3 boxMin = double.PositiveInfinity, boxMax = double.NegativeInfinity;
            double area = 0;
            for (int i = 0; i < mesh.TriangleCount; i++)
            {
                mesh.GetTriangle(i, out var a, out var b, out var c);
                boxMin = math.min(boxMin, math.min((double3)a, math.min((double3)b, (double3)c)));
                boxMax = math.max(boxMax, math.max((double3)a, math.max((double3)b, (double3)c)));
                area += math.length(math.cross((double3)b - a, (double3)c - a)) / 2;
            }
            if (mesh.TriangleCount == 0)
                return new SimplifiedMesh(0, 0);
            if (mesh.TriangleCount <= max)
                return Drawn(mesh, boxMin, boxMax - boxMin, 0);
            // On a flat surface two triangles for each square of this side; more or fewer on others.
            double side = math.max(math.sqrt(2 * area / max), 1e-3 * math.cmax(boxMax - boxMin));
            while (true)
            {
                var simplified = Drawn(mesh, boxMin, boxMax - boxMin, side);
                if (simplified.TriangleCount <= max)
                    return simplified;
                side *= math.max(1.05, math.sqrt((double)simplified.TriangleCount / max));
            }
        }

        // Points in a cube of this side are merged into the one nearest to the border of the mesh, so that adjacent
        // tiles still join; side 0 merges none.
        static SimplifiedMesh Drawn(TriangleMesh mesh, double3 boxMin, double3 size, double side)
        {
            var simplified = new SimplifiedMesh(boxMin, size);
            var numbers = new Dictionary<int3, int>();
            var outward = new List<double>();
            var own = new int[mesh.Vertices.Length]; // number of the merged vertex + 1; 0: none yet
            var drawn = new HashSet<int3>();
            for (int i = 0; i < mesh.Indices.Length; i += 3)
            {
                var corners = new int3(simplified.Number(mesh, i, side, numbers, outward, own),
                    simplified.Number(mesh, i + 1, side, numbers, outward, own),
                    simplified.Number(mesh, i + 2, side, numbers, outward, own));
                if (corners.x == corners.y || corners.y == corners.z || corners.z == corners.x
                    || side > 0 && !drawn.Add(Sorted(corners)))
                    continue;
                simplified.Indices.Add(corners.x);
                simplified.Indices.Add(corners.y);
                simplified.Indices.Add(corners.z);
            }
            return simplified;
        }

        int Number(TriangleMesh mesh, int corner, double side, Dictionary<int3, int> numbers,
            List<double> outward, int[] own)
        {
            int vertex = mesh.Indices[corner];
            if (own[vertex] > 0)
                return own[vertex] - 1;
            double3 position = (double3)mesh.Vertices[vertex] - Min;
            var cube = side > 0 ? (int3)math.floor(position / side) : default;
            if (side == 0 || !numbers.TryGetValue(cube, out int number))
            {
                number = Positions.Count / 3;
                if (side > 0)
                    numbers.Add(cube, number);
                outward.Add(-1);
                Positions.AddRange(new ushort[3]);
            }
            double reach = math.cmax(math.abs(position - Size / 2) / math.max(Size, double.Epsilon));
            if (reach > outward[number])
            {
                outward[number] = reach;
                for (int axis = 0; axis < 3; axis++)
                    Positions[3 * number + axis] =
                        (ushort)(Size[axis] > 0 ? Math.Round(position[axis] / Size[axis] * Steps) : 0);
            }
            own[vertex] = number + 1;
            return number;
        }

        static int3 Sorted(int3 numbers)
        {
            int low = Math.Min(numbers.x, Math.Min(numbers.y, numbers.z)),
                high = Math.Max(numbers.x, Math.Max(numbers.y, numbers.z));
            return new int3(low, numbers.x + numbers.y + numbers.z - low - high, high);
        }
    }
}
