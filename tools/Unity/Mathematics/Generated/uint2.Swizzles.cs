// Written by generate.py.
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

public partial struct uint2
{
    public uint2 xx { [MethodImpl(AggressiveInlining)] get => new(x, x); }
    public uint2 xy { [MethodImpl(AggressiveInlining)] get => new(x, y); [MethodImpl(AggressiveInlining)] set { x = value.x; y = value.y; } }
    public uint2 yx { [MethodImpl(AggressiveInlining)] get => new(y, x); [MethodImpl(AggressiveInlining)] set { y = value.x; x = value.y; } }
    public uint2 yy { [MethodImpl(AggressiveInlining)] get => new(y, y); }
    public uint3 xxx { [MethodImpl(AggressiveInlining)] get => new(x, x, x); }
    public uint3 xxy { [MethodImpl(AggressiveInlining)] get => new(x, x, y); }
    public uint3 xyx { [MethodImpl(AggressiveInlining)] get => new(x, y, x); }
    public uint3 xyy { [MethodImpl(AggressiveInlining)] get => new(x, y, y); }
    public uint3 yxx { [MethodImpl(AggressiveInlining)] get => new(y, x, x); }
    public uint3 yxy { [MethodImpl(AggressiveInlining)] get => new(y, x, y); }
    public uint3 yyx { [MethodImpl(AggressiveInlining)] get => new(y, y, x); }
    public uint3 yyy { [MethodImpl(AggressiveInlining)] get => new(y, y, y); }
}
