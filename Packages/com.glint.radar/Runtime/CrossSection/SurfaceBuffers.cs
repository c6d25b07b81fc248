using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>
    /// Smooth patches and materials of a scene's triangles on the device: what the tracing of rays does not need.
    /// </summary>
    sealed class SurfaceBuffers : IDisposable
    {
        /// <summary>A facet without a field of normals: FLAT in Shaders/TubeBindings.hlsl.</summary>
        public const uint Flat = uint.MaxValue;

        /// <summary>Steps of a table of reflection coefficients: REFLECTION_STEPS.</summary>
        public const int ReflectionSteps = 1024;

        readonly Dictionary<(TriangleMesh, double), (MeshRange[] Ranges, SurfacePatches Patches)> _patches =
            new Dictionary<(TriangleMesh, double), (MeshRange[], SurfacePatches)>();
        RadarScene _scene;
        double _creaseDegrees, _frequency;

        public DeviceBuffer<uint2> Facets { get; } = new DeviceBuffer<uint2>("facets");
        public DeviceBuffer<float4> NormalFields { get; } = new DeviceBuffer<float4>("normals of curved facets");
        public DeviceBuffer<uint4> InstanceFacets { get; } = new DeviceBuffer<uint4>("instances");
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

        /// <summary>Patches of each instance of the scene: another list if the scene has changed.</summary>
        public IReadOnlyList<SurfacePatches> Patches { get; private set; }

        /// <summary>Parts of the scene.</summary>
        public SceneParts Parts { get; private set; }

        public long Bytes => Vertices.Bytes + Sides.Bytes + Spheres.Bytes + Facets.Bytes + NormalFields.Bytes + InstanceFacets.Bytes
            + Motions.Bytes + Reflections.Bytes;

        /// <summary>Takes patches of a scene's instances that are found already.</summary>
        public void Know(RadarScene scene, double creaseDegrees, SurfacePatches[] patches)
        {
            for (int i = 0; i < patches.Length; i++)
                _patches[(scene.Instances[i].Mesh, creaseDegrees)] = (scene.Instances[i].Ranges, patches[i]);
        }

        /// <summary>Uploads what has changed.</summary>
        /// <param name="frequency">Of the reflection coefficients, hertz.</param>
        public void Set(RadarScene scene, double3 centre, double creaseDegrees, double frequency)
        {
            bool isSame = _scene != null && scene.IsSame(_scene);
            if (!isSame || creaseDegrees != _creaseDegrees)
                SetPatches(scene, centre, creaseDegrees);
            if (!isSame || frequency != _frequency)
                Reflections.Upload(scene.Surfaces.SelectMany(surface => TableOf(surface, frequency)).ToArray());
            (_scene, _creaseDegrees, _frequency) = (scene, creaseDegrees, frequency);
        }

        public void Dispose()
        {
            Facets.Dispose();
            Vertices.Dispose();
            Sides.Dispose();
            Spheres.Dispose();
            NormalFields.Dispose();
            InstanceFacets.Dispose();
            Motions.Dispose();
            Reflections.Dispose();
            _patches.Clear();
            _scene = null;
        }

        void SetPatches(RadarScene scene, double3 centre, double creaseDegrees)
        {
            var facets = new List<uint2>();
            var fields = new List<float4>();
            var firsts = new List<uint4>();
            var first = new Dictionary<SurfacePatches, uint>();
            uint patchCount = 0;
            var vertices = new List<float4>();
            var sides = new List<float4>();
            var spheres = new List<float4>();
            LengthOfSides = 0;
            Parts = new SceneParts(scene);
            var seas = new HashSet<int>(scene.Seas.SelectMany(sea => sea.Tiles).Select(tile => tile.Instance));
            Patches = Array.ConvertAll(scene.Instances, instance => PatchesOf(instance, creaseDegrees));
            for (int i = 0; i < scene.Instances.Length; i++)
            {
                var instance = scene.Instances[i];
                var patches = Patches[i];
                if (!first.TryGetValue(patches, out uint firstFacet))
                {
                    first.Add(patches, firstFacet = (uint)facets.Count);
                    AddFacets(instance.Mesh, patches, facets, fields);
                }
                firsts.Add(new uint4(firstFacet, patchCount, (uint)Parts.FirstOf(i),
                    seas.Contains(i) ? 1u : 0));
                patchCount += (uint)patches.PatchCount;
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
            Facets.Upload(facets.ToArray());
            NormalFields.Upload(fields.ToArray());
            InstanceFacets.Upload(firsts.ToArray());
            Motions.Upload(scene.Instances.SelectMany(instance => new[]
            {
                new float4((float3)instance.Motion.VelocityAt(centre), 0),
                new float4((float3)instance.Motion.AngularVelocity, 0)
            }).ToArray());
        }

        // Adds the sides at which triangles of a patch meet none of the same patch.
        void AddSides(in MeshInstance instance, SurfacePatches patches, double3 centre, List<float4> sides)
        {
            var welded = patches.Welded;
            var toWorld = instance.ToWorld;
            var placed = Array.ConvertAll(welded.Mesh.Vertices, vertex => toWorld.Point(vertex));
            for (int side = 0; side < welded.Corners.Length; side++)
            {
                if (welded.EdgeOf[side] == WeldedMesh.None || patches.IsSmooth(side))
                    continue;
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

        SurfacePatches PatchesOf(in MeshInstance instance, double creaseDegrees)
        {
            var key = (instance.Mesh, creaseDegrees);
            if (_patches.TryGetValue(key, out var known) && known.Ranges.SequenceEqual(instance.Ranges))
                return known.Patches;
            var patches = SurfacePatches.Find(instance.Mesh, instance.Ranges, creaseDegrees);
            _patches[key] = (instance.Ranges, patches);
            return patches;
        }

        static void AddFacets(TriangleMesh mesh, SurfacePatches patches, List<uint2> facets, List<float4> fields)
        {
            for (int triangle = 0; triangle < mesh.TriangleCount; triangle++)
            {
                int patch = patches.PatchOf[triangle];
                bool isFlat = patch == SurfacePatches.NoPatch || patches.IsFlat(patch);
                facets.Add(new uint2((uint)patch, isFlat ? Flat : (uint)fields.Count));
                if (!isFlat)
                    AddField(mesh, triangle, patches.CornerNormals, fields);
            }
        }

        // The normal is linear over the facet: its gradient, and its value at the centroid, a row a component.
        static void AddField(TriangleMesh mesh, int triangle, float3[] normals, List<float4> fields)
        {
            mesh.GetTriangle(triangle, out var a, out var b, out var c);
            double3 side1 = (double3)b - a, side2 = (double3)c - a, normal = math.cross(side1, side2);
            double square = math.dot(normal, normal);
            double3 na = normals[3 * triangle], nb = normals[3 * triangle + 1], nc = normals[3 * triangle + 2];
            // Gradients of the second and third barycentric coordinates.
            double3 gradient1 = math.cross(side2, normal) / square, gradient2 = math.cross(normal, side1) / square;
            double3 middle = (na + nb + nc) / 3;
            for (int i = 0; i < 3; i++)
            {
                double3 gradient = square > 0 ? (nb[i] - na[i]) * gradient1 + (nc[i] - na[i]) * gradient2 : 0;
                fields.Add(new float4((float3)gradient, (float)middle[i]));
            }
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
