using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>The patch and the normals of each triangle of a scene on the device, wherever its objects are.</summary>
    sealed class PatchBuffers : IDisposable
    {
        /// <summary>A facet without a field of normals: FLAT in Shaders/TubeBindings.hlsl.</summary>
        public const uint Flat = uint.MaxValue;

        readonly Dictionary<(TriangleMesh Mesh, double Crease), (MeshRange[] Ranges, SurfacePatches Patches)> _patches =
            new Dictionary<(TriangleMesh, double), (MeshRange[], SurfacePatches)>();
        RadarScene _scene;
        double _creaseDegrees;

        public DeviceBuffer<uint2> Facets { get; } = new DeviceBuffer<uint2>("facets");
        public DeviceBuffer<float4> NormalFields { get; } = new DeviceBuffer<float4>("normals of curved facets");
        public DeviceBuffer<uint4> InstanceFacets { get; } = new DeviceBuffer<uint4>("instances");

        /// <summary>Patches of each instance of the scene: another list if the scene has changed.</summary>
        public IReadOnlyList<SurfacePatches> OfInstances { get; private set; }

        /// <summary>Meshes whose patches are kept, once for each crease angle.</summary>
        internal int MeshCount => _patches.Count;

        /// <summary>Parts of the scene.</summary>
        public SceneParts Parts { get; private set; }

        /// <summary>Takes patches of a scene's instances that are found already.</summary>
        public void Know(RadarScene scene, double creaseDegrees, SurfacePatches[] patches)
        {
            for (int i = 0; i < patches.Length; i++)
                _patches[(scene.Instances[i].Mesh, creaseDegrees)] = (scene.Instances[i].Ranges, patches[i]);
        }

        /// <summary>Uploads a scene's patches, if it or the crease angle is another one.</summary>
        /// <returns>True if it was.</returns>
        public bool Set(RadarScene scene, double creaseDegrees)
        {
            if (_scene != null && scene.IsSame(_scene) && creaseDegrees == _creaseDegrees)
                return false;
            Parts = new SceneParts(scene);
            OfInstances = Array.ConvertAll(scene.Instances, instance => PatchesOf(instance, creaseDegrees));
            DropOthers(scene);
            var facets = new List<uint2>();
            var fields = new List<float4>();
            var firsts = new List<uint4>();
            var first = new Dictionary<SurfacePatches, uint>();
            uint patchCount = 0;
            var seas = scene.SeaInstances();
            for (int i = 0; i < scene.Instances.Length; i++)
            {
                var patches = OfInstances[i];
                if (!first.TryGetValue(patches, out uint firstFacet))
                {
                    first.Add(patches, firstFacet = (uint)facets.Count);
                    AddFacets(scene.Instances[i].Mesh, patches, facets, fields);
                }
                firsts.Add(new uint4(firstFacet, patchCount, (uint)Parts.FirstOf(i), seas.Contains(i) ? 1u : 0));
                patchCount += (uint)patches.PatchCount;
            }
            Facets.Upload(facets.ToArray());
            NormalFields.Upload(fields.ToArray());
            InstanceFacets.Upload(firsts.ToArray());
            (_scene, _creaseDegrees) = (scene, creaseDegrees);
            return true;
        }

        public void Dispose()
        {
            Facets.Dispose();
            NormalFields.Dispose();
            InstanceFacets.Dispose();
            _patches.Clear();
            _scene = null;
        }

        SurfacePatches PatchesOf(in MeshInstance instance, double creaseDegrees)
        {
            var key = (instance.Mesh, creaseDegrees);
            if (_patches.TryGetValue(key, out var known) && AreAlike(known.Ranges, instance.Ranges))
                return known.Patches;
            var patches = SurfacePatches.Find(instance.Mesh, instance.Ranges, creaseDegrees);
            _patches[key] = (instance.Ranges, patches);
            return patches;
        }

        // Patches depend on the surfaces alone: objects that repeat a mesh share them.
        static bool AreAlike(MeshRange[] a, MeshRange[] b) => a == b || a != null && b != null
            && a.Select(range => (range.FirstTriangle, range.Surface))
                .SequenceEqual(b.Select(range => (range.FirstTriangle, range.Surface)));

        // Those of meshes that the scene has no more: a mesh that changes is another one in each pose.
        void DropOthers(RadarScene scene)
        {
            var meshes = new HashSet<TriangleMesh>(scene.Instances.Select(instance => instance.Mesh));
            foreach (var key in _patches.Keys.Where(key => !meshes.Contains(key.Mesh)).ToList())
                _patches.Remove(key);
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
    }
}
