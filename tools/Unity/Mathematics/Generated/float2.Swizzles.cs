// Written by generate.py.
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

public partial struct float2
{
    public float2 xx { [MethodImpl(AggressiveInlining)] get => new(x, x); }
    public float2 xy { [MethodImpl(AggressiveInlining)] get => new(x, y); [MethodImpl(AggressiveInlining)] set { x = value.x; y = value.y; } }
    public float2 yx { [MethodImpl(AggressiveInlining)] get => new(y, x); [MethodImpl(AggressiveInlining)] set { y = value.x; x = value.y; } }
    public float2 yy { [MethodImpl(AggressiveInlining)] get => new(y, y); }
    public float3 xxx { [MethodImpl(AggressiveInlining)] get => new(x, x, x); }
    public float3 xxy { [MethodImpl(AggressiveInlining)] get => new(x, x, y); }
    public float3 xyx { [MethodImpl(AggressiveInlining)] get => new(x, y, x); }
    public float3 xyy { [MethodImpl(AggressiveInlining)] get => new(x, y, y); }
    public float3 yxx { [MethodImpl(AggressiveInlining)] get => new(y, x, x); }
    public float3 yxy { [MethodImpl(AggressiveInlining)] get => new(y, x, y); }
    public float3 yyx { [MethodImpl(AggressiveInlining)] get => new(y, y, x); }
    public float3 yyy { [MethodImpl(AggressiveInlining)] get => new(y, y, y); }
}
