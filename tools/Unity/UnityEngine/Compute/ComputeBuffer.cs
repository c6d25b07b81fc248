using System;
using System.Collections.Generic;
using Glint.Host;
using Unity.Collections;

namespace UnityEngine;

public sealed class ComputeBuffer : IDisposable
{
    public ComputeBuffer(int count, int stride)
        : this(count, stride, ComputeBufferType.Default)
    {
    }

    public ComputeBuffer(int count, int stride, ComputeBufferType type)
        : this(count, stride, type, ComputeBufferMode.Immutable)
    {
    }

    public ComputeBuffer(int count, int stride, ComputeBufferType type, ComputeBufferMode usage)
    {
        if ((type & (ComputeBufferType.Append | ComputeBufferType.Counter)) != 0)
            throw new NotSupportedException("buffers with a hidden counter run in Unity only; "
                + "count in a buffer of your own with InterlockedAdd");
        Elements = new StructuredBuffer(nameof(ComputeBuffer), count, stride, new BufferUses(
            type == ComputeBufferType.Default || (type & ComputeBufferType.Structured) != 0,
            (type & ComputeBufferType.Raw) != 0,
            (type & ComputeBufferType.IndirectArguments) != 0));
    }

    ~ComputeBuffer() => Elements?.Leak();

    public int count => Elements.Count;

    public int stride => Elements.Stride;

    public string name
    {
        set { }
    }

    internal StructuredBuffer Elements { get; }

    public bool IsValid() => Elements.IsValid;

    public void Release()
    {
        Elements.Release();
        GC.SuppressFinalize(this);
    }

    public void Dispose() => Release();

    public void SetData(Array data) => Elements.Set(data);

    public void SetData(Array data, int managedBufferStartIndex, int computeBufferStartIndex, int count) =>
        Elements.Set(data, managedBufferStartIndex, computeBufferStartIndex, count);

    public void SetData<T>(List<T> data) where T : struct =>
        Elements.Set(data, 0, 0, data?.Count ?? 0);

    public void SetData<T>(List<T> data, int managedBufferStartIndex, int computeBufferStartIndex, int count)
        where T : struct =>
        Elements.Set(data, managedBufferStartIndex, computeBufferStartIndex, count);

    public void SetData<T>(NativeArray<T> data) where T : struct =>
        Elements.Set(data, 0, 0, data.Length);

    public void SetData<T>(NativeArray<T> data, int nativeBufferStartIndex, int computeBufferStartIndex, int count)
        where T : struct =>
        Elements.Set(data, nativeBufferStartIndex, computeBufferStartIndex, count);

    public void GetData(Array data) => Elements.Get(data);

    public void GetData(Array data, int managedBufferStartIndex, int computeBufferStartIndex, int count) =>
        Elements.Get(data, managedBufferStartIndex, computeBufferStartIndex, count);
}
