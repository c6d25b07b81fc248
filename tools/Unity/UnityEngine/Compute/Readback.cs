using System;
using System.Runtime.CompilerServices;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Rendering;

namespace Glint.Host;

/// <summary>
/// One asynchronous read-back. The bytes are copied immediately, so later dispatches do not change them. They are
/// delivered in a later frame, as in Unity, and are valid for one frame.
/// </summary>
internal sealed class Readback
{
    readonly Action<AsyncGPUReadbackRequest> _callback;
    readonly Action<NativeArray<byte>> _store;
    NativeArray<byte> _data;

    internal Readback(StructuredBuffer source, long size, long offset, Action<NativeArray<byte>> store,
        Action<AsyncGPUReadbackRequest> callback)
    {
        if (offset < 0 || size <= 0 || size > source.Bytes - offset)
            throw new ArgumentException($"bytes {offset:N0} to {offset + size:N0} lie outside a buffer of "
                + $"{source.Bytes:N0} bytes");
        _store = store;
        _callback = callback;
        _data = new NativeArray<byte>((int)Math.Min(size, Array.MaxLength), Allocator.Persistent,
            NativeArrayOptions.UninitializedMemory);
        source.Gpu.Read(_data.AsSpan(), offset);
        Size = _data.Length;
    }

    internal int Size { get; }
    internal bool IsDone { get; private set; }
    internal bool HasError { get; private set; }

    internal void Complete()
    {
        if (IsDone)
            return;
        IsDone = true;
        try
        {
            _store?.Invoke(_data);
        }
        catch (ObjectDisposedException)
        {
            HasError = true;
            Debug.LogError("AsyncGPUReadback: the NativeArray that was to take the data was disposed before it came");
        }
        try
        {
            _callback?.Invoke(new AsyncGPUReadbackRequest(this));
        }
        catch (Exception exception)
        {
            Debug.LogException(exception);
        }
    }

    /// <summary>Ends the frame in which the data are valid.</summary>
    internal void Expire()
    {
        HasError = true;
        _data.Dispose();
    }

    internal NativeArray<T> Data<T>() where T : struct
    {
        if (!IsDone || HasError)
            throw new InvalidOperationException("the data of this read-back is not there: "
                + "it is from the frame in which the request is done to the next, if it has no error");
        int count = Size / Unsafe.SizeOf<T>();
        return _data.GetSubArray(0, count * Unsafe.SizeOf<T>()).Reinterpret<T>(1);
    }
}
