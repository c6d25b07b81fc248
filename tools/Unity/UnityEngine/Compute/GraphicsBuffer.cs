using System;
using System.Collections.Generic;
using Glint.Host;
using Unity.Collections;

namespace UnityEngine;

public sealed class GraphicsBuffer : IDisposable
{
    public GraphicsBuffer(Target target, int count, int stride)
        : this(target, UsageFlags.None, count, stride)
    {
    }

    public GraphicsBuffer(Target target, UsageFlags usageFlags, int count, int stride)
    {
        if ((target & (Target.Append | Target.Counter)) != 0)
            throw new NotSupportedException("buffers with a hidden counter run in Unity only; "
                + "count in a buffer of your own with InterlockedAdd");
        this.target = target;
        this.usageFlags = usageFlags;
        Elements = new StructuredBuffer(nameof(GraphicsBuffer), count, stride, new BufferUses(
            (target & Target.Structured) != 0,
            (target & Target.Raw) != 0,
            (target & Target.IndirectArguments) != 0));
    }

    ~GraphicsBuffer() => Elements?.Leak();

    [Flags]
    public enum Target
    {
        Vertex = 1,
        Index = 2,
        CopySource = 4,
        CopyDestination = 8,
        Structured = 16,
        Raw = 32,
        Append = 64,
        Counter = 128,
        IndirectArguments = 256,
        Constant = 512,
    }

    [Flags]
    public enum UsageFlags
    {
        None = 0,
        LockBufferForWrite = 1,
    }

    public int count => Elements.Count;

    public int stride => Elements.Stride;

    public Target target { get; }

    public UsageFlags usageFlags { get; }

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

    public void SetData(Array data, int managedBufferStartIndex, int graphicsBufferStartIndex, int count) =>
        Elements.Set(data, managedBufferStartIndex, graphicsBufferStartIndex, count);

    public void SetData<T>(List<T> data) where T : struct =>
        Elements.Set(data, 0, 0, data?.Count ?? 0);

    public void SetData<T>(List<T> data, int managedBufferStartIndex, int graphicsBufferStartIndex, int count)
        where T : struct =>
        Elements.Set(data, managedBufferStartIndex, graphicsBufferStartIndex, count);

    public void SetData<T>(NativeArray<T> data) where T : struct =>
        Elements.Set(data, 0, 0, data.Length);

    public void SetData<T>(NativeArray<T> data, int nativeBufferStartIndex, int graphicsBufferStartIndex, int count)
        where T : struct =>
        Elements.Set(data, nativeBufferStartIndex, graphicsBufferStartIndex, count);

    public void GetData(Array data) => Elements.Get(data);

    public void GetData(Array data, int managedBufferStartIndex, int computeBufferStartIndex, int count) =>
        Elements.Get(data, managedBufferStartIndex, computeBufferStartIndex, count);
}
