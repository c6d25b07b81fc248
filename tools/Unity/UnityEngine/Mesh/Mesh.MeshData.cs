using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Host;
using Unity.Collections;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Mesh
{
    /// <summary>Snapshots that may be read from any thread.</summary>
    public static MeshDataArray AcquireReadOnlyMeshData(Mesh mesh) => new(new[] { mesh });
    public static MeshDataArray AcquireReadOnlyMeshData(Mesh[] meshes) => new(meshes);
    public static MeshDataArray AcquireReadOnlyMeshData(List<Mesh> meshes) => new(meshes);

    public struct MeshDataArray : IDisposable
    {
        MeshContents[] _items;

        internal MeshDataArray(IEnumerable<Mesh> meshes) => _items = meshes.Select(Snapshot).ToArray();

        public int Length => Items.Length;
        public MeshData this[int index] => new(Items[index]);
        public void Dispose() => _items = null;

        MeshContents[] Items => _items ?? throw new ObjectDisposedException(nameof(MeshDataArray));

        static MeshContents Snapshot(Mesh mesh)
        {
            if (mesh == null)
                throw new ArgumentNullException(nameof(mesh), "Mesh is null.");
            return mesh.isReadable
                ? mesh.Contents.Copy()
                : throw new InvalidOperationException(mesh.Refusal("vertex data"));
        }
    }

    public struct MeshData
    {
        readonly MeshContents _contents;

        internal MeshData(MeshContents contents) => _contents = contents;

        public int vertexCount => _contents.Vertices.Length;
        public IndexFormat indexFormat => _contents.IndexFormat;
        public int subMeshCount => _contents.SubMeshes.Count;
        public bool HasVertexAttribute(VertexAttribute attr) => _contents.Has(attr);

        public void GetVertices(NativeArray<Vector3> outVertices) => Copy(_contents.Vertices, outVertices);

        public void GetNormals(NativeArray<Vector3> outNormals)
        {
            if (!_contents.Has(VertexAttribute.Normal))
                throw new InvalidOperationException("The mesh data has no vertex attribute Normal.");
            Copy(_contents.Normals, outNormals);
        }

        public SubMeshDescriptor GetSubMesh(int index)
        {
            if (index < 0 || index >= subMeshCount)
                throw new IndexOutOfRangeException($"Specified sub mesh ({index}) is out of range. "
                    + $"Must be greater or equal to 0 and less than {subMeshCount}.");
            return _contents.SubMeshes[index];
        }

        public void GetIndices(NativeArray<int> outIndices, int submesh, bool applyBaseVertex = true)
        {
            int offset = applyBaseVertex ? GetSubMesh(submesh).baseVertex : 0;
            ReadOnlySpan<int> indices = _contents.IndicesOf(submesh);
            Span<int> output = Room(outIndices, indices.Length);
            for (int i = 0; i < indices.Length; i++)
                output[i] = indices[i] + offset;
        }

        public void GetIndices(NativeArray<ushort> outIndices, int submesh, bool applyBaseVertex = true)
        {
            int offset = applyBaseVertex ? GetSubMesh(submesh).baseVertex : 0;
            ReadOnlySpan<int> indices = _contents.IndicesOf(submesh);
            Span<ushort> output = Room(outIndices, indices.Length);
            for (int i = 0; i < indices.Length; i++)
                output[i] = (ushort)(indices[i] + offset);
        }

        static void Copy<T>(T[] channel, NativeArray<T> output)
            where T : struct
        {
            channel.CopyTo(Room(output, channel.Length));
        }

        static Span<T> Room<T>(NativeArray<T> output, int needed)
            where T : struct
        {
            if (output.Length < needed)
                throw new InvalidOperationException($"The output array has {output.Length} elements, "
                    + $"and {needed} are needed.");
            return output.AsSpan();
        }
    }
}
