using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace UnityEngine;

public sealed partial class Mesh
{
    /// <summary>Indices of all submeshes with faces, base vertices applied; setting it leaves one submesh.</summary>
    public int[] triangles
    {
        get
        {
            var all = new List<int>();
            for (int i = 0; i < subMeshCount && CanAccess("triangles/indices"); i++)
            {
                if (GetTopology(i) is MeshTopology.Triangles or MeshTopology.Quads)
                    all.AddRange(Triangles(i, true));
            }
            return all.ToArray();
        }
        set
        {
            if (!CanAccess("triangles/indices"))
                return;
            subMeshCount = 1;
            SetTriangles(value, 0);
        }
    }

    public int[] GetTriangles(int submesh) => GetTriangles(submesh, true);

    public int[] GetTriangles(int submesh, bool applyBaseVertex)
    {
        if (!CanGet("triangles", submesh))
            return Array.Empty<int>();
        if (GetTopology(submesh) is MeshTopology.Triangles or MeshTopology.Quads)
            return Triangles(submesh, applyBaseVertex);
        Debug.LogError("Failed getting triangles. Submesh topology is lines or points.", this);
        return Array.Empty<int>();
    }

    public void GetTriangles(List<int> triangles, int submesh) => GetTriangles(triangles, submesh, true);
    public void GetTriangles(List<int> triangles, int submesh, bool applyBaseVertex) =>
        Fill(triangles, GetTriangles(submesh, applyBaseVertex));
    public int[] GetIndices(int submesh) => GetIndices(submesh, true);

    public int[] GetIndices(int submesh, bool applyBaseVertex)
    {
        return CanGet("indices", submesh) ? Indices(submesh, applyBaseVertex) : Array.Empty<int>();
    }

    public void GetIndices(List<int> indices, int submesh) => GetIndices(indices, submesh, true);

    /// <summary>Without allocation, as in Unity, since programs read meshes repeatedly.</summary>
    public void GetIndices(List<int> indices, int submesh, bool applyBaseVertex)
    {
        if (indices == null)
            throw new ArgumentNullException(nameof(indices), "The result list cannot be null.");
        indices.Clear();
        if (!CanGet("indices", submesh))
            return;
        indices.AddRange(Contents.IndicesOf(submesh));
        AddBaseVertex(CollectionsMarshal.AsSpan(indices), submesh, applyBaseVertex);
    }

    bool CanGet(string what, int subMesh)
    {
        if (!CanAccess("triangles/indices"))
            return false;
        if (subMesh >= 0 && subMesh < subMeshCount)
            return true;
        Debug.LogError($"Failed getting {what}. Submesh index is out of bounds.", this);
        return false;
    }

    int[] Triangles(int subMesh, bool applyBaseVertex)
    {
        int[] corners = Indices(subMesh, applyBaseVertex);
        if (GetTopology(subMesh) == MeshTopology.Triangles)
            return corners;
        var triangles = new int[corners.Length / 4 * 6];
        for (int quad = 0; quad < corners.Length / 4; quad++)
        {
            int from = quad * 4, to = quad * 6;
            triangles[to] = triangles[to + 3] = corners[from];
            triangles[to + 1] = corners[from + 1];
            triangles[to + 2] = triangles[to + 4] = corners[from + 2];
            triangles[to + 5] = corners[from + 3];
        }
        return triangles;
    }

    int[] Indices(int subMesh, bool applyBaseVertex)
    {
        int[] indices = Contents.IndicesOf(subMesh).ToArray();
        AddBaseVertex(indices, subMesh, applyBaseVertex);
        return indices;
    }

    void AddBaseVertex(Span<int> indices, int subMesh, bool applyBaseVertex)
    {
        int offset = applyBaseVertex ? Contents.SubMeshes[subMesh].baseVertex : 0;
        for (int i = 0; offset != 0 && i < indices.Length; i++)
            indices[i] += offset;
    }

    static void Fill(List<int> list, int[] values)
    {
        if (list == null)
            throw new ArgumentNullException(nameof(list), "The result list cannot be null.");
        list.Clear();
        list.AddRange(values);
    }
}
