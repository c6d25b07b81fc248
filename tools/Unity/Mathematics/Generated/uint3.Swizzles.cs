// Written by generate.py.
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

public partial struct uint3
{
    public uint2 xx { [MethodImpl(AggressiveInlining)] get => new(x, x); }
    public uint2 xy { [MethodImpl(AggressiveInlining)] get => new(x, y); [MethodImpl(AggressiveInlining)] set { x = value.x; y = value.y; } }
    public uint2 xz { [MethodImpl(AggressiveInlining)] get => new(x, z); [MethodImpl(AggressiveInlining)] set { x = value.x; z = value.y; } }
    public uint2 yx { [MethodImpl(AggressiveInlining)] get => new(y, x); [MethodImpl(AggressiveInlining)] set { y = value.x; x = value.y; } }
    public uint2 yy { [MethodImpl(AggressiveInlining)] get => new(y, y); }
    public uint2 yz { [MethodImpl(AggressiveInlining)] get => new(y, z); [MethodImpl(AggressiveInlining)] set { y = value.x; z = value.y; } }
    public uint2 zx { [MethodImpl(AggressiveInlining)] get => new(z, x); [MethodImpl(AggressiveInlining)] set { z = value.x; x = value.y; } }
    public uint2 zy { [MethodImpl(AggressiveInlining)] get => new(z, y); [MethodImpl(AggressiveInlining)] set { z = value.x; y = value.y; } }
    public uint2 zz { [MethodImpl(AggressiveInlining)] get => new(z, z); }
    public uint3 xxx { [MethodImpl(AggressiveInlining)] get => new(x, x, x); }
    public uint3 xxy { [MethodImpl(AggressiveInlining)] get => new(x, x, y); }
    public uint3 xxz { [MethodImpl(AggressiveInlining)] get => new(x, x, z); }
    public uint3 xyx { [MethodImpl(AggressiveInlining)] get => new(x, y, x); }
    public uint3 xyy { [MethodImpl(AggressiveInlining)] get => new(x, y, y); }
    public uint3 xyz { [MethodImpl(AggressiveInlining)] get => new(x, y, z); [MethodImpl(AggressiveInlining)] set { x = value.x; y = value.y; z = value.z; } }
    public uint3 xzx { [MethodImpl(AggressiveInlining)] get => new(x, z, x); }
    public uint3 xzy { [MethodImpl(AggressiveInlining)] get => new(x, z, y); [MethodImpl(AggressiveInlining)] set { x = value.x; z = value.y; y = value.z; } }
    public uint3 xzz { [MethodImpl(AggressiveInlining)] get => new(x, z, z); }
    public uint3 yxx { [MethodImpl(AggressiveInlining)] get => new(y, x, x); }
    public uint3 yxy { [MethodImpl(AggressiveInlining)] get => new(y, x, y); }
    public uint3 yxz { [MethodImpl(AggressiveInlining)] get => new(y, x, z); [MethodImpl(AggressiveInlining)] set { y = value.x; x = value.y; z = value.z; } }
    public uint3 yyx { [MethodImpl(AggressiveInlining)] get => new(y, y, x); }
    public uint3 yyy { [MethodImpl(AggressiveInlining)] get => new(y, y, y); }
    public uint3 yyz { [MethodImpl(AggressiveInlining)] get => new(y, y, z); }
    public uint3 yzx { [MethodImpl(AggressiveInlining)] get => new(y, z, x); [MethodImpl(AggressiveInlining)] set { y = value.x; z = value.y; x = value.z; } }
    public uint3 yzy { [MethodImpl(AggressiveInlining)] get => new(y, z, y); }
    public uint3 yzz { [MethodImpl(AggressiveInlining)] get => new(y, z, z); }
    public uint3 zxx { [MethodImpl(AggressiveInlining)] get => new(z, x, x); }
    public uint3 zxy { [MethodImpl(AggressiveInlining)] get => new(z, x, y); [MethodImpl(AggressiveInlining)] set { z = value.x; x = value.y; y = value.z; } }
    public uint3 zxz { [MethodImpl(AggressiveInlining)] get => new(z, x, z); }
    public uint3 zyx { [MethodImpl(AggressiveInlining)] get => new(z, y, x); [MethodImpl(AggressiveInlining)] set { z = value.x; y = value.y; x = value.z; } }
    public uint3 zyy { [MethodImpl(AggressiveInlining)] get => new(z, y, y); }
    public uint3 zyz { [MethodImpl(AggressiveInlining)] get => new(z, y, z); }
    public uint3 zzx { [MethodImpl(AggressiveInlining)] get => new(z, z, x); }
    public uint3 zzy { [MethodImpl(AggressiveInlining)] get => new(z, z, y); }
    public uint3 zzz { [MethodImpl(AggressiveInlining)] get => new(z, z, z); }
}
