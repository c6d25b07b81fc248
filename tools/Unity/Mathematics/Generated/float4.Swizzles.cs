// Written by generate.py.
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

public partial struct float4
{
    public float2 xx { [MethodImpl(AggressiveInlining)] get => new(x, x); }
    public float2 xy { [MethodImpl(AggressiveInlining)] get => new(x, y); [MethodImpl(AggressiveInlining)] set { x = value.x; y = value.y; } }
    public float2 xz { [MethodImpl(AggressiveInlining)] get => new(x, z); [MethodImpl(AggressiveInlining)] set { x = value.x; z = value.y; } }
    public float2 xw { [MethodImpl(AggressiveInlining)] get => new(x, w); [MethodImpl(AggressiveInlining)] set { x = value.x; w = value.y; } }
    public float2 yx { [MethodImpl(AggressiveInlining)] get => new(y, x); [MethodImpl(AggressiveInlining)] set { y = value.x; x = value.y; } }
    public float2 yy { [MethodImpl(AggressiveInlining)] get => new(y, y); }
    public float2 yz { [MethodImpl(AggressiveInlining)] get => new(y, z); [MethodImpl(AggressiveInlining)] set { y = value.x; z = value.y; } }
    public float2 yw { [MethodImpl(AggressiveInlining)] get => new(y, w); [MethodImpl(AggressiveInlining)] set { y = value.x; w = value.y; } }
    public float2 zx { [MethodImpl(AggressiveInlining)] get => new(z, x); [MethodImpl(AggressiveInlining)] set { z = value.x; x = value.y; } }
    public float2 zy { [MethodImpl(AggressiveInlining)] get => new(z, y); [MethodImpl(AggressiveInlining)] set { z = value.x; y = value.y; } }
    public float2 zz { [MethodImpl(AggressiveInlining)] get => new(z, z); }
    public float2 zw { [MethodImpl(AggressiveInlining)] get => new(z, w); [MethodImpl(AggressiveInlining)] set { z = value.x; w = value.y; } }
    public float2 wx { [MethodImpl(AggressiveInlining)] get => new(w, x); [MethodImpl(AggressiveInlining)] set { w = value.x; x = value.y; } }
    public float2 wy { [MethodImpl(AggressiveInlining)] get => new(w, y); [MethodImpl(AggressiveInlining)] set { w = value.x; y = value.y; } }
    public float2 wz { [MethodImpl(AggressiveInlining)] get => new(w, z); [MethodImpl(AggressiveInlining)] set { w = value.x; z = value.y; } }
    public float2 ww { [MethodImpl(AggressiveInlining)] get => new(w, w); }
    public float3 xxx { [MethodImpl(AggressiveInlining)] get => new(x, x, x); }
    public float3 xxy { [MethodImpl(AggressiveInlining)] get => new(x, x, y); }
    public float3 xxz { [MethodImpl(AggressiveInlining)] get => new(x, x, z); }
    public float3 xxw { [MethodImpl(AggressiveInlining)] get => new(x, x, w); }
    public float3 xyx { [MethodImpl(AggressiveInlining)] get => new(x, y, x); }
    public float3 xyy { [MethodImpl(AggressiveInlining)] get => new(x, y, y); }
    public float3 xyz { [MethodImpl(AggressiveInlining)] get => new(x, y, z); [MethodImpl(AggressiveInlining)] set { x = value.x; y = value.y; z = value.z; } }
    public float3 xyw { [MethodImpl(AggressiveInlining)] get => new(x, y, w); [MethodImpl(AggressiveInlining)] set { x = value.x; y = value.y; w = value.z; } }
    public float3 xzx { [MethodImpl(AggressiveInlining)] get => new(x, z, x); }
    public float3 xzy { [MethodImpl(AggressiveInlining)] get => new(x, z, y); [MethodImpl(AggressiveInlining)] set { x = value.x; z = value.y; y = value.z; } }
    public float3 xzz { [MethodImpl(AggressiveInlining)] get => new(x, z, z); }
    public float3 xzw { [MethodImpl(AggressiveInlining)] get => new(x, z, w); [MethodImpl(AggressiveInlining)] set { x = value.x; z = value.y; w = value.z; } }
    public float3 xwx { [MethodImpl(AggressiveInlining)] get => new(x, w, x); }
    public float3 xwy { [MethodImpl(AggressiveInlining)] get => new(x, w, y); [MethodImpl(AggressiveInlining)] set { x = value.x; w = value.y; y = value.z; } }
    public float3 xwz { [MethodImpl(AggressiveInlining)] get => new(x, w, z); [MethodImpl(AggressiveInlining)] set { x = value.x; w = value.y; z = value.z; } }
    public float3 xww { [MethodImpl(AggressiveInlining)] get => new(x, w, w); }
    public float3 yxx { [MethodImpl(AggressiveInlining)] get => new(y, x, x); }
    public float3 yxy { [MethodImpl(AggressiveInlining)] get => new(y, x, y); }
    public float3 yxz { [MethodImpl(AggressiveInlining)] get => new(y, x, z); [MethodImpl(AggressiveInlining)] set { y = value.x; x = value.y; z = value.z; } }
    public float3 yxw { [MethodImpl(AggressiveInlining)] get => new(y, x, w); [MethodImpl(AggressiveInlining)] set { y = value.x; x = value.y; w = value.z; } }
    public float3 yyx { [MethodImpl(AggressiveInlining)] get => new(y, y, x); }
    public float3 yyy { [MethodImpl(AggressiveInlining)] get => new(y, y, y); }
    public float3 yyz { [MethodImpl(AggressiveInlining)] get => new(y, y, z); }
    public float3 yyw { [MethodImpl(AggressiveInlining)] get => new(y, y, w); }
    public float3 yzx { [MethodImpl(AggressiveInlining)] get => new(y, z, x); [MethodImpl(AggressiveInlining)] set { y = value.x; z = value.y; x = value.z; } }
    public float3 yzy { [MethodImpl(AggressiveInlining)] get => new(y, z, y); }
    public float3 yzz { [MethodImpl(AggressiveInlining)] get => new(y, z, z); }
    public float3 yzw { [MethodImpl(AggressiveInlining)] get => new(y, z, w); [MethodImpl(AggressiveInlining)] set { y = value.x; z = value.y; w = value.z; } }
    public float3 ywx { [MethodImpl(AggressiveInlining)] get => new(y, w, x); [MethodImpl(AggressiveInlining)] set { y = value.x; w = value.y; x = value.z; } }
    public float3 ywy { [MethodImpl(AggressiveInlining)] get => new(y, w, y); }
    public float3 ywz { [MethodImpl(AggressiveInlining)] get => new(y, w, z); [MethodImpl(AggressiveInlining)] set { y = value.x; w = value.y; z = value.z; } }
    public float3 yww { [MethodImpl(AggressiveInlining)] get => new(y, w, w); }
    public float3 zxx { [MethodImpl(AggressiveInlining)] get => new(z, x, x); }
    public float3 zxy { [MethodImpl(AggressiveInlining)] get => new(z, x, y); [MethodImpl(AggressiveInlining)] set { z = value.x; x = value.y; y = value.z; } }
    public float3 zxz { [MethodImpl(AggressiveInlining)] get => new(z, x, z); }
    public float3 zxw { [MethodImpl(AggressiveInlining)] get => new(z, x, w); [MethodImpl(AggressiveInlining)] set { z = value.x; x = value.y; w = value.z; } }
    public float3 zyx { [MethodImpl(AggressiveInlining)] get => new(z, y, x); [MethodImpl(AggressiveInlining)] set { z = value.x; y = value.y; x = value.z; } }
    public float3 zyy { [MethodImpl(AggressiveInlining)] get => new(z, y, y); }
    public float3 zyz { [MethodImpl(AggressiveInlining)] get => new(z, y, z); }
    public float3 zyw { [MethodImpl(AggressiveInlining)] get => new(z, y, w); [MethodImpl(AggressiveInlining)] set { z = value.x; y = value.y; w = value.z; } }
    public float3 zzx { [MethodImpl(AggressiveInlining)] get => new(z, z, x); }
    public float3 zzy { [MethodImpl(AggressiveInlining)] get => new(z, z, y); }
    public float3 zzz { [MethodImpl(AggressiveInlining)] get => new(z, z, z); }
    public float3 zzw { [MethodImpl(AggressiveInlining)] get => new(z, z, w); }
    public float3 zwx { [MethodImpl(AggressiveInlining)] get => new(z, w, x); [MethodImpl(AggressiveInlining)] set { z = value.x; w = value.y; x = value.z; } }
    public float3 zwy { [MethodImpl(AggressiveInlining)] get => new(z, w, y); [MethodImpl(AggressiveInlining)] set { z = value.x; w = value.y; y = value.z; } }
    public float3 zwz { [MethodImpl(AggressiveInlining)] get => new(z, w, z); }
    public float3 zww { [MethodImpl(AggressiveInlining)] get => new(z, w, w); }
    public float3 wxx { [MethodImpl(AggressiveInlining)] get => new(w, x, x); }
    public float3 wxy { [MethodImpl(AggressiveInlining)] get => new(w, x, y); [MethodImpl(AggressiveInlining)] set { w = value.x; x = value.y; y = value.z; } }
    public float3 wxz { [MethodImpl(AggressiveInlining)] get => new(w, x, z); [MethodImpl(AggressiveInlining)] set { w = value.x; x = value.y; z = value.z; } }
    public float3 wxw { [MethodImpl(AggressiveInlining)] get => new(w, x, w); }
    public float3 wyx { [MethodImpl(AggressiveInlining)] get => new(w, y, x); [MethodImpl(AggressiveInlining)] set { w = value.x; y = value.y; x = value.z; } }
    public float3 wyy { [MethodImpl(AggressiveInlining)] get => new(w, y, y); }
    public float3 wyz { [MethodImpl(AggressiveInlining)] get => new(w, y, z); [MethodImpl(AggressiveInlining)] set { w = value.x; y = value.y; z = value.z; } }
    public float3 wyw { [MethodImpl(AggressiveInlining)] get => new(w, y, w); }
    public float3 wzx { [MethodImpl(AggressiveInlining)] get => new(w, z, x); [MethodImpl(AggressiveInlining)] set { w = value.x; z = value.y; x = value.z; } }
    public float3 wzy { [MethodImpl(AggressiveInlining)] get => new(w, z, y); [MethodImpl(AggressiveInlining)] set { w = value.x; z = value.y; y = value.z; } }
    public float3 wzz { [MethodImpl(AggressiveInlining)] get => new(w, z, z); }
    public float3 wzw { [MethodImpl(AggressiveInlining)] get => new(w, z, w); }
    public float3 wwx { [MethodImpl(AggressiveInlining)] get => new(w, w, x); }
    public float3 wwy { [MethodImpl(AggressiveInlining)] get => new(w, w, y); }
    public float3 wwz { [MethodImpl(AggressiveInlining)] get => new(w, w, z); }
    public float3 www { [MethodImpl(AggressiveInlining)] get => new(w, w, w); }
}
