using System;
using System.Runtime.InteropServices;

namespace Glint.Vulkan;

/// <summary>Device memory that kernels read and write; zero when new.</summary>
public sealed unsafe class GpuBuffer : IDisposable
{
    /// <summary>Up to this size a second copy, into the staging buffer, costs less than a flush.</summary>
    const int SmallBytes = 64 << 10;

    Allocation _allocation;

    internal GpuBuffer(VulkanDevice device, long bytes, bool map)
    {
        Device = device;
        Bytes = bytes;
        _allocation = Allocation.ForKernels(device, bytes, map);
        if (_allocation.Mapped != null)
        {
            NativeMemory.Clear(_allocation.Mapped, (nuint)bytes);
        }
        else
        {
            device.Recorder.Fill(Handle);
            LastBatch = device.Recorder.Batch;
        }
    }

    public long Bytes { get; }

    /// <summary>True if the buffer or its device was disposed.</summary>
    public bool IsDisposed => _allocation == null;

    internal VulkanDevice Device { get; }
    internal ulong Handle => Live.Buffer;

    /// <summary>Batch of the last recorded command that uses this buffer.</summary>
    internal long LastBatch { get; set; }

    Allocation Live => _allocation
        ?? throw new ObjectDisposedException(nameof(GpuBuffer), $"this buffer of {Bytes:N0} bytes was disposed");

    /// <summary>Writes bytes, after earlier dispatches and before later ones.</summary>
    public void Write(ReadOnlySpan<byte> data, long offset = 0)
    {
        CheckRange(data.Length, offset);
        bool isInUse = LastBatch == Device.Recorder.Batch;
        if (Live.Mapped == null || isInUse && data.Length <= SmallBytes)
        {
            Device.Recorder.Upload(data, this, offset);
            return;
        }
        Device.FlushIfPending(LastBatch);
        data.CopyTo(new Span<byte>(_allocation.Mapped + offset, data.Length));
    }

    /// <summary>Copies bytes from the device, after all earlier dispatches have completed.</summary>
    public void Read(Span<byte> data, long offset = 0)
    {
        CheckRange(data.Length, offset);
        if (Live.Mapped == null)
        {
            Device.Recorder.Download(this, offset, data);
            return;
        }
        Device.FlushIfPending(LastBatch);
        new ReadOnlySpan<byte>(_allocation.Mapped + offset, data.Length).CopyTo(data);
    }

    public void Dispose()
    {
        if (_allocation == null)
            return;
        try
        {
            Device.FlushIfPending(LastBatch);
        }
        finally
        {
            Device.Forget(this);
            Destroy();
        }
    }

    internal void Destroy()
    {
        if (!Device.IsAbandoned)
            _allocation?.Dispose();
        _allocation = null;
    }

    void CheckRange(int bytes, long offset)
    {
        if (offset < 0 || bytes > Bytes - offset)
            throw new ArgumentOutOfRangeException(nameof(offset),
                $"bytes {offset:N0} to {offset + bytes:N0} lie outside this buffer of {Bytes:N0} bytes");
    }
}
