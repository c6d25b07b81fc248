using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using Unity.Collections;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Mesh
{
    public void SetTriangles(int[] triangles, int submesh) =>
        Store("triangles", triangles, MeshTopology.Triangles, submesh, true, 0);
    public void SetTriangles(int[] triangles, int submesh, bool calculateBounds) =>
        Store("triangles", triangles, MeshTopology.Triangles, submesh, calculateBounds, 0);
    public void SetTriangles(int[] triangles, int submesh, bool calculateBounds, int baseVertex) =>
        Store("triangles", triangles, MeshTopology.Triangles, submesh, calculateBounds, baseVertex);

    public void SetTriangles(int[] triangles, int trianglesStart, int trianglesLength, int submesh,
        bool calculateBounds = true, int baseVertex = 0)
    {
        Store("triangles", triangles.AsSpan(trianglesStart, trianglesLength), MeshTopology.Triangles, submesh,
            calculateBounds, baseVertex);
    }

    public void SetTriangles(ushort[] triangles, int submesh, bool calculateBounds = true, int baseVertex = 0) =>
        Store("triangles", Widened(triangles), MeshTopology.Triangles, submesh, calculateBounds, baseVertex);

    public void SetTriangles(ushort[] triangles, int trianglesStart, int trianglesLength, int submesh,
        bool calculateBounds = true, int baseVertex = 0)
    {
        Store("triangles", Widened(triangles.AsSpan(trianglesStart, trianglesLength)), MeshTopology.Triangles, submesh,
            calculateBounds, baseVertex);
    }

    public void SetTriangles(List<int> triangles, int submesh) =>
        Store("triangles", CollectionsMarshal.AsSpan(triangles), MeshTopology.Triangles, submesh, true, 0);
    public void SetTriangles(List<int> triangles, int submesh, bool calculateBounds) =>
        Store("triangles", CollectionsMarshal.AsSpan(triangles), MeshTopology.Triangles, submesh, calculateBounds, 0);
    public void SetTriangles(List<int> triangles, int submesh, bool calculateBounds, int baseVertex) =>
        Store("triangles", CollectionsMarshal.AsSpan(triangles), MeshTopology.Triangles, submesh,
            calculateBounds, baseVertex);

    public void SetTriangles(List<int> triangles, int trianglesStart, int trianglesLength, int submesh,
        bool calculateBounds = true, int baseVertex = 0)
    {
        Store("triangles", CollectionsMarshal.AsSpan(triangles).Slice(trianglesStart, trianglesLength),
            MeshTopology.Triangles, submesh, calculateBounds, baseVertex);
    }

    public void SetTriangles(List<ushort> triangles, int submesh, bool calculateBounds = true, int baseVertex = 0) =>
        Store("triangles", Widened(triangles?.ToArray()), MeshTopology.Triangles, submesh, calculateBounds, baseVertex);

    public void SetTriangles(List<ushort> triangles, int trianglesStart, int trianglesLength, int submesh,
        bool calculateBounds = true, int baseVertex = 0)
    {
        Store("triangles", Widened(triangles.GetRange(trianglesStart, trianglesLength).ToArray()),
            MeshTopology.Triangles, submesh, calculateBounds, baseVertex);
    }

    public void SetIndices(int[] indices, MeshTopology topology, int submesh) =>
        Store("indices", indices, topology, submesh, true, 0);
    public void SetIndices(int[] indices, MeshTopology topology, int submesh, bool calculateBounds) =>
        Store("indices", indices, topology, submesh, calculateBounds, 0);
    public void SetIndices(int[] indices, MeshTopology topology, int submesh, bool calculateBounds, int baseVertex) =>
        Store("indices", indices, topology, submesh, calculateBounds, baseVertex);

    public void SetIndices(int[] indices, int indicesStart, int indicesLength, MeshTopology topology, int submesh,
        bool calculateBounds = true, int baseVertex = 0)
    {
        Store("indices", indices.AsSpan(indicesStart, indicesLength), topology, submesh, calculateBounds, baseVertex);
    }

    public void SetIndices(ushort[] indices, MeshTopology topology, int submesh, bool calculateBounds = true,
        int baseVertex = 0) => Store("indices", Widened(indices), topology, submesh, calculateBounds, baseVertex);

    public void SetIndices(ushort[] indices, int indicesStart, int indicesLength, MeshTopology topology, int submesh,
        bool calculateBounds = true, int baseVertex = 0)
    {
        Store("indices", Widened(indices.AsSpan(indicesStart, indicesLength)), topology, submesh,
            calculateBounds, baseVertex);
    }

    public void SetIndices(List<int> indices, MeshTopology topology, int submesh, bool calculateBounds = true,
        int baseVertex = 0) =>
        Store("indices", CollectionsMarshal.AsSpan(indices), topology, submesh, calculateBounds, baseVertex);

    public void SetIndices(List<int> indices, int indicesStart, int indicesLength, MeshTopology topology, int submesh,
        bool calculateBounds = true, int baseVertex = 0)
    {
        Store("indices", CollectionsMarshal.AsSpan(indices).Slice(indicesStart, indicesLength), topology, submesh,
            calculateBounds, baseVertex);
    }

    public void SetIndices(List<ushort> indices, MeshTopology topology, int submesh, bool calculateBounds = true,
        int baseVertex = 0) =>
        Store("indices", Widened(indices?.ToArray()), topology, submesh, calculateBounds, baseVertex);

    public void SetIndices(List<ushort> indices, int indicesStart, int indicesLength, MeshTopology topology,
        int submesh, bool calculateBounds = true, int baseVertex = 0)
    {
        Store("indices", Widened(indices.GetRange(indicesStart, indicesLength).ToArray()), topology, submesh,
            calculateBounds, baseVertex);
    }

    public void SetIndices<T>(NativeArray<T> indices, MeshTopology topology, int submesh,
            bool calculateBounds = true, int baseVertex = 0)
        where T : struct
    {
        SetIndices(indices, 0, indices.Length, topology, submesh, calculateBounds, baseVertex);
    }

    public void SetIndices<T>(NativeArray<T> indices, int indicesStart, int indicesLength, MeshTopology topology,
            int submesh, bool calculateBounds = true, int baseVertex = 0)
        where T : struct
    {
        ReadOnlySpan<T> values = indices.AsSpan().Slice(indicesStart, indicesLength);
        ReadOnlySpan<int> wide =
            Marshal.SizeOf<T>() == sizeof(ushort) ? Widened(Cast<T, ushort>(values)) : Cast<T, int>(values);
        Store("indices", wide, topology, submesh, calculateBounds, baseVertex);
    }

    void Store(string what, ReadOnlySpan<int> indices, MeshTopology topology, int subMesh,
        bool calculateBounds, int baseVertex)
    {
        if (!CanAccess("triangles/indices"))
            return;
        string trouble = Trouble(indices, topology, subMesh, baseVertex);
        if (trouble != null)
        {
            Debug.LogError($"Failed setting {what}. {trouble}", this);
            return;
        }
        Contents.ReplaceIndices(subMesh, indices, topology, baseVertex);
        Contents.Measure(subMesh, calculateBounds);
        if (calculateBounds)
            Contents.UniteBounds();
    }

    // In Unity an index of more than 16 bits wraps around; here it is an error, since the mesh would be wrong.
    string Trouble(ReadOnlySpan<int> indices, MeshTopology topology, int subMesh, int baseVertex)
    {
        if (subMesh < 0 || subMesh >= subMeshCount)
            return "Submesh index is out of bounds.";
        int corners =
            topology switch { MeshTopology.Triangles => 3, MeshTopology.Quads => 4, MeshTopology.Lines => 2, _ => 1 };
        if (indices.Length % corners != 0)
            return $"The number of supplied {(corners == 3 ? "triangle" : topology.ToString().ToLowerInvariant())} "
                + $"indices must be a multiple of {corners}.";
        foreach (int index in indices)
        {
            if (index + (long)baseVertex < 0 || index + (long)baseVertex >= vertexCount)
                return $"Some indices are referencing out of bounds vertices. IndexCount: {indices.Length}, "
                    + $"VertexCount: {vertexCount}";
            if (indexFormat == IndexFormat.UInt16 && index > ushort.MaxValue)
                return $"Index {index} does not fit 16 bits: set indexFormat to IndexFormat.UInt32 first.";
        }
        return null;
    }

    static int[] Widened(ReadOnlySpan<ushort> indices)
    {
        var wide = new int[indices.Length];
        for (int i = 0; i < wide.Length; i++)
            wide[i] = indices[i];
        return wide;
    }
}
