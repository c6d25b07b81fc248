using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// Points on the surfaces of a scene, from which a radar screen takes its echoes. Each object has points of equal
    /// area, spread over its triangles in a fixed order: a fraction of a point's area is left between two of them.
    /// </summary>
    public sealed class SurfaceSamples
    {
        /// <summary>Points of a scene, at most: 32 MB.</summary>
        public const int MaxCount = 1 << 20;

        /// <summary>Points of an object, at least: small ones would depend on where their only point is.</summary>
        public const int MinOfAnObject = 64;

        SurfaceSamples(SurfaceSample[] points, double spacing) => (Points, Spacing) = (points, spacing);

        /// <summary>The points.</summary>
        public SurfaceSample[] Points { get; }

        /// <summary>Root of the area of a point of large objects, metres.</summary>
        public double Spacing { get; }

        /// <summary>Lays points on all triangles.</summary>
        /// <param name="spacing">Wanted <see cref="Spacing"/>, metres; it grows until the points are few enough.</param>
        /// <param name="subject">Whose scene it is, for messages.</param>
        /// <exception cref="GlintException">There are too many objects.</exception>
        public static SurfaceSamples Of(RadarScene scene, double spacing, string subject)
        {
            var objects = Objects(scene).Where(it => it.Area > 0).ToList();
            long reserved = (long)MinOfAnObject * objects.Count;
            if (reserved > MaxCount / 2)
                throw new GlintException($"{subject}: traces {objects.Count} objects, and a radar screen traces "
                    + $"{MaxCount / 2 / MinOfAnObject} at most: leave out layers of small objects");
            double area = Math.Max(spacing * spacing, objects.Sum(it => it.Area) / (MaxCount - reserved));
            var points = new List<SurfaceSample>();
            foreach (var it in objects)
                Add(scene.Instances[it.Instance], it, Math.Max(MinOfAnObject, (int)(it.Area / area)), points);
            return new SurfaceSamples(points.ToArray(), Math.Sqrt(area));
        }

        // The triangles of an object, or of a part of it with one surface.
        static IEnumerable<Piece> Objects(RadarScene scene)
        {
            for (int i = 0; i < scene.Instances.Length; i++)
            {
                var instance = scene.Instances[i];
                for (int range = 0; range < instance.Ranges.Length; range++)
                {
                    var piece = new Piece
                    {
                        Instance = i, First = instance.Ranges[range].FirstTriangle,
                        End = range + 1 < instance.Ranges.Length
                            ? instance.Ranges[range + 1].FirstTriangle : instance.Mesh.TriangleCount
                    };
                    for (int triangle = piece.First; triangle < piece.End; triangle++)
                        piece.Area += AreaOf(instance, triangle);
                    yield return piece;
                }
            }
        }

        // Point n is where n + 1/2 times its area is passed, from triangle to triangle.
        static void Add(in MeshInstance instance, in Piece piece, int count, List<SurfaceSample> points)
        {
            double area = piece.Area / count, passed = 0;
            int number = 0;
            for (int triangle = piece.First; triangle < piece.End && number < count; triangle++)
            {
                passed += AreaOf(instance, triangle);
                for (; number < count && (number + 0.5) * area <= passed; number++)
                    points.Add(new SurfaceSample
                    {
                        Position = (float3)PointOn(instance.Mesh, triangle, number), Area = (float)area,
                        Instance = (uint)piece.Instance, Triangle = (uint)triangle
                    });
            }
        }

        // Of the sequence R2 (Roberts 2018: multiples of 1/g and 1/g^2, g^3 = g + 1), taken to a triangle.
        static double3 PointOn(TriangleMesh mesh, int triangle, int number)
        {
            mesh.GetTriangle(triangle, out var a, out var b, out var c);
            double u = math.sqrt(math.frac(0.5 + number * 0.7548776662466927)),
                v = math.frac(0.5 + number * 0.5698402909980532);
            return (1 - u) * (double3)a + u * (1 - v) * (double3)b + u * v * (double3)c;
        }

        static double AreaOf(in MeshInstance instance, int triangle)
        {
            instance.Mesh.GetTriangle(triangle, out var a, out var b, out var c);
            return math.length(math.cross(instance.ToWorld.Vector((double3)b - a),
                instance.ToWorld.Vector((double3)c - a))) / 2;
        }

        struct Piece
        {
            public int Instance, First, End;
            public double Area;
        }
    }

    /// <summary>A point of a surface: GLINT_SURFACE_SAMPLE in Shaders/Types.hlsl.</summary>
    [System.Runtime.InteropServices.StructLayout(System.Runtime.InteropServices.LayoutKind.Sequential)]
    public struct SurfaceSample
    {
        /// <summary>In the mesh's frame.</summary>
        public float3 Position;

        /// <summary>Of the surface that it stands for, square metres.</summary>
        public float Area; // 16 bytes

        /// <summary>Index of the instance in the scene.</summary>
        public uint Instance;

        /// <summary>Index of the triangle in the instance's mesh.</summary>
        public uint Triangle;

        readonly uint2 _unused; // 32 bytes
    }
}
