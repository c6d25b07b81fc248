using System;
using System.Runtime.InteropServices;

namespace Glint.Vulkan;

/// <summary>Device memory that kernels read and write; zero when new.</summary>
public sealed unsafe class GpuBuffer : GpuResource
{
    /// <summary>Up to this size a second copy, through the staging buffer, costs less than a wait.</summary>
    const int SmallBytes = 1 << 20;

    Allocation _allocation;

    internal GpuBuffer(VulkanDevice device, long bytes, bool map) : base(device)
    {
        Bytes = bytes;
        _allocation = Allocation.ForKernels(device, bytes, map);
        if (_allocation.IsZero)
            return;
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

    public override bool IsDisposed => _allocation == null;

    internal ulong Handle => Live.Buffer;

    Allocation Live => _allocation
        ?? throw new ObjectDisposedException(nameof(GpuBuffer), $"this buffer of {Bytes:N0} bytes was disposed");

    /// <summary>Writes bytes, after earlier dispatches and before later ones.</summary>
    public void Write(ReadOnlySpan<byte> data, long offset = 0)
    {
        CheckRange(data.Length, offset);
        if (Live.Mapped == null || data.Length <= SmallBytes && !Device.Recorder.HasRun(LastBatch))
        {
            Device.Recorder.Upload(data, this, offset);
            return;
        }
        Device.Recorder.Finish(LastBatch);
        data.CopyTo(new Span<byte>(_allocation.Mapped + offset, data.Length));
    }

    /// <summary>Copies bytes from the device, after all earlier dispatches have completed.</summary>
    public void Read(Span<byte> data, long offset = 0)
    {
        CheckRange(data.Length, offset);
        if (Live.Mapped == null)
        {
            fixed (byte* target = data)
                Device.Recorder.Finish(Device.Recorder.Download(this, offset, target, data.Length));
            return;
        }
        Device.Recorder.Finish(LastBatch);
        new ReadOnlySpan<byte>(_allocation.Mapped + offset, data.Length).CopyTo(data);
    }

    /// <summary>
    /// Has the device copy bytes as they are after all earlier dispatches, and returns at once. They are at
    /// <paramref name="target"/> once <see cref="VulkanDevice.HasRun"/> or <see cref="VulkanDevice.Wait(long)"/> has
    /// said so of the batch whose number is returned. The memory must last until then, or until the device is closed.
    /// </summary>
    public long BeginRead(byte* target, long bytes, long offset = 0)
    {
        CheckRange(bytes, offset);
        return Device.Recorder.Download(this, offset, target, bytes);
    }

    internal override void Destroy()
    {
        if (!Device.IsAbandoned)
            _allocation?.Dispose();
        _allocation = null;
    }

    void CheckRange(long bytes, long offset)
    {
        if (offset < 0 || bytes > Bytes - offset)
            throw new ArgumentOutOfRangeException(nameof(offset),
                $"bytes {offset:N0} to {offset + bytes:N0} lie outside this buffer of {Bytes:N0} bytes");
    }
}
