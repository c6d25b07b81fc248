using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using Unity.Collections;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Mesh
{
    public Vector3[] vertices
    {
        get => Read("vertices", Contents.Vertices);
        set => SetVertices(value);
    }

    public void GetVertices(List<Vector3> vertices) => Read("vertices", Contents.Vertices, vertices);
    public void SetVertices(List<Vector3> inVertices) => StoreVertices(CollectionsMarshal.AsSpan(inVertices));
    public void SetVertices(List<Vector3> inVertices, int start, int length) =>
        StoreVertices(CollectionsMarshal.AsSpan(inVertices).Slice(start, length));
    public void SetVertices(List<Vector3> inVertices, int start, int length, MeshUpdateFlags flags) =>
        SetVertices(inVertices, start, length);
    public void SetVertices(Vector3[] inVertices) => StoreVertices(inVertices);
    public void SetVertices(Vector3[] inVertices, int start, int length) =>
        StoreVertices(inVertices.AsSpan(start, length));
    public void SetVertices(Vector3[] inVertices, int start, int length, MeshUpdateFlags flags) =>
        SetVertices(inVertices, start, length);
    public void SetVertices<T>(NativeArray<T> inVertices) where T : struct =>
        StoreVertices(Cast<T, Vector3>(inVertices.AsSpan()));
    public void SetVertices<T>(NativeArray<T> inVertices, int start, int length) where T : struct =>
        StoreVertices(Cast<T, Vector3>(inVertices.AsSpan().Slice(start, length)));
    public void SetVertices<T>(NativeArray<T> inVertices, int start, int length, MeshUpdateFlags flags)
        where T : struct => SetVertices(inVertices, start, length);

    void StoreVertices(ReadOnlySpan<Vector3> values)
    {
        if (!CanAccess("vertices"))
            return;
        foreach (SubMeshDescriptor part in Contents.SubMeshes)
        {
            if (part.indexCount > 0 && part.firstVertex + part.vertexCount > values.Length)
            {
                Debug.LogError("Mesh.vertices is too small. "
                    + "The supplied vertex array has less vertices than are referenced by the triangles array.", this);
                return;
            }
        }
        Contents.SetVertices(values);
    }

    // One value for each vertex or none; other counts are refused.
    T[] Channel<T>(string what, T[] current, ReadOnlySpan<T> values)
    {
        if (!CanAccess(what))
            return current;
        if (values.Length == 0 || values.Length == vertexCount)
            return values.ToArray();
        Debug.LogError($"Mesh.{what} is out of bounds. "
            + "The supplied array needs to be the same size as the Mesh.vertices array.", this);
        return current;
    }

    T[] Read<T>(string what, T[] channel) => CanAccess(what) ? (T[])channel.Clone() : Array.Empty<T>();

    void Read<T>(string what, T[] channel, List<T> into)
    {
        if (into == null)
            throw new ArgumentNullException(what, "The result " + what + " list cannot be null.");
        into.Clear();
        if (CanAccess(what))
            into.AddRange(channel);
    }

    static ReadOnlySpan<TTo> Cast<TFrom, TTo>(ReadOnlySpan<TFrom> data)
        where TFrom : struct
        where TTo : struct
    {
        int given = Marshal.SizeOf<TFrom>(), needed = Marshal.SizeOf<TTo>();
        if (given != needed)
            throw new ArgumentException($"The array's elements ({typeof(TFrom).Name}) have {given} bytes, "
                + $"and {typeof(TTo).Name} has {needed}.");
        return MemoryMarshal.Cast<TFrom, TTo>(data);
    }
}
