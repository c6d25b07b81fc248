using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace Glint.Host;

/// <summary>
/// Contents of a mesh, unchecked: a stored asset may have indices out of range or NaN, which its readers must detect.
/// Arrays are replaced, never changed in place, so that copies may share them.
/// </summary>
internal sealed class MeshContents
{
    internal const int UvChannels = 8;

    internal Vector3[] Vertices = Array.Empty<Vector3>();
    internal Vector3[] Normals = Array.Empty<Vector3>();
    internal Vector4[] Tangents = Array.Empty<Vector4>();
    internal Color[] Colors = Array.Empty<Color>();

    /// <summary>Four components for each channel, whatever it stores; unused ones are zero.</summary>
    internal Vector4[][] Uvs = NoUvs();

    /// <summary>The index buffer of all submeshes.</summary>
    internal int[] Indices = Array.Empty<int>();

    internal IndexFormat IndexFormat;
    internal List<SubMeshDescriptor> SubMeshes = new() { default };
    internal bool IsReadable = true;
    internal Bounds Bounds;

    internal MeshContents Copy()
    {
        var copy = (MeshContents)MemberwiseClone();
        copy.Uvs = (Vector4[][])Uvs.Clone();
        copy.SubMeshes = new List<SubMeshDescriptor>(SubMeshes);
        return copy;
    }

    internal ReadOnlySpan<int> IndicesOf(int subMesh)
    {
        return Indices.AsSpan(SubMeshes[subMesh].indexStart, SubMeshes[subMesh].indexCount);
    }

    internal bool Has(VertexAttribute attribute) => attribute switch
    {
        VertexAttribute.Position => Vertices.Length > 0,
        VertexAttribute.Normal => Normals.Length > 0,
        VertexAttribute.Tangent => Tangents.Length > 0,
        VertexAttribute.Color => Colors.Length > 0,
        >= VertexAttribute.TexCoord0 and <= VertexAttribute.TexCoord7 =>
            Uvs[attribute - VertexAttribute.TexCoord0].Length > 0,
        _ => false,
    };

    /// <summary>Resizes all vertex channels except the position, since the vertex buffer is one.</summary>
    internal void SetVertices(ReadOnlySpan<Vector3> vertices)
    {
        bool resized = vertices.Length != Vertices.Length;
        Vertices = vertices.ToArray();
        if (!resized)
            return;
        Normals = Resized(Normals);
        Tangents = Resized(Tangents);
        Colors = Resized(Colors);
        for (int channel = 0; channel < UvChannels; channel++)
            Uvs[channel] = Resized(Uvs[channel]);
    }

    /// <summary>Inserts the indices of one submesh between those of the others, in submesh order.</summary>
    internal void ReplaceIndices(int subMesh, ReadOnlySpan<int> indices, MeshTopology topology, int baseVertex)
    {
        var all = new List<int>();
        for (int i = 0; i < SubMeshes.Count; i++)
        {
            SubMeshDescriptor part = SubMeshes[i];
            ReadOnlySpan<int> own = i == subMesh ? indices : IndicesOf(i);
            part.indexStart = all.Count;
            part.indexCount = own.Length;
            if (i == subMesh)
            {
                part.topology = topology;
                part.baseVertex = baseVertex;
            }
            all.AddRange(own);
            SubMeshes[i] = part;
        }
        Indices = all.ToArray();
    }

    /// <summary>Range of the vertices of a submesh and, if requested, their bounds.</summary>
    internal void Measure(int subMesh, bool bounds = true)
    {
        SubMeshDescriptor part = SubMeshes[subMesh];
        int first = int.MaxValue, last = int.MinValue;
        foreach (int index in IndicesOf(subMesh))
        {
            first = Math.Min(first, index);
            last = Math.Max(last, index);
        }
        bool any = part.indexCount > 0;
        part.firstVertex = any ? first + part.baseVertex : 0;
        part.vertexCount = any ? last - first + 1 : 0;
        if (bounds)
        {
            int start = Math.Clamp(part.firstVertex, 0, Vertices.Length);
            int end = Math.Clamp(part.firstVertex + part.vertexCount, start, Vertices.Length);
            part.bounds = BoundsOf(Vertices.AsSpan(start, end - start));
        }
        SubMeshes[subMesh] = part;
    }

    /// <summary>Unites the bounds of the submeshes; for a mesh without indices those of all vertices.</summary>
    internal void UniteBounds()
    {
        Bounds? united = null;
        foreach (SubMeshDescriptor part in SubMeshes)
        {
            if (part.indexCount == 0)
                continue;
            Bounds sum = united ?? part.bounds;
            sum.Encapsulate(part.bounds);
            united = sum;
        }
        Bounds = united ?? BoundsOf(Vertices);
    }

    static Bounds BoundsOf(ReadOnlySpan<Vector3> points)
    {
        if (points.IsEmpty)
            return default;
        Vector3 low = points[0], high = points[0];
        foreach (Vector3 point in points)
        {
            low = Vector3.Min(low, point);
            high = Vector3.Max(high, point);
        }
        return new Bounds((low + high) * 0.5f, high - low);
    }

    T[] Resized<T>(T[] channel)
    {
        if (channel.Length == 0)
            return channel;
        var resized = new T[Vertices.Length];
        Array.Copy(channel, resized, Math.Min(channel.Length, resized.Length));
        return resized;
    }

    static Vector4[][] NoUvs()
    {
        var channels = new Vector4[UvChannels][];
        Array.Fill(channels, Array.Empty<Vector4>());
        return channels;
    }
}
