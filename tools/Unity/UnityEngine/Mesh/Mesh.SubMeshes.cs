using System;
using System.Linq;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Mesh
{
    public int subMeshCount
    {
        get => Contents.SubMeshes.Count;
        set
        {
            if (value < 0)
                throw new ArgumentOutOfRangeException(nameof(value), value,
                    "subMeshCount can't be set to negative value");
            var parts = Contents.SubMeshes;
            if (value < parts.Count)
                parts.RemoveRange(value, parts.Count - value);
            int end = parts.Count == 0 ? 0 : parts.Max(part => part.indexStart + part.indexCount);
            Contents.Indices = Contents.Indices.AsSpan(0, Math.Min(end, Contents.Indices.Length)).ToArray();
            while (parts.Count < value)
                parts.Add(new SubMeshDescriptor(end, 0));
        }
    }

    public SubMeshDescriptor GetSubMesh(int index) => Contents.SubMeshes[Checked(index)];
    public uint GetIndexStart(int submesh) => (uint)GetSubMesh(submesh).indexStart;
    public uint GetIndexCount(int submesh) => (uint)GetSubMesh(submesh).indexCount;
    public uint GetBaseVertex(int submesh) => (uint)GetSubMesh(submesh).baseVertex;

    public MeshTopology GetTopology(int submesh)
    {
        if (submesh >= 0 && submesh < subMeshCount)
            return Contents.SubMeshes[submesh].topology;
        Debug.LogError("Failed getting topology. Submesh index is out of bounds.", this);
        return MeshTopology.Triangles;
    }

    public void SetSubMesh(int index, SubMeshDescriptor desc, MeshUpdateFlags flags = MeshUpdateFlags.Default)
    {
        Checked(index);
        if (desc.indexStart < 0 || desc.indexCount < 0
            || desc.indexStart + (long)desc.indexCount > Contents.Indices.Length)
        {
            throw new ArgumentException($"Submesh {index} of mesh '{name}' takes indices {desc.indexStart} to "
                + $"{desc.indexStart + (long)desc.indexCount}, "
                + $"and the index buffer has {Contents.Indices.Length}.");
        }
        Contents.SubMeshes[index] = desc;
        if ((flags & MeshUpdateFlags.DontRecalculateBounds) != 0)
            return;
        Contents.Measure(index);
        Contents.UniteBounds();
    }

    /// <summary>Keeps the part of the index buffer that fits.</summary>
    public void SetIndexBufferParams(int indexCount, IndexFormat format)
    {
        if (!CanAccess("triangles/indices"))
            return;
        var indices = new int[indexCount];
        Array.Copy(Contents.Indices, indices, Math.Min(indexCount, Contents.Indices.Length));
        Contents.Indices = indices;
        Contents.IndexFormat = format;
    }

    int Checked(int index)
    {
        if (index < 0 || index >= subMeshCount)
            throw new IndexOutOfRangeException($"Specified sub mesh ({index}) is out of range. "
                + $"Must be greater or equal to 0 and less than {subMeshCount}.");
        return index;
    }
}
