using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using Glint.Host;
using Unity.Collections;

namespace UnityEngine.Rendering;

public static class AsyncGPUReadback
{
    /// <summary>Frames after which one waits for the device, like Unity's QualitySettings.maxQueuedFrames.</summary>
    const int MaxAge = 2;

    static readonly List<Readback> _pending = new();
    static readonly List<Readback> _completed = new();

    static AsyncGPUReadback() => Engine.FrameBegins += Pump;

    public static AsyncGPUReadbackRequest Request(ComputeBuffer src, Action<AsyncGPUReadbackRequest> callback = null) =>
        Add(Elements(src), Elements(src).Bytes, 0, null, callback);

    public static AsyncGPUReadbackRequest Request(ComputeBuffer src, int size, int offset,
        Action<AsyncGPUReadbackRequest> callback = null) =>
        Add(Elements(src), size, offset, null, callback);

    public static AsyncGPUReadbackRequest Request(GraphicsBuffer src,
        Action<AsyncGPUReadbackRequest> callback = null) =>
        Add(Elements(src), Elements(src).Bytes, 0, null, callback);

    public static AsyncGPUReadbackRequest Request(GraphicsBuffer src, int size, int offset,
        Action<AsyncGPUReadbackRequest> callback = null) =>
        Add(Elements(src), size, offset, null, callback);

    /// <summary>The pixels row by row, from that whose y is 0 in the kernel.</summary>
    public static AsyncGPUReadbackRequest Request(Texture src, int mipIndex = 0,
        Action<AsyncGPUReadbackRequest> callback = null)
    {
        if (src is not RenderTexture texture)
            throw new NotSupportedException("the host reads back a RenderTexture only");
        if (mipIndex != 0)
            throw new ArgumentOutOfRangeException(nameof(mipIndex), mipIndex, "the texture has one level");
        return Add(texture, texture.Image.Bytes, 0, null, callback);
    }

    public static AsyncGPUReadbackRequest RequestIntoNativeArray<T>(
        ref NativeArray<T> output, ComputeBuffer src,
        Action<AsyncGPUReadbackRequest> callback = null) where T : struct =>
        Add(Elements(src), Elements(src).Bytes, 0, Into(output, Elements(src).Bytes), callback);

    public static AsyncGPUReadbackRequest RequestIntoNativeArray<T>(
        ref NativeArray<T> output, ComputeBuffer src, int size, int offset,
        Action<AsyncGPUReadbackRequest> callback = null) where T : struct =>
        Add(Elements(src), size, offset, Into(output, size), callback);

    public static AsyncGPUReadbackRequest RequestIntoNativeArray<T>(
        ref NativeArray<T> output, GraphicsBuffer src,
        Action<AsyncGPUReadbackRequest> callback = null) where T : struct =>
        Add(Elements(src), Elements(src).Bytes, 0, Into(output, Elements(src).Bytes), callback);

    public static AsyncGPUReadbackRequest RequestIntoNativeArray<T>(
        ref NativeArray<T> output, GraphicsBuffer src, int size, int offset,
        Action<AsyncGPUReadbackRequest> callback = null) where T : struct =>
        Add(Elements(src), size, offset, Into(output, size), callback);

    public static void WaitAllRequests()
    {
        while (_pending.Count > 0)
            Complete(_pending[0]);
    }

    /// <summary>
    /// Once a frame: releases the data of completed requests and completes those whose data have come. Waits for those
    /// of <see cref="MaxAge"/> frames.
    /// </summary>
    internal static void Pump()
    {
        GraphicsDevice.CollectLeaks();
        foreach (var readback in _completed)
            readback.Expire();
        _completed.Clear();
        foreach (var readback in _pending.ToArray())
            if (++readback.Age >= MaxAge || readback.IsReady)
                Complete(readback);
    }

    /// <summary>Delivers the data if they have come.</summary>
    internal static void Update(Readback readback)
    {
        if (readback is { IsDone: false, IsReady: true })
            Complete(readback);
    }

    /// <summary>Delivers the data now, unless already done.</summary>
    internal static void Complete(Readback readback)
    {
        if (readback == null || !_pending.Remove(readback))
            return;
        _completed.Add(readback);
        readback.Complete();
    }

    static AsyncGPUReadbackRequest Add(
        IReadbackSource source, long size, long offset,
        Action<NativeArray<byte>> store, Action<AsyncGPUReadbackRequest> callback)
    {
        if (!SystemInfo.supportsAsyncGPUReadback)
            throw new NotSupportedException("this device has no asynchronous read-back "
                + "(SystemInfo.supportsAsyncGPUReadback); use GetData");
        var readback = new Readback(source, size, offset, store, callback);
        _pending.Add(readback);
        return new AsyncGPUReadbackRequest(readback);
    }

    static StructuredBuffer Elements(ComputeBuffer source) =>
        (source ?? throw new ArgumentNullException(nameof(source))).Elements;

    static StructuredBuffer Elements(GraphicsBuffer source) =>
        (source ?? throw new ArgumentNullException(nameof(source))).Elements;

    static Action<NativeArray<byte>> Into<T>(NativeArray<T> output, long size) where T : struct
    {
        if ((long)output.Length * Unsafe.SizeOf<T>() < size)
            throw new ArgumentException($"{output.Length} elements of {typeof(T)} are too few for {size:N0} bytes",
                nameof(output));
        return data => data.AsSpan().CopyTo(output.Reinterpret<byte>(Unsafe.SizeOf<T>()).AsSpan());
    }
}
