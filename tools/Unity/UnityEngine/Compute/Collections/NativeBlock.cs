using System;
using System.Runtime.InteropServices;

namespace Glint.Host;

/// <summary>
/// Unmanaged memory that all copies and views of a NativeArray share, so that each sees when it is freed.
/// </summary>
internal sealed unsafe class NativeBlock
{
    const int Alignment = 16;

    readonly byte* _data;

    internal NativeBlock(long bytes, bool clear)
    {
        _data = (byte*)NativeMemory.AlignedAlloc((nuint)Math.Max(1, bytes), Alignment);
        if (clear)
            NativeMemory.Clear(_data, (nuint)bytes);
    }

    ~NativeBlock() => Release();

    internal bool IsFreed { get; private set; }

    internal byte* Data => !IsFreed ? _data : throw new ObjectDisposedException("NativeArray",
        "this NativeArray was disposed, through this or another copy of it");

    internal void Free()
    {
        Release();
        GC.SuppressFinalize(this);
    }

    void Release()
    {
        if (!IsFreed)
            NativeMemory.AlignedFree(_data);
        IsFreed = true;
    }
}
