using System;

namespace Unity.Collections;

public partial struct NativeArray<T>
{
    public void CopyFrom(T[] array) => Copy(array, this);

    public void CopyFrom(NativeArray<T> array) => Copy(array, this);

    public void CopyTo(T[] array) => Copy(this, array);

    public void CopyTo(NativeArray<T> array) => Copy(this, array);

    public static void Copy(NativeArray<T> src, NativeArray<T> dst) => CopyAll(src.AsSpan(), dst.AsSpan());

    public static void Copy(ReadOnly src, NativeArray<T> dst) => CopyAll(src.AsReadOnlySpan(), dst.AsSpan());

    public static void Copy(T[] src, NativeArray<T> dst) => CopyAll(Whole(src), dst.AsSpan());

    public static void Copy(NativeArray<T> src, T[] dst) => CopyAll(src.AsSpan(), Whole(dst));

    public static void Copy(ReadOnly src, T[] dst) => CopyAll(src.AsReadOnlySpan(), Whole(dst));

    public static void Copy(NativeArray<T> src, NativeArray<T> dst, int length) => Copy(src, 0, dst, 0, length);

    public static void Copy(ReadOnly src, NativeArray<T> dst, int length) => Copy(src, 0, dst, 0, length);

    public static void Copy(T[] src, NativeArray<T> dst, int length) => Copy(src, 0, dst, 0, length);

    public static void Copy(NativeArray<T> src, T[] dst, int length) => Copy(src, 0, dst, 0, length);

    public static void Copy(ReadOnly src, T[] dst, int length) => Copy(src, 0, dst, 0, length);

    public static void Copy(NativeArray<T> src, int srcIndex, NativeArray<T> dst, int dstIndex, int length) =>
        CopyPart(src.AsSpan(), srcIndex, dst.AsSpan(), dstIndex, length);

    public static void Copy(ReadOnly src, int srcIndex, NativeArray<T> dst, int dstIndex, int length) =>
        CopyPart(src.AsReadOnlySpan(), srcIndex, dst.AsSpan(), dstIndex, length);

    public static void Copy(T[] src, int srcIndex, NativeArray<T> dst, int dstIndex, int length) =>
        CopyPart(Whole(src), srcIndex, dst.AsSpan(), dstIndex, length);

    public static void Copy(NativeArray<T> src, int srcIndex, T[] dst, int dstIndex, int length) =>
        CopyPart(src.AsSpan(), srcIndex, Whole(dst), dstIndex, length);

    public static void Copy(ReadOnly src, int srcIndex, T[] dst, int dstIndex, int length) =>
        CopyPart(src.AsReadOnlySpan(), srcIndex, Whole(dst), dstIndex, length);

    static Span<T> Whole(T[] array) => array ?? throw new ArgumentNullException(nameof(array));

    static void CopyAll(ReadOnlySpan<T> from, Span<T> to)
    {
        if (from.Length != to.Length)
            throw new ArgumentException("source and destination must have the same length; "
                + $"they have {from.Length} and {to.Length}");
        from.CopyTo(to);
    }

    static void CopyPart(ReadOnlySpan<T> from, int fromIndex, Span<T> to, int toIndex, int length)
    {
        if (length < 0)
            throw new ArgumentOutOfRangeException(nameof(length), length, "the length must be at least 0");
        CheckRange(from.Length, fromIndex, length, "source");
        CheckRange(to.Length, toIndex, length, "destination");
        from.Slice(fromIndex, length).CopyTo(to.Slice(toIndex, length));
    }

    static void CheckRange(int count, int index, int length, string which)
    {
        if (index < 0 || index > count)
            throw new ArgumentOutOfRangeException(nameof(index),
                $"{which} index {index} lies outside its {count} elements");
        if (length > count - index)
            throw new ArgumentException($"{length} elements from {index} on lie outside the {count} of the {which}");
    }
}
