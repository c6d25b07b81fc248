using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using Unity.Collections;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Mesh
{
    public void SetIndexBufferData<T>(NativeArray<T> data, int dataStart, int meshBufferStart, int count,
            MeshUpdateFlags flags = MeshUpdateFlags.Default)
        where T : struct
    {
        Store<T>(data.AsSpan().Slice(dataStart, count), meshBufferStart, flags);
    }

    public void SetIndexBufferData<T>(T[] data, int dataStart, int meshBufferStart, int count,
            MeshUpdateFlags flags = MeshUpdateFlags.Default)
        where T : struct
    {
        Store<T>(data.AsSpan(dataStart, count), meshBufferStart, flags);
    }

    public void SetIndexBufferData<T>(List<T> data, int dataStart, int meshBufferStart, int count,
            MeshUpdateFlags flags = MeshUpdateFlags.Default)
        where T : struct
    {
        Store<T>(CollectionsMarshal.AsSpan(data).Slice(dataStart, count), meshBufferStart, flags);
    }

    void Store<T>(ReadOnlySpan<T> data, int start, MeshUpdateFlags flags)
        where T : struct
    {
        if (!CanAccess("triangles/indices"))
            return;
        ReadOnlySpan<int> indices =
            indexFormat == IndexFormat.UInt16 ? Widened(Cast<T, ushort>(data)) : Cast<T, int>(data);
        bool validate = (flags & MeshUpdateFlags.DontValidateIndices) == 0;
        foreach (int index in indices)
        {
            if (validate && (uint)index >= vertexCount)
                throw new ArgumentException($"Index {index} of mesh '{name}' is out of range: "
                    + $"the mesh has {vertexCount} vertices.");
        }
        var buffer = (int[])Contents.Indices.Clone();
        indices.CopyTo(buffer.AsSpan(start));
        Contents.Indices = buffer;
    }
}
