using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Glint.Vulkan;
using Unity.Collections;

namespace Glint.Host;

/// <summary>
/// Base of ComputeBuffer and GraphicsBuffer: elements on the device, and Unity's checks of transfers.
/// </summary>
internal sealed class StructuredBuffer : IReadbackSource
{
    const int StrideLimit = 2048;
    const int MostBytesAtOnce = 1 << 30; // a span counts its bytes by an int

    static readonly ConcurrentDictionary<Type, (int Size, bool HasReferences)> _elements = new();

    readonly string _kind;
    readonly VulkanDevice _device;
    GpuBuffer _buffer;

    internal StructuredBuffer(string kind, int count, int stride, BufferUses uses)
    {
        if (uses.Structured && uses.Arguments)
            throw new ArgumentException($"a {kind} cannot be both Structured and IndirectArguments: Direct3D 11 "
                + "has no such buffer; use IndirectArguments | Raw and a RWByteAddressBuffer in the kernel");
        if (count <= 0)
            throw new ArgumentException($"a {kind} needs at least one element, not {count}", nameof(count));
        if (stride <= 0 || stride % 4 != 0 || stride >= StrideLimit)
            throw new ArgumentException($"the stride of a {kind} must be a multiple of 4 from 4 to {StrideLimit - 4} "
                + $"bytes, not {stride}", nameof(stride));
        GraphicsDevice.CollectLeaks();
        _device = GraphicsDevice.Current;
        long bytes = (long)count * stride, most = _device.Limits.MaxStorageBufferRange;
        if (bytes > most)
            throw new ArgumentException($"a {kind} of {count:N0} elements of {stride} bytes takes {bytes:N0} bytes, "
                + $"{_device.Info.Name} at most {most:N0} (SystemInfo.maxGraphicsBufferSize)", nameof(count));

        _kind = kind;
        Count = count;
        Stride = stride;
        Uses = uses;
        _buffer = _device.CreateBuffer(bytes);
    }

    internal int Count { get; }
    internal int Stride { get; }
    public long Bytes => (long)Count * Stride;

    internal BufferUses Uses { get; }

    public VulkanDevice Device => _device;

    public bool IsValid => _buffer is { IsDisposed: false };

    /// <summary>The buffer on the device; throws if it was released.</summary>
    internal GpuBuffer Gpu => IsValid ? _buffer : throw new NullReferenceException($"this {_kind} was released");

    internal void Release()
    {
        _buffer?.Dispose();
        _buffer = null;
    }

    /// <summary>From a finalizer: leaves the device's part to the main thread.</summary>
    internal void Leak()
    {
        if (IsValid)
            GraphicsDevice.Leak(_kind, _buffer);
    }

    internal void Set(Array data) => Set(data, 0, 0, NotNull(data).Length);

    internal void Set(Array data, int dataStart, int bufferStart, int count)
    {
        int size = ElementSize(data);
        CheckPart(data.Length, dataStart, count);
        CheckRange((long)count * size, bufferStart, size);
        Write(ref MemoryMarshal.GetArrayDataReference(data), (long)dataStart * size,
            (long)bufferStart * size, (long)count * size);
    }

    internal void Set<T>(List<T> data, int dataStart, int bufferStart, int count) where T : struct
    {
        CheckElement(typeof(T), RuntimeHelpers.IsReferenceOrContainsReferences<T>());
        Set(CollectionsMarshal.AsSpan(NotNull(data)), dataStart, bufferStart, count);
    }

    internal void Set<T>(NativeArray<T> data, int dataStart, int bufferStart, int count) where T : struct =>
        Set(data.AsSpan(), dataStart, bufferStart, count);

    internal void Get(Array data) => Get(data, 0, 0, NotNull(data).Length);

    internal void Get(Array data, int dataStart, int bufferStart, int count)
    {
        int size = ElementSize(data);
        CheckPart(data.Length, dataStart, count);
        CheckRange((long)count * size, bufferStart, size);
        ref byte first = ref MemoryMarshal.GetArrayDataReference(data);
        long end = (long)count * size;
        for (long at = 0; at < end; at += MostBytesAtOnce)
            Gpu.Read(Slice(ref first, (long)dataStart * size + at, end - at), (long)bufferStart * size + at);
    }

    /// <summary>Has the device copy bytes as they are now: see <see cref="GpuBuffer.BeginRead"/>.</summary>
    public unsafe long BeginGet(NativeArray<byte> data, long offset)
    {
        fixed (byte* target = data.AsSpan())
            return Gpu.BeginRead(target, data.Length, offset);
    }

    void Set<T>(Span<T> data, int dataStart, int bufferStart, int count) where T : struct
    {
        int size = Unsafe.SizeOf<T>();
        CheckPart(data.Length, dataStart, count);
        CheckRange((long)count * size, bufferStart, size);
        Write(ref Unsafe.As<T, byte>(ref MemoryMarshal.GetReference(data)), (long)dataStart * size,
            (long)bufferStart * size, (long)count * size);
    }

    void Write(ref byte first, long start, long bufferOffset, long end)
    {
        for (long at = 0; at < end; at += MostBytesAtOnce)
            Gpu.Write(Slice(ref first, start + at, end - at), bufferOffset + at);
    }

    static Span<byte> Slice(ref byte first, long start, long left) =>
        MemoryMarshal.CreateSpan(ref Unsafe.AddByteOffset(ref first, (nint)start),
            (int)Math.Min(left, MostBytesAtOnce));

    static T NotNull<T>(T data) where T : class => data ?? throw new ArgumentNullException(nameof(data));

    static void CheckPart(int length, int start, int count)
    {
        if (start < 0 || count < 0 || start > length - count)
            throw new ArgumentOutOfRangeException(nameof(start),
                $"elements {start} to {(long)start + count} lie outside an array of {length}");
    }

    void CheckRange(long bytes, int start, int size)
    {
        _ = Gpu;
        if (start < 0 || bytes > Bytes - (long)start * size)
            throw new ArgumentException($"bytes {(long)start * size:N0} to {(long)start * size + bytes:N0} lie outside "
                + $"this {_kind} of {Bytes:N0} bytes");
    }

    // Cached for each type, since the runtime's answer takes longer than a small upload.
    int ElementSize(Array data)
    {
        var element = NotNull(data).GetType().GetElementType();
        var (size, hasReferences) = _elements.GetOrAdd(element, Describe);
        CheckElement(element, hasReferences);
        return size;
    }

    void CheckElement(Type element, bool hasReferences)
    {
        if (hasReferences)
            throw new ArgumentException($"{element} holds references to managed objects; "
                + $"a {_kind} takes plain data only");
    }

    static (int Size, bool HasReferences) Describe(Type element) => element.IsValueType && !HasReferences(element)
        ? (RuntimeHelpers.SizeOf(element.TypeHandle), false)
        : (0, true);

    static bool HasReferences(Type element) => (bool)typeof(RuntimeHelpers)
        .GetMethod(nameof(RuntimeHelpers.IsReferenceOrContainsReferences))
        .MakeGenericMethod(element).Invoke(null, null);
}
