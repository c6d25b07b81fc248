using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>
    /// Patches, their corners and outlines, and materials of a scene on the device: what the tracing of rays does not need.
    /// </summary>
    sealed class SurfaceBuffers : IDisposable
    {
        /// <summary>Steps of a table of reflection coefficients: REFLECTION_STEPS.</summary>
        public const int ReflectionSteps = 1024;

        RadarScene _scene;
        double _frequency;
        bool _arePlaced;

        /// <summary>Patches of the scene's instances.</summary>
        public PatchBuffers Patches { get; } = new PatchBuffers();

        public DeviceBuffer<float4> Motions { get; } = new DeviceBuffer<float4>("motions of instances");
        public DeviceBuffer<float4> Reflections { get; } = new DeviceBuffer<float4>("reflection coefficients");

        public DeviceBuffer<float4> Vertices { get; } = new DeviceBuffer<float4>("corners of patches");

        public int VertexCount { get; private set; }

        /// <summary>Sides of triangles on the outlines of patches, with the third corner.</summary>
        public DeviceBuffer<float4> Sides { get; } = new DeviceBuffer<float4>("outlines of patches");

        public int SideCount { get; private set; }

        /// <summary>Of all sides, metres.</summary>
        public double LengthOfSides { get; private set; }

        public DeviceBuffer<float4> Spheres { get; } = new DeviceBuffer<float4>("spheres about triangles");

        public int SphereCount { get; private set; }

        /// <summary>What casts the shadows of receivers; none where only the radar receives.</summary>
        public SilhouetteBuffers Silhouettes { get; } = new SilhouetteBuffers();

        /// <summary>What the radar may see in mirrors; none where only first bounces count.</summary>
        public MirrorBuffers Mirrors { get; } = new MirrorBuffers();

        /// <summary>Corners, outlines, their pieces or triangles, whichever are most: threads a pose that marks them.</summary>
        public int MarkedCount => Math.Max(Math.Max(SphereCount, Mirrors.PieceCount),
            Math.Max(SideCount, VertexCount));

        /// <summary>Uploads what has changed.</summary>
        /// <param name="frequency">Of the reflection coefficients, hertz.</param>
        public void Set(RadarScene scene, double3 centre, double creaseDegrees, double frequency)
        {
            bool isSame = _scene != null && scene.IsSame(_scene);
            _arePlaced = !Patches.Set(scene, creaseDegrees) && _arePlaced;
            if (!_arePlaced)
                SetPlaces(scene, centre);
            _arePlaced = true;
            if (!isSame || frequency != _frequency)
                Reflections.Upload(scene.Surfaces.SelectMany(surface => TableOf(surface, frequency)).ToArray());
            (_scene, _frequency) = (scene, frequency);
        }

        public void Dispose()
        {
            Patches.Dispose();
            Vertices.Dispose();
            Sides.Dispose();
            Spheres.Dispose();
            Silhouettes.Dispose();
            Mirrors.Dispose();
            Motions.Dispose();
            Reflections.Dispose();
            _scene = null;
        }

        void SetPlaces(RadarScene scene, double3 centre)
        {
            var vertices = new List<float4>();
            var sides = new List<float4>();
            var spheres = new List<float4>();
            LengthOfSides = 0;
            for (int i = 0; i < scene.Instances.Length; i++)
            {
                var instance = scene.Instances[i];
                var patches = Patches.OfInstances[i];
                foreach (float3 corner in PatchCorners.Of(patches))
                    vertices.Add(new float4((float3)(instance.ToWorld.Point(corner) - centre), 0));
                AddSides(instance, patches, centre, sides);
                for (int triangle = 0; triangle < instance.Mesh.TriangleCount; triangle++)
                    spheres.Add(SphereOf(instance, triangle, centre));
            }
            SideCount = sides.Count / TubeKernels.SideRows;
            Sides.Upload(sides.ToArray());
            SphereCount = spheres.Count;
            Spheres.Upload(spheres.ToArray());
            VertexCount = vertices.Count;
            Vertices.Upload(vertices.ToArray());
            Motions.Upload(scene.Instances.SelectMany(instance => new[]
            {
                new float4((float3)instance.Motion.VelocityAt(centre), 0),
                new float4((float3)instance.Motion.AngularVelocity, 0)
            }).ToArray());
        }

        void AddSides(in MeshInstance instance, SurfacePatches patches, double3 centre, List<float4> sides)
        {
            var welded = patches.Welded;
            var toWorld = instance.ToWorld;
            var placed = Array.ConvertAll(welded.Mesh.Vertices, vertex => toWorld.Point(vertex));
            foreach (int side in patches.Outlines())
            {
                int end = WeldedMesh.EndOf(side);
                foreach (int corner in new[] { side, end, WeldedMesh.Opposite(side) })
                    sides.Add(new float4((float3)(placed[welded.Corners[corner]] - centre), 0));
                LengthOfSides += math.distance(placed[welded.Corners[side]], placed[welded.Corners[end]]);
            }
        }

        // A sphere about a triangle, relative to the scene's centre.
        static float4 SphereOf(in MeshInstance instance, int triangle, double3 centre)
        {
            instance.Mesh.GetTriangle(triangle, out var a, out var b, out var c);
            double3 placedA = instance.ToWorld.Point(a), placedB = instance.ToWorld.Point(b),
                placedC = instance.ToWorld.Point(c), middle = (placedA + placedB + placedC) / 3;
            double radius = Math.Max(math.distance(middle, placedA),
                Math.Max(math.distance(middle, placedB), math.distance(middle, placedC)));
            // The coordinates are rounded on the way to the device.
            return new float4((float3)(middle - centre), (float)(radius + 1e-6 * math.length(middle - centre)));
        }

        static IEnumerable<float4> TableOf(SurfaceMaterial surface, double frequency)
        {
            for (int i = 0; i <= ReflectionSteps; i++)
            {
                var reflection = surface.Reflection((double)i / ReflectionSteps, frequency);
                yield return new float4((float)reflection.S.Real, (float)reflection.S.Imaginary,
                    (float)reflection.P.Real, (float)reflection.P.Imaginary);
            }
        }
    }
}
