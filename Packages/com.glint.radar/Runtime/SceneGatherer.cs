using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// Collects the triangles of active GameObjects with an enabled MeshRenderer and a MeshFilter, in world space.
    /// Of a LODGroup, LOD 0 is taken. The order is that of the hierarchy, so that a scene always gives the same triangles in the same order.
    /// </summary>
    sealed class SceneGatherer
    {
        readonly List<float3> _vertices = new List<float3>();
        readonly List<int> _indices = new List<int>();
        readonly List<string> _warnings = new List<string>();

        /// <summary>Objects with a mesh of the scene last gathered.</summary>
        public int ObjectCount { get; private set; }

        /// <summary>What was left out and why, a line each.</summary>
        public IReadOnlyList<string> Warnings => _warnings;

        /// <summary>The triangles of a scene.</summary>
        /// <param name="layers">Layers to trace.</param>
        /// <param name="roots">Objects to trace with all below them; empty: every loaded scene.</param>
        /// <param name="receiver">Never traced, with all below it: it is neither target nor obstacle. May be null.</param>
        /// <exception cref="GlintException">A mesh that cannot be traced; the message names it and the remedy.</exception>
        public TriangleMesh Gather(LayerMask layers, IReadOnlyList<Transform> roots, Transform receiver)
        {
            _vertices.Clear();
            _indices.Clear();
            _warnings.Clear();
            ObjectCount = 0;
            bool IsReceiver(Renderer renderer) => receiver != null && renderer.transform.IsChildOf(receiver);
            bool IsTraced(Renderer renderer) =>
                renderer.enabled && renderer.gameObject.activeInHierarchy && (layers.value & (1 << renderer.gameObject.layer)) != 0 && !IsReceiver(renderer);

            var lowerDetail = LowerDetail();
            foreach (var renderer in Find<MeshRenderer>(roots))
                if (IsTraced(renderer) && !lowerDetail.Contains(renderer))
                    Add(renderer);

            string skinned = string.Join("', '", Find<SkinnedMeshRenderer>(roots).Where(IsTraced).Select(r => r.name));
            if (skinned.Length > 0)
                _warnings.Add($"skinned meshes are not traced: '{skinned}'. Bake them to a Mesh (SkinnedMeshRenderer.BakeMesh) to include them");
            return new TriangleMesh(_vertices.ToArray(), _indices.ToArray());
        }

        static IEnumerable<T> Find<T>(IReadOnlyList<Transform> roots) where T : Component
        {
            if (roots.Count == 0)
                return UnityEngine.Object.FindObjectsByType<T>(FindObjectsInactive.Exclude, FindObjectsSortMode.None).OrderBy(c => c.transform, HierarchyOrder.Instance);
            return roots.SelectMany(root => root.GetComponentsInChildren<T>()).Distinct();
        }

        static HashSet<Renderer> LowerDetail()
        {
            var first = new HashSet<Renderer>();
            var lower = new HashSet<Renderer>();
            foreach (var group in UnityEngine.Object.FindObjectsByType<LODGroup>(FindObjectsInactive.Exclude, FindObjectsSortMode.None))
            {
                var lods = group.GetLODs();
                lower.UnionWith(lods.Skip(1).SelectMany(lod => lod.renderers));
                first.UnionWith(lods.Take(1).SelectMany(lod => lod.renderers));
            }
            lower.ExceptWith(first);
            return lower;
        }

        void Add(MeshRenderer renderer)
        {
            if (!renderer.TryGetComponent<MeshFilter>(out var filter))
                return;
            var mesh = filter.sharedMesh;
            if (mesh == null)
            {
                _warnings.Add($"MeshFilter of '{renderer.name}' has no mesh and is not traced: assign one, or disable its MeshRenderer");
                return;
            }
            if (renderer.isPartOfStaticBatch)
                throw new GlintException($"'{renderer.name}' is part of a static batch, whose meshes Unity has merged: clear Batching Static among the static flags of '{renderer.name}'");
            string subject = $"mesh '{mesh.name}' of '{renderer.name}'";
            if (!mesh.isReadable)
                throw new GlintException($"{subject} is not readable: tick Read/Write in the mesh's import settings");

            ObjectCount++;
            int first = _vertices.Count;
            AddVertices(mesh.vertices, renderer.localToWorldMatrix, subject);
            for (int submesh = 0; submesh < mesh.subMeshCount; submesh++)
                AddSubmesh(mesh, submesh, first, subject);
        }

        void AddVertices(Vector3[] vertices, Matrix4x4 toWorld, string subject)
        {
            for (int i = 0; i < vertices.Length; i++)
            {
                float3 position = toWorld.MultiplyPoint3x4(vertices[i]);
                if (!math.all(math.abs(position) <= TriangleMesh.LargestCoordinate))
                    throw new GlintException(FormattableString.Invariant($"{subject}: vertex {i} lies at ({position.x}, {position.y}, {position.z}) m in the world, where every coordinate must be within {TriangleMesh.LargestCoordinate} m: mend the mesh, or the scale of the object and its parents"));
                _vertices.Add(position);
            }
        }

        void AddSubmesh(Mesh mesh, int submesh, int first, string subject)
        {
            var topology = mesh.GetTopology(submesh);
            if (topology != MeshTopology.Triangles && topology != MeshTopology.Quads)
                throw new GlintException($"submesh {submesh} of {subject} is made of {topology}: the radar traces triangles and quads, remove the submesh or disable the MeshRenderer");
            var indices = mesh.GetIndices(submesh);
            int corners = topology == MeshTopology.Quads ? 4 : 3;
            if (indices.Length % corners != 0)
                throw new GlintException($"submesh {submesh} of {subject} has {indices.Length} indices, no multiple of {corners}: mend the mesh");
            int vertexCount = _vertices.Count - first;
            foreach (int index in indices)
                if (index < 0 || index >= vertexCount)
                    throw new GlintException($"submesh {submesh} of {subject} has index {index}, and the mesh has {vertexCount} vertices: mend the mesh");

            for (int i = 0; i < indices.Length; i += corners)
            {
                AddTriangle(first, indices[i], indices[i + 1], indices[i + 2]);
                if (corners == 4)
                    AddTriangle(first, indices[i], indices[i + 2], indices[i + 3]);
            }
        }

        void AddTriangle(int first, int a, int b, int c)
        {
            _indices.Add(first + a);
            _indices.Add(first + b);
            _indices.Add(first + c);
        }
    }
}
