using System;
using System.Collections.Generic;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>Reads meshes through reused lists, so that checking an unchanged mesh allocates nothing.</summary>
    sealed class MeshReader
    {
        const int BytesPerVertex = 12, BytesPerIndex = 4;

        readonly List<Vector3> _vertices = new List<Vector3>();
        readonly List<int> _indices = new List<int>();

        /// <summary>Bytes of vertices and indices hashed so far.</summary>
        public long BytesHashed { get; private set; }

        /// <summary>Hash of everything that determines a mesh's triangles.</summary>
        public ulong Hash(Mesh mesh)
        {
            var hash = new ContentHash();
            mesh.GetVertices(_vertices);
            hash.Add(_vertices);
            BytesHashed += BytesPerVertex * (long)_vertices.Count;
            int submeshes = mesh.subMeshCount;
            hash.Add(submeshes);
            for (int submesh = 0; submesh < submeshes; submesh++)
            {
                hash.Add((int)mesh.GetTopology(submesh));
                mesh.GetIndices(_indices, submesh);
                hash.Add(_indices);
                BytesHashed += BytesPerIndex * (long)_indices.Count;
            }
            return hash.Value;
        }

        /// <summary>The box around all vertices; NaN if a vertex is NaN.</summary>
        public void Measure(Mesh mesh, out float3 boxMin, out float3 boxMax)
        {
            mesh.GetVertices(_vertices);
            (boxMin, boxMax) = (float.PositiveInfinity, float.NegativeInfinity);
            bool isFinite = true;
            foreach (float3 vertex in _vertices)
            {
                boxMin = math.min(boxMin, vertex);
                boxMax = math.max(boxMax, vertex);
                isFinite &= math.all(math.isfinite(vertex));
            }
            if (!isFinite)
                (boxMin, boxMax) = (float.NaN, float.NaN);
        }

        /// <summary>Triangles of each submesh.</summary>
        /// <param name="owner">Renderer of the mesh, for messages.</param>
        /// <exception cref="GlintException">A submesh has no faces, or invalid indices.</exception>
        public int[] CountTriangles(Mesh mesh, Renderer owner)
        {
            int vertices = mesh.vertexCount;
            var triangles = new int[mesh.subMeshCount];
            for (int submesh = 0; submesh < mesh.subMeshCount; submesh++)
            {
                var topology = mesh.GetTopology(submesh);
                if (topology != MeshTopology.Triangles && topology != MeshTopology.Quads)
                    throw new GlintException($"submesh {submesh} of {Subject(mesh, owner)} is made of {topology}: "
                        + "the radar traces triangles and quads, remove the submesh or disable the MeshRenderer");
                mesh.GetIndices(_indices, submesh);
                int corners = topology == MeshTopology.Quads ? 4 : 3;
                if (_indices.Count % corners != 0)
                    throw new GlintException($"submesh {submesh} of {Subject(mesh, owner)} has {_indices.Count} "
                        + $"indices, not a multiple of {corners}: correct the mesh");
                foreach (int index in _indices)
                    if (index < 0 || index >= vertices)
                        throw new GlintException($"submesh {submesh} of {Subject(mesh, owner)} has index {index}, "
                            + $"and the mesh has {vertices} vertices: correct the mesh");
                triangles[submesh] = _indices.Count / corners * (corners - 2);
            }
            return triangles;
        }

        /// <summary>
        /// Refuses a transform that puts a vertex outside the range in which float32 resolves a metre.
        /// </summary>
        /// <exception cref="GlintException">A vertex is too far away; the message names it.</exception>
        public void CheckTransform(Mesh mesh, in Affine toScene, Renderer owner)
        {
            mesh.GetVertices(_vertices);
            for (int i = 0; i < _vertices.Count; i++)
            {
                double3 inScene = toScene.Point((float3)_vertices[i]);
                if (math.all(math.abs(inScene) <= TriangleMesh.LargestCoordinate))
                    continue;
                var position = (float3)inScene;
                throw new GlintException(FormattableString.Invariant(
                    $"{Subject(mesh, owner)}: vertex {i} lies at ({position.x}, {position.y}, {position.z}) m in the scene, where every coordinate must be within {TriangleMesh.LargestCoordinate} m: correct the mesh, or the position, rotation or scale of the object or of one above it"));
            }
        }

        /// <summary>Appends a mesh's triangles.</summary>
        /// <param name="transform">
        /// From the mesh's coordinates to those of the written vertices; applied in double, then rounded.
        /// </param>
        /// <param name="vertexCount">Number of vertices; increased.</param>
        /// <param name="indexCount">Number of indices; increased.</param>
        public void Append(Mesh mesh, in Affine transform, float3[] vertices, ref int vertexCount,
            int[] indices, ref int indexCount)
        {
            int first = vertexCount;
            mesh.GetVertices(_vertices);
            foreach (float3 vertex in _vertices)
                vertices[vertexCount++] = (float3)transform.Point(vertex);
            for (int submesh = 0; submesh < mesh.subMeshCount; submesh++)
            {
                mesh.GetIndices(_indices, submesh);
                if (mesh.GetTopology(submesh) == MeshTopology.Quads)
                    AppendQuads(first, indices, ref indexCount);
                else
                    foreach (int index in _indices)
                        indices[indexCount++] = first + index;
            }
        }

        void AppendQuads(int first, int[] indices, ref int count)
        {
            for (int i = 0; i < _indices.Count; i += 4)
            {
                int a = first + _indices[i], b = first + _indices[i + 1], c = first + _indices[i + 2],
                    d = first + _indices[i + 3];
                (indices[count], indices[count + 1], indices[count + 2]) = (a, b, c);
                (indices[count + 3], indices[count + 4], indices[count + 5]) = (a, c, d);
                count += 6;
            }
        }

        static string Subject(Mesh mesh, Renderer owner) => $"mesh '{mesh.name}' of '{owner.name}'";
    }
}
