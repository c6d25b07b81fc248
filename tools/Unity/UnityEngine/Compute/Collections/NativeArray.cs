using System;
using System.Collections;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using Glint.Host;

namespace Unity.Collections;

public partial struct NativeArray<T> : IDisposable, IEnumerable<T>, IEquatable<NativeArray<T>>
    where T : struct
{
    NativeBlock _block;
    int _start; // bytes from the block's first
    int _length;
    Allocator _allocator; // Invalid: a view, which does not free

    public NativeArray(int length, Allocator allocator, NativeArrayOptions options = NativeArrayOptions.ClearMemory)
    {
        if (allocator <= Allocator.None)
            throw new ArgumentException("a NativeArray needs Allocator.Temp, TempJob or Persistent", nameof(allocator));
        if (length < 0)
            throw new ArgumentOutOfRangeException(nameof(length), length,
                "the length of a NativeArray must be at least 0");
        if (RuntimeHelpers.IsReferenceOrContainsReferences<T>())
            throw new InvalidOperationException($"{typeof(T)} holds references to managed objects and cannot be the "
                + "element of a NativeArray");
        _block = new NativeBlock((long)length * Unsafe.SizeOf<T>(), options == NativeArrayOptions.ClearMemory);
        _start = 0;
        _length = length;
        _allocator = allocator;
    }

    public NativeArray(T[] array, Allocator allocator)
        : this((array ?? throw new ArgumentNullException(nameof(array))).Length, allocator,
            NativeArrayOptions.UninitializedMemory) => CopyFrom(array);

    public NativeArray(NativeArray<T> array, Allocator allocator)
        : this(array.Length, allocator, NativeArrayOptions.UninitializedMemory) => CopyFrom(array);

    NativeArray(NativeBlock block, int start, int length) =>
        (_block, _start, _length, _allocator) = (block, start, length, Allocator.Invalid);

    public int Length => _length;

    public bool IsCreated => _block != null;

    public T this[int index]
    {
        get => At(index);
        set => At(index) = value;
    }

    public static implicit operator Span<T>(in NativeArray<T> source) => source.AsSpan();

    public static implicit operator ReadOnlySpan<T>(in NativeArray<T> source) => source.AsReadOnlySpan();

    public static bool operator ==(NativeArray<T> left, NativeArray<T> right) => left.Equals(right);

    public static bool operator !=(NativeArray<T> left, NativeArray<T> right) => !left.Equals(right);

    public readonly unsafe Span<T> AsSpan()
    {
        if (_block == null)
            return default;
        return new Span<T>(_block.Data + _start, _length);
    }

    public readonly ReadOnlySpan<T> AsReadOnlySpan() => AsSpan();

    public T[] ToArray() => AsSpan().ToArray();

    public ReadOnly AsReadOnly() => new(this);

    /// <summary>A view of the same memory.</summary>
    public NativeArray<T> GetSubArray(int start, int length)
    {
        if (start < 0 || length < 0 || start > _length - length)
            throw new ArgumentOutOfRangeException(nameof(start),
                $"elements {start} to {start + (long)length} lie outside a NativeArray of {_length}");
        _ = AsSpan(); // freed?
        return new NativeArray<T>(_block, _start + start * Unsafe.SizeOf<T>(), length);
    }

    /// <summary>A view of the same memory as elements of another type with the same size.</summary>
    public NativeArray<U> Reinterpret<U>()
        where U : struct
    {
        if (Unsafe.SizeOf<T>() != Unsafe.SizeOf<U>())
            throw new InvalidOperationException($"{typeof(T)} has {Unsafe.SizeOf<T>()} bytes and {typeof(U)} "
                + $"{Unsafe.SizeOf<U>()}; use Reinterpret({Unsafe.SizeOf<T>()})");
        return View<U>();
    }

    /// <summary>A view of the same memory as elements of another type and size.</summary>
    public NativeArray<U> Reinterpret<U>(int expectedTypeSize)
        where U : struct
    {
        if (expectedTypeSize != Unsafe.SizeOf<T>())
            throw new InvalidOperationException($"{typeof(T)} has {Unsafe.SizeOf<T>()} bytes, "
                + $"not the expected {expectedTypeSize}");
        if ((long)_length * Unsafe.SizeOf<T>() % Unsafe.SizeOf<U>() != 0)
            throw new InvalidOperationException($"{_length} elements of {typeof(T)} make no whole "
                + $"number of {typeof(U)}");
        return View<U>();
    }

    public void Dispose()
    {
        if (_block == null)
            return;
        _ = AsSpan(); // freed through another copy?
        if (_allocator == Allocator.Invalid)
            throw new InvalidOperationException("this NativeArray is a view of another and cannot be disposed");
        _block.Free();
        this = default;
    }

    public bool Equals(NativeArray<T> other) =>
        _block == other._block && _start == other._start && _length == other._length;

    public override bool Equals(object obj) => obj is NativeArray<T> other && Equals(other);

    public override int GetHashCode() => HashCode.Combine(_block, _start, _length);

    public Enumerator GetEnumerator() => new(ref this);

    IEnumerator<T> IEnumerable<T>.GetEnumerator() => GetEnumerator();

    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

    NativeArray<U> View<U>()
        where U : struct
    {
        _ = AsSpan(); // freed?
        return new NativeArray<U>(_block, _start, (int)((long)_length * Unsafe.SizeOf<T>() / Unsafe.SizeOf<U>()));
    }

    readonly ref T At(int index)
    {
        if ((uint)index >= (uint)_length)
            throw new IndexOutOfRangeException($"Index {index} is out of range of '{_length}' Length.");
        return ref AsSpan()[index];
    }

    public struct Enumerator : IEnumerator<T>
    {
        NativeArray<T> _array;
        int _index;

        public Enumerator(ref NativeArray<T> array) => (_array, _index) = (array, -1);

        public T Current => _array[_index];

        object IEnumerator.Current => Current;

        public bool MoveNext() => ++_index < _array._length;

        public void Reset() => _index = -1;

        public void Dispose()
        {
        }
    }
}
