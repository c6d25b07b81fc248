// Written by generate.py.
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

public partial struct float3
{
    public float2 xx { [MethodImpl(AggressiveInlining)] get => new(x, x); }
    public float2 xy { [MethodImpl(AggressiveInlining)] get => new(x, y); [MethodImpl(AggressiveInlining)] set { x = value.x; y = value.y; } }
    public float2 xz { [MethodImpl(AggressiveInlining)] get => new(x, z); [MethodImpl(AggressiveInlining)] set { x = value.x; z = value.y; } }
    public float2 yx { [MethodImpl(AggressiveInlining)] get => new(y, x); [MethodImpl(AggressiveInlining)] set { y = value.x; x = value.y; } }
    public float2 yy { [MethodImpl(AggressiveInlining)] get => new(y, y); }
    public float2 yz { [MethodImpl(AggressiveInlining)] get => new(y, z); [MethodImpl(AggressiveInlining)] set { y = value.x; z = value.y; } }
    public float2 zx { [MethodImpl(AggressiveInlining)] get => new(z, x); [MethodImpl(AggressiveInlining)] set { z = value.x; x = value.y; } }
    public float2 zy { [MethodImpl(AggressiveInlining)] get => new(z, y); [MethodImpl(AggressiveInlining)] set { z = value.x; y = value.y; } }
    public float2 zz { [MethodImpl(AggressiveInlining)] get => new(z, z); }
    public float3 xxx { [MethodImpl(AggressiveInlining)] get => new(x, x, x); }
    public float3 xxy { [MethodImpl(AggressiveInlining)] get => new(x, x, y); }
    public float3 xxz { [MethodImpl(AggressiveInlining)] get => new(x, x, z); }
    public float3 xyx { [MethodImpl(AggressiveInlining)] get => new(x, y, x); }
    public float3 xyy { [MethodImpl(AggressiveInlining)] get => new(x, y, y); }
    public float3 xyz { [MethodImpl(AggressiveInlining)] get => new(x, y, z); [MethodImpl(AggressiveInlining)] set { x = value.x; y = value.y; z = value.z; } }
    public float3 xzx { [MethodImpl(AggressiveInlining)] get => new(x, z, x); }
    public float3 xzy { [MethodImpl(AggressiveInlining)] get => new(x, z, y); [MethodImpl(AggressiveInlining)] set { x = value.x; z = value.y; y = value.z; } }
    public float3 xzz { [MethodImpl(AggressiveInlining)] get => new(x, z, z); }
    public float3 yxx { [MethodImpl(AggressiveInlining)] get => new(y, x, x); }
    public float3 yxy { [MethodImpl(AggressiveInlining)] get => new(y, x, y); }
    public float3 yxz { [MethodImpl(AggressiveInlining)] get => new(y, x, z); [MethodImpl(AggressiveInlining)] set { y = value.x; x = value.y; z = value.z; } }
    public float3 yyx { [MethodImpl(AggressiveInlining)] get => new(y, y, x); }
    public float3 yyy { [MethodImpl(AggressiveInlining)] get => new(y, y, y); }
    public float3 yyz { [MethodImpl(AggressiveInlining)] get => new(y, y, z); }
    public float3 yzx { [MethodImpl(AggressiveInlining)] get => new(y, z, x); [MethodImpl(AggressiveInlining)] set { y = value.x; z = value.y; x = value.z; } }
    public float3 yzy { [MethodImpl(AggressiveInlining)] get => new(y, z, y); }
    public float3 yzz { [MethodImpl(AggressiveInlining)] get => new(y, z, z); }
    public float3 zxx { [MethodImpl(AggressiveInlining)] get => new(z, x, x); }
    public float3 zxy { [MethodImpl(AggressiveInlining)] get => new(z, x, y); [MethodImpl(AggressiveInlining)] set { z = value.x; x = value.y; y = value.z; } }
    public float3 zxz { [MethodImpl(AggressiveInlining)] get => new(z, x, z); }
    public float3 zyx { [MethodImpl(AggressiveInlining)] get => new(z, y, x); [MethodImpl(AggressiveInlining)] set { z = value.x; y = value.y; x = value.z; } }
    public float3 zyy { [MethodImpl(AggressiveInlining)] get => new(z, y, y); }
    public float3 zyz { [MethodImpl(AggressiveInlining)] get => new(z, y, z); }
    public float3 zzx { [MethodImpl(AggressiveInlining)] get => new(z, z, x); }
    public float3 zzy { [MethodImpl(AggressiveInlining)] get => new(z, z, y); }
    public float3 zzz { [MethodImpl(AggressiveInlining)] get => new(z, z, z); }
}
