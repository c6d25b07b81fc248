using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>Small scenes with answers known on paper, and their radar.</summary>
    static class TestRadar
    {
        public const double ReceiverBehindCamera = 0.2;

        public static RadarSettings Settings(int across = 160, int down = 90, int bounces = 4) =>
            new RadarSettings { FrequencyHz = 10e9, RaysAcross = across, RaysDown = down, MaxBounces = bounces };

        /// <summary>Rays and sums stay the same without the sampling error, which takes most of a trace's time.</summary>
        public static RadarSettings WithoutError(RadarSettings settings)
        {
            settings.SkipSamplingError = true;
            return settings;
        }

        /// <summary>
        /// A camera at a point, aimed at another, with a level right axis and a 3 x 3 m receiver 0.2 m behind it.
        /// </summary>
        public static RadarView LookAt(double3 from, double3 at, double fov = 60)
        {
            double3 forward = normalize(at - from);
            double3 right = normalize(cross(double3(0, 1, 0), forward));
            double3 up = cross(forward, right);
            return new RadarView
            {
                Position = from, Right = right, Up = up, Forward = forward, VerticalFovDegrees = fov,
                ReceiverCentre = from - ReceiverBehindCamera * forward,
                ReceiverRight = right, ReceiverUp = up, ReceiverForward = forward, ReceiverSize = 3,
            };
        }

        /// <summary>Origin of a pixel's ray. Parallel rays start at the centre of their cell of the
        /// aperture.</summary>
        public static double3 Start(in RadarSettings settings, in RadarView view, int pixel)
        {
            double spacing = view.ApertureHeight / settings.RaysDown;
            double x = pixel % settings.RaysAcross + 0.5 - 0.5 * settings.RaysAcross,
                y = pixel / settings.RaysAcross + 0.5 - 0.5 * settings.RaysDown;
            return view.Position + spacing * (x * view.Right + y * view.Up);
        }

        /// <summary>Direction through the centre of a pixel, by the definition of a field of view.</summary>
        public static double3 Direction(in RadarSettings settings, in RadarView view, int pixel)
        {
            if (view.IsParallel)
                return view.Forward;
            double height = 2 * tan(radians(view.VerticalFovDegrees) / 2);
            double width = height * settings.RaysAcross / settings.RaysDown;
            double x = (pixel % settings.RaysAcross + 0.5) / settings.RaysAcross - 0.5;
            double y = (pixel / settings.RaysAcross + 0.5) / settings.RaysDown - 0.5;
            return normalize(view.Forward + x * width * view.Right + y * height * view.Up);
        }

        /// <summary>A parallelogram of two triangles from a corner along two edges.</summary>
        public static TriangleMesh Plate(float3 corner, float3 edge1, float3 edge2) =>
            new TriangleMesh(new[] { corner, corner + edge1, corner + edge1 + edge2, corner + edge2 },
                new[] { 0, 1, 2, 0, 2, 3 });

        /// <summary>A square plate across the z axis, with a side in metres and its centre at (0, 0, z).</summary>
        public static TriangleMesh FacingPlate(float side, float z) =>
            Plate(float3(-side / 2, -side / 2, z), float3(side, 0, 0), float3(0, side, 0));

        /// <summary>Three square plates along the axes from a vertex: the inside of a box's corner.</summary>
        public static TriangleMesh Trihedral(float3 vertex, float side)
        {
            float3 x = float3(side, 0, 0), y = float3(0, side, 0), z = float3(0, 0, side);
            return Join(Plate(vertex, x, y), Plate(vertex, y, z), Plate(vertex, z, x));
        }

        /// <summary>Triangles of random position, size and rotation in a box; the same for a seed.</summary>
        public static TriangleMesh Clutter(int triangles, uint seed, float halfSide = 10, float largest = 2)
        {
            var random = new System.Random((int)seed);
            float Next() => (float)(2 * random.NextDouble() - 1);
            var vertices = new float3[3 * triangles];
            var indices = new int[3 * triangles];
            for (int t = 0; t < triangles; t++)
            {
                float3 centre = halfSide * float3(Next(), Next(), Next());
                for (int corner = 0; corner < 3; corner++)
                    vertices[3 * t + corner] = centre + largest * float3(Next(), Next(), Next());
            }
            for (int i = 0; i < indices.Length; i++)
                indices[i] = i;
            return new TriangleMesh(vertices, indices);
        }

        /// <summary>
        /// Triangles of several sizes in turn, each twice the previous one, with a medium size of about 1 m. All are
        /// near the origin, so that no plane separates them evenly.
        /// </summary>
        public static TriangleMesh PowersOfTwo(int triangles, int sizes)
        {
            var random = new System.Random(7);
            var corners = new float3[3 * triangles];
            for (int i = 0; i < corners.Length; i++)
                corners[i] = pow(2f, i / 3 % sizes - sizes / 2) * float3((float)random.NextDouble(),
                    (float)random.NextDouble(), (float)random.NextDouble());
            return new TriangleMesh(corners, Enumerable.Range(0, corners.Length).ToArray());
        }

        public static TriangleMesh Join(params TriangleMesh[] parts)
        {
            var vertices = new List<float3>();
            var indices = new List<int>();
            foreach (var part in parts)
            {
                foreach (int index in part.Indices)
                    indices.Add(vertices.Count + index);
                vertices.AddRange(part.Vertices);
            }
            return new TriangleMesh(vertices.ToArray(), indices.ToArray());
        }

        public static TriangleMesh Empty => new TriangleMesh(new float3[0], new int[0]);

        /// <summary>Number of a hit triangle in the scene, counted over the instances in order.</summary>
        public static int NumberOf(RadarScene scene, in PathHit hit) =>
            scene.Instances.Take(hit.Instance).Sum(instance => instance.Mesh.TriangleCount) + hit.Triangle;
    }
}
