// Written by generate.py.
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

public partial struct uint4
{
    public uint2 xx { [MethodImpl(AggressiveInlining)] get => new(x, x); }
    public uint2 xy { [MethodImpl(AggressiveInlining)] get => new(x, y); [MethodImpl(AggressiveInlining)] set { x = value.x; y = value.y; } }
    public uint2 xz { [MethodImpl(AggressiveInlining)] get => new(x, z); [MethodImpl(AggressiveInlining)] set { x = value.x; z = value.y; } }
    public uint2 xw { [MethodImpl(AggressiveInlining)] get => new(x, w); [MethodImpl(AggressiveInlining)] set { x = value.x; w = value.y; } }
    public uint2 yx { [MethodImpl(AggressiveInlining)] get => new(y, x); [MethodImpl(AggressiveInlining)] set { y = value.x; x = value.y; } }
    public uint2 yy { [MethodImpl(AggressiveInlining)] get => new(y, y); }
    public uint2 yz { [MethodImpl(AggressiveInlining)] get => new(y, z); [MethodImpl(AggressiveInlining)] set { y = value.x; z = value.y; } }
    public uint2 yw { [MethodImpl(AggressiveInlining)] get => new(y, w); [MethodImpl(AggressiveInlining)] set { y = value.x; w = value.y; } }
    public uint2 zx { [MethodImpl(AggressiveInlining)] get => new(z, x); [MethodImpl(AggressiveInlining)] set { z = value.x; x = value.y; } }
    public uint2 zy { [MethodImpl(AggressiveInlining)] get => new(z, y); [MethodImpl(AggressiveInlining)] set { z = value.x; y = value.y; } }
    public uint2 zz { [MethodImpl(AggressiveInlining)] get => new(z, z); }
    public uint2 zw { [MethodImpl(AggressiveInlining)] get => new(z, w); [MethodImpl(AggressiveInlining)] set { z = value.x; w = value.y; } }
    public uint2 wx { [MethodImpl(AggressiveInlining)] get => new(w, x); [MethodImpl(AggressiveInlining)] set { w = value.x; x = value.y; } }
    public uint2 wy { [MethodImpl(AggressiveInlining)] get => new(w, y); [MethodImpl(AggressiveInlining)] set { w = value.x; y = value.y; } }
    public uint2 wz { [MethodImpl(AggressiveInlining)] get => new(w, z); [MethodImpl(AggressiveInlining)] set { w = value.x; z = value.y; } }
    public uint2 ww { [MethodImpl(AggressiveInlining)] get => new(w, w); }
    public uint3 xxx { [MethodImpl(AggressiveInlining)] get => new(x, x, x); }
    public uint3 xxy { [MethodImpl(AggressiveInlining)] get => new(x, x, y); }
    public uint3 xxz { [MethodImpl(AggressiveInlining)] get => new(x, x, z); }
    public uint3 xxw { [MethodImpl(AggressiveInlining)] get => new(x, x, w); }
    public uint3 xyx { [MethodImpl(AggressiveInlining)] get => new(x, y, x); }
    public uint3 xyy { [MethodImpl(AggressiveInlining)] get => new(x, y, y); }
    public uint3 xyz { [MethodImpl(AggressiveInlining)] get => new(x, y, z); [MethodImpl(AggressiveInlining)] set { x = value.x; y = value.y; z = value.z; } }
    public uint3 xyw { [MethodImpl(AggressiveInlining)] get => new(x, y, w); [MethodImpl(AggressiveInlining)] set { x = value.x; y = value.y; w = value.z; } }
    public uint3 xzx { [MethodImpl(AggressiveInlining)] get => new(x, z, x); }
    public uint3 xzy { [MethodImpl(AggressiveInlining)] get => new(x, z, y); [MethodImpl(AggressiveInlining)] set { x = value.x; z = value.y; y = value.z; } }
    public uint3 xzz { [MethodImpl(AggressiveInlining)] get => new(x, z, z); }
    public uint3 xzw { [MethodImpl(AggressiveInlining)] get => new(x, z, w); [MethodImpl(AggressiveInlining)] set { x = value.x; z = value.y; w = value.z; } }
    public uint3 xwx { [MethodImpl(AggressiveInlining)] get => new(x, w, x); }
    public uint3 xwy { [MethodImpl(AggressiveInlining)] get => new(x, w, y); [MethodImpl(AggressiveInlining)] set { x = value.x; w = value.y; y = value.z; } }
    public uint3 xwz { [MethodImpl(AggressiveInlining)] get => new(x, w, z); [MethodImpl(AggressiveInlining)] set { x = value.x; w = value.y; z = value.z; } }
    public uint3 xww { [MethodImpl(AggressiveInlining)] get => new(x, w, w); }
    public uint3 yxx { [MethodImpl(AggressiveInlining)] get => new(y, x, x); }
    public uint3 yxy { [MethodImpl(AggressiveInlining)] get => new(y, x, y); }
    public uint3 yxz { [MethodImpl(AggressiveInlining)] get => new(y, x, z); [MethodImpl(AggressiveInlining)] set { y = value.x; x = value.y; z = value.z; } }
    public uint3 yxw { [MethodImpl(AggressiveInlining)] get => new(y, x, w); [MethodImpl(AggressiveInlining)] set { y = value.x; x = value.y; w = value.z; } }
    public uint3 yyx { [MethodImpl(AggressiveInlining)] get => new(y, y, x); }
    public uint3 yyy { [MethodImpl(AggressiveInlining)] get => new(y, y, y); }
    public uint3 yyz { [MethodImpl(AggressiveInlining)] get => new(y, y, z); }
    public uint3 yyw { [MethodImpl(AggressiveInlining)] get => new(y, y, w); }
    public uint3 yzx { [MethodImpl(AggressiveInlining)] get => new(y, z, x); [MethodImpl(AggressiveInlining)] set { y = value.x; z = value.y; x = value.z; } }
    public uint3 yzy { [MethodImpl(AggressiveInlining)] get => new(y, z, y); }
    public uint3 yzz { [MethodImpl(AggressiveInlining)] get => new(y, z, z); }
    public uint3 yzw { [MethodImpl(AggressiveInlining)] get => new(y, z, w); [MethodImpl(AggressiveInlining)] set { y = value.x; z = value.y; w = value.z; } }
    public uint3 ywx { [MethodImpl(AggressiveInlining)] get => new(y, w, x); [MethodImpl(AggressiveInlining)] set { y = value.x; w = value.y; x = value.z; } }
    public uint3 ywy { [MethodImpl(AggressiveInlining)] get => new(y, w, y); }
    public uint3 ywz { [MethodImpl(AggressiveInlining)] get => new(y, w, z); [MethodImpl(AggressiveInlining)] set { y = value.x; w = value.y; z = value.z; } }
    public uint3 yww { [MethodImpl(AggressiveInlining)] get => new(y, w, w); }
    public uint3 zxx { [MethodImpl(AggressiveInlining)] get => new(z, x, x); }
    public uint3 zxy { [MethodImpl(AggressiveInlining)] get => new(z, x, y); [MethodImpl(AggressiveInlining)] set { z = value.x; x = value.y; y = value.z; } }
    public uint3 zxz { [MethodImpl(AggressiveInlining)] get => new(z, x, z); }
    public uint3 zxw { [MethodImpl(AggressiveInlining)] get => new(z, x, w); [MethodImpl(AggressiveInlining)] set { z = value.x; x = value.y; w = value.z; } }
    public uint3 zyx { [MethodImpl(AggressiveInlining)] get => new(z, y, x); [MethodImpl(AggressiveInlining)] set { z = value.x; y = value.y; x = value.z; } }
    public uint3 zyy { [MethodImpl(AggressiveInlining)] get => new(z, y, y); }
    public uint3 zyz { [MethodImpl(AggressiveInlining)] get => new(z, y, z); }
    public uint3 zyw { [MethodImpl(AggressiveInlining)] get => new(z, y, w); [MethodImpl(AggressiveInlining)] set { z = value.x; y = value.y; w = value.z; } }
    public uint3 zzx { [MethodImpl(AggressiveInlining)] get => new(z, z, x); }
    public uint3 zzy { [MethodImpl(AggressiveInlining)] get => new(z, z, y); }
    public uint3 zzz { [MethodImpl(AggressiveInlining)] get => new(z, z, z); }
    public uint3 zzw { [MethodImpl(AggressiveInlining)] get => new(z, z, w); }
    public uint3 zwx { [MethodImpl(AggressiveInlining)] get => new(z, w, x); [MethodImpl(AggressiveInlining)] set { z = value.x; w = value.y; x = value.z; } }
    public uint3 zwy { [MethodImpl(AggressiveInlining)] get => new(z, w, y); [MethodImpl(AggressiveInlining)] set { z = value.x; w = value.y; y = value.z; } }
    public uint3 zwz { [MethodImpl(AggressiveInlining)] get => new(z, w, z); }
    public uint3 zww { [MethodImpl(AggressiveInlining)] get => new(z, w, w); }
    public uint3 wxx { [MethodImpl(AggressiveInlining)] get => new(w, x, x); }
    public uint3 wxy { [MethodImpl(AggressiveInlining)] get => new(w, x, y); [MethodImpl(AggressiveInlining)] set { w = value.x; x = value.y; y = value.z; } }
    public uint3 wxz { [MethodImpl(AggressiveInlining)] get => new(w, x, z); [MethodImpl(AggressiveInlining)] set { w = value.x; x = value.y; z = value.z; } }
    public uint3 wxw { [MethodImpl(AggressiveInlining)] get => new(w, x, w); }
    public uint3 wyx { [MethodImpl(AggressiveInlining)] get => new(w, y, x); [MethodImpl(AggressiveInlining)] set { w = value.x; y = value.y; x = value.z; } }
    public uint3 wyy { [MethodImpl(AggressiveInlining)] get => new(w, y, y); }
    public uint3 wyz { [MethodImpl(AggressiveInlining)] get => new(w, y, z); [MethodImpl(AggressiveInlining)] set { w = value.x; y = value.y; z = value.z; } }
    public uint3 wyw { [MethodImpl(AggressiveInlining)] get => new(w, y, w); }
    public uint3 wzx { [MethodImpl(AggressiveInlining)] get => new(w, z, x); [MethodImpl(AggressiveInlining)] set { w = value.x; z = value.y; x = value.z; } }
    public uint3 wzy { [MethodImpl(AggressiveInlining)] get => new(w, z, y); [MethodImpl(AggressiveInlining)] set { w = value.x; z = value.y; y = value.z; } }
    public uint3 wzz { [MethodImpl(AggressiveInlining)] get => new(w, z, z); }
    public uint3 wzw { [MethodImpl(AggressiveInlining)] get => new(w, z, w); }
    public uint3 wwx { [MethodImpl(AggressiveInlining)] get => new(w, w, x); }
    public uint3 wwy { [MethodImpl(AggressiveInlining)] get => new(w, w, y); }
    public uint3 wwz { [MethodImpl(AggressiveInlining)] get => new(w, w, z); }
    public uint3 www { [MethodImpl(AggressiveInlining)] get => new(w, w, w); }
}
