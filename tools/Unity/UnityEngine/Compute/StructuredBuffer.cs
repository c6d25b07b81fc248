using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Glint.Vulkan;
using Unity.Collections;

namespace Glint.Host;

/// <summary>What ComputeBuffer and GraphicsBuffer share: elements on the device, and Unity's checks of what goes in and out.</summary>
internal sealed class StructuredBuffer
{
    const int StrideLimit = 2048;

    readonly string _kind;
    readonly VulkanDevice _device;
    GpuBuffer _buffer;

    internal StructuredBuffer(string kind, int count, int stride, bool isRaw)
    {
        if (count <= 0)
            throw new ArgumentException($"a {kind} needs at least one element, not {count}", nameof(count));
        if (stride <= 0 || stride % 4 != 0 || stride >= StrideLimit)
            throw new ArgumentException($"the stride of a {kind} must be a multiple of 4 from 4 to {StrideLimit - 4} bytes, not {stride}", nameof(stride));
        GraphicsDevice.CollectLeaks();
        _device = GraphicsDevice.Current;
        long bytes = (long)count * stride, most = _device.Limits.MaxStorageBufferRange;
        if (bytes > most)
            throw new ArgumentException($"a {kind} of {count:N0} elements of {stride} bytes takes {bytes:N0} bytes, {_device.Info.Name} at most {most:N0} (SystemInfo.maxGraphicsBufferSize)", nameof(count));

        _kind = kind;
        Count = count;
        Stride = stride;
        IsRaw = isRaw;
        _buffer = _device.CreateBuffer(bytes);
    }

    internal int Count { get; }
    internal int Stride { get; }
    internal long Bytes => (long)Count * Stride;

    /// <summary>May be bound to a ByteAddressBuffer.</summary>
    internal bool IsRaw { get; }

    internal bool IsValid => _buffer is { IsDisposed: false };

    /// <summary>The buffer on the device; throws when it was released.</summary>
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

    internal void Set(Array data, int dataStart, int bufferStart, int count) =>
        WithBytes(data, (bytes, size) => Write(Part(bytes, data.Length, size, dataStart, count), bufferStart, size));

    internal void Set<T>(List<T> data, int dataStart, int bufferStart, int count) where T : struct
    {
        CheckElement(typeof(T), RuntimeHelpers.IsReferenceOrContainsReferences<T>());
        var bytes = AsBytes<T>(CollectionsMarshal.AsSpan(NotNull(data)));
        Write(Part(bytes, data.Count, Unsafe.SizeOf<T>(), dataStart, count), bufferStart, Unsafe.SizeOf<T>());
    }

    internal void Set<T>(NativeArray<T> data, int dataStart, int bufferStart, int count) where T : struct =>
        Write(Part(AsBytes<T>(data.AsSpan()), data.Length, Unsafe.SizeOf<T>(), dataStart, count), bufferStart, Unsafe.SizeOf<T>());

    internal void Get(Array data) => Get(data, 0, 0, NotNull(data).Length);

    internal void Get(Array data, int dataStart, int bufferStart, int count) =>
        WithBytes(data, (bytes, size) =>
        {
            var part = Part(bytes, data.Length, size, dataStart, count);
            CheckRange(part.Length, bufferStart, size);
            Gpu.Read(part, (long)bufferStart * size);
        });

    static T NotNull<T>(T data) where T : class => data ?? throw new ArgumentNullException(nameof(data));

    static Span<byte> AsBytes<T>(Span<T> data) where T : struct =>
        MemoryMarshal.CreateSpan(ref Unsafe.As<T, byte>(ref MemoryMarshal.GetReference(data)), checked(data.Length * Unsafe.SizeOf<T>()));

    static Span<byte> Part(Span<byte> bytes, int length, int size, int start, int count)
    {
        if (start < 0 || count < 0 || start > length - count)
            throw new ArgumentOutOfRangeException(nameof(start), $"elements {start} to {(long)start + count} lie outside an array of {length}");
        return bytes.Slice(start * size, count * size);
    }

    void Write(ReadOnlySpan<byte> data, int bufferStart, int size)
    {
        CheckRange(data.Length, bufferStart, size);
        Gpu.Write(data, (long)bufferStart * size);
    }

    void CheckRange(int bytes, int start, int size)
    {
        _ = Gpu;
        if (start < 0 || bytes > Bytes - (long)start * size)
            throw new ArgumentException($"bytes {(long)start * size:N0} to {(long)start * size + bytes:N0} lie outside this {_kind} of {Bytes:N0} bytes");
    }

    delegate void ByteAction(Span<byte> bytes, int elementSize);

    void WithBytes(Array data, ByteAction action)
    {
        var element = NotNull(data).GetType().GetElementType();
        CheckElement(element, !element.IsValueType || ContainsReferences(element));
        int size = RuntimeHelpers.SizeOf(element.TypeHandle);
        action(MemoryMarshal.CreateSpan(ref MemoryMarshal.GetArrayDataReference(data), checked(data.Length * size)), size);
    }

    void CheckElement(Type element, bool hasReferences)
    {
        if (hasReferences)
            throw new ArgumentException($"{element} holds references to managed objects; a {_kind} takes plain data only");
    }

    static bool ContainsReferences(Type element) => (bool)typeof(RuntimeHelpers)
        .GetMethod(nameof(RuntimeHelpers.IsReferenceOrContainsReferences)).MakeGenericMethod(element).Invoke(null, null);
}
