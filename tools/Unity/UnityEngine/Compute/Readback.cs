using System;
using System.Runtime.CompilerServices;
using Glint.Vulkan;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Rendering;

namespace Glint.Host;

/// <summary>
/// One asynchronous read-back. The device copies the bytes between the dispatches before the request and those after
/// it. They are delivered in a later frame, as in Unity, and are valid for one frame.
/// </summary>
internal sealed class Readback
{
    readonly Action<AsyncGPUReadbackRequest> _callback;
    readonly Action<NativeArray<byte>> _store;
    readonly IReadbackSource _source;
    readonly long _batch;
    NativeArray<byte> _data;

    internal Readback(IReadbackSource source, long size, long offset, Action<NativeArray<byte>> store,
        Action<AsyncGPUReadbackRequest> callback)
    {
        if (offset < 0 || size <= 0 || size > source.Bytes - offset)
            throw new ArgumentException($"bytes {offset:N0} to {offset + size:N0} lie outside a buffer of "
                + $"{source.Bytes:N0} bytes");
        _source = source;
        _store = store;
        _callback = callback;
        _data = new NativeArray<byte>((int)Math.Min(size, Array.MaxLength), Allocator.Persistent,
            NativeArrayOptions.UninitializedMemory);
        _batch = source.BeginGet(_data, offset);
        Size = _data.Length;
    }

    internal int Size { get; }

    /// <summary>Frames begun since the request.</summary>
    internal int Age { get; set; }

    /// <summary>Whether completion does not wait for the device.</summary>
    internal bool IsReady => !_source.IsValid || _source.Device.HasRun(_batch);

    internal bool IsDone { get; private set; }
    internal bool HasError { get; private set; }

    internal void Complete()
    {
        if (IsDone)
            return;
        IsDone = true;
        HasError = !Fetch();
        try
        {
            _callback?.Invoke(new AsyncGPUReadbackRequest(this));
        }
        catch (Exception exception)
        {
            Debug.LogException(exception);
        }
    }

    /// <summary>Waits for the data and stores them. False if there are none, as when the buffer was released.</summary>
    bool Fetch()
    {
        if (!_source.IsValid)
            return false;
        try
        {
            _source.Device.Wait(_batch);
            _store?.Invoke(_data);
            return true;
        }
        catch (VulkanException exception)
        {
            Debug.LogError($"AsyncGPUReadback: {exception.Message}");
        }
        catch (ObjectDisposedException)
        {
            Debug.LogError("AsyncGPUReadback: the NativeArray that was to take the data was disposed before it came");
        }
        return false;
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
