// Written by generate.py.
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

public partial struct double4
{
    public double2 xx { [MethodImpl(AggressiveInlining)] get => new(x, x); }
    public double2 xy { [MethodImpl(AggressiveInlining)] get => new(x, y); [MethodImpl(AggressiveInlining)] set { x = value.x; y = value.y; } }
    public double2 xz { [MethodImpl(AggressiveInlining)] get => new(x, z); [MethodImpl(AggressiveInlining)] set { x = value.x; z = value.y; } }
    public double2 xw { [MethodImpl(AggressiveInlining)] get => new(x, w); [MethodImpl(AggressiveInlining)] set { x = value.x; w = value.y; } }
    public double2 yx { [MethodImpl(AggressiveInlining)] get => new(y, x); [MethodImpl(AggressiveInlining)] set { y = value.x; x = value.y; } }
    public double2 yy { [MethodImpl(AggressiveInlining)] get => new(y, y); }
    public double2 yz { [MethodImpl(AggressiveInlining)] get => new(y, z); [MethodImpl(AggressiveInlining)] set { y = value.x; z = value.y; } }
    public double2 yw { [MethodImpl(AggressiveInlining)] get => new(y, w); [MethodImpl(AggressiveInlining)] set { y = value.x; w = value.y; } }
    public double2 zx { [MethodImpl(AggressiveInlining)] get => new(z, x); [MethodImpl(AggressiveInlining)] set { z = value.x; x = value.y; } }
    public double2 zy { [MethodImpl(AggressiveInlining)] get => new(z, y); [MethodImpl(AggressiveInlining)] set { z = value.x; y = value.y; } }
    public double2 zz { [MethodImpl(AggressiveInlining)] get => new(z, z); }
    public double2 zw { [MethodImpl(AggressiveInlining)] get => new(z, w); [MethodImpl(AggressiveInlining)] set { z = value.x; w = value.y; } }
    public double2 wx { [MethodImpl(AggressiveInlining)] get => new(w, x); [MethodImpl(AggressiveInlining)] set { w = value.x; x = value.y; } }
    public double2 wy { [MethodImpl(AggressiveInlining)] get => new(w, y); [MethodImpl(AggressiveInlining)] set { w = value.x; y = value.y; } }
    public double2 wz { [MethodImpl(AggressiveInlining)] get => new(w, z); [MethodImpl(AggressiveInlining)] set { w = value.x; z = value.y; } }
    public double2 ww { [MethodImpl(AggressiveInlining)] get => new(w, w); }
    public double3 xxx { [MethodImpl(AggressiveInlining)] get => new(x, x, x); }
    public double3 xxy { [MethodImpl(AggressiveInlining)] get => new(x, x, y); }
    public double3 xxz { [MethodImpl(AggressiveInlining)] get => new(x, x, z); }
    public double3 xxw { [MethodImpl(AggressiveInlining)] get => new(x, x, w); }
    public double3 xyx { [MethodImpl(AggressiveInlining)] get => new(x, y, x); }
    public double3 xyy { [MethodImpl(AggressiveInlining)] get => new(x, y, y); }
    public double3 xyz { [MethodImpl(AggressiveInlining)] get => new(x, y, z); [MethodImpl(AggressiveInlining)] set { x = value.x; y = value.y; z = value.z; } }
    public double3 xyw { [MethodImpl(AggressiveInlining)] get => new(x, y, w); [MethodImpl(AggressiveInlining)] set { x = value.x; y = value.y; w = value.z; } }
    public double3 xzx { [MethodImpl(AggressiveInlining)] get => new(x, z, x); }
    public double3 xzy { [MethodImpl(AggressiveInlining)] get => new(x, z, y); [MethodImpl(AggressiveInlining)] set { x = value.x; z = value.y; y = value.z; } }
    public double3 xzz { [MethodImpl(AggressiveInlining)] get => new(x, z, z); }
    public double3 xzw { [MethodImpl(AggressiveInlining)] get => new(x, z, w); [MethodImpl(AggressiveInlining)] set { x = value.x; z = value.y; w = value.z; } }
    public double3 xwx { [MethodImpl(AggressiveInlining)] get => new(x, w, x); }
    public double3 xwy { [MethodImpl(AggressiveInlining)] get => new(x, w, y); [MethodImpl(AggressiveInlining)] set { x = value.x; w = value.y; y = value.z; } }
    public double3 xwz { [MethodImpl(AggressiveInlining)] get => new(x, w, z); [MethodImpl(AggressiveInlining)] set { x = value.x; w = value.y; z = value.z; } }
    public double3 xww { [MethodImpl(AggressiveInlining)] get => new(x, w, w); }
    public double3 yxx { [MethodImpl(AggressiveInlining)] get => new(y, x, x); }
    public double3 yxy { [MethodImpl(AggressiveInlining)] get => new(y, x, y); }
    public double3 yxz { [MethodImpl(AggressiveInlining)] get => new(y, x, z); [MethodImpl(AggressiveInlining)] set { y = value.x; x = value.y; z = value.z; } }
    public double3 yxw { [MethodImpl(AggressiveInlining)] get => new(y, x, w); [MethodImpl(AggressiveInlining)] set { y = value.x; x = value.y; w = value.z; } }
    public double3 yyx { [MethodImpl(AggressiveInlining)] get => new(y, y, x); }
    public double3 yyy { [MethodImpl(AggressiveInlining)] get => new(y, y, y); }
    public double3 yyz { [MethodImpl(AggressiveInlining)] get => new(y, y, z); }
    public double3 yyw { [MethodImpl(AggressiveInlining)] get => new(y, y, w); }
    public double3 yzx { [MethodImpl(AggressiveInlining)] get => new(y, z, x); [MethodImpl(AggressiveInlining)] set { y = value.x; z = value.y; x = value.z; } }
    public double3 yzy { [MethodImpl(AggressiveInlining)] get => new(y, z, y); }
    public double3 yzz { [MethodImpl(AggressiveInlining)] get => new(y, z, z); }
    public double3 yzw { [MethodImpl(AggressiveInlining)] get => new(y, z, w); [MethodImpl(AggressiveInlining)] set { y = value.x; z = value.y; w = value.z; } }
    public double3 ywx { [MethodImpl(AggressiveInlining)] get => new(y, w, x); [MethodImpl(AggressiveInlining)] set { y = value.x; w = value.y; x = value.z; } }
    public double3 ywy { [MethodImpl(AggressiveInlining)] get => new(y, w, y); }
    public double3 ywz { [MethodImpl(AggressiveInlining)] get => new(y, w, z); [MethodImpl(AggressiveInlining)] set { y = value.x; w = value.y; z = value.z; } }
    public double3 yww { [MethodImpl(AggressiveInlining)] get => new(y, w, w); }
    public double3 zxx { [MethodImpl(AggressiveInlining)] get => new(z, x, x); }
    public double3 zxy { [MethodImpl(AggressiveInlining)] get => new(z, x, y); [MethodImpl(AggressiveInlining)] set { z = value.x; x = value.y; y = value.z; } }
    public double3 zxz { [MethodImpl(AggressiveInlining)] get => new(z, x, z); }
    public double3 zxw { [MethodImpl(AggressiveInlining)] get => new(z, x, w); [MethodImpl(AggressiveInlining)] set { z = value.x; x = value.y; w = value.z; } }
    public double3 zyx { [MethodImpl(AggressiveInlining)] get => new(z, y, x); [MethodImpl(AggressiveInlining)] set { z = value.x; y = value.y; x = value.z; } }
    public double3 zyy { [MethodImpl(AggressiveInlining)] get => new(z, y, y); }
    public double3 zyz { [MethodImpl(AggressiveInlining)] get => new(z, y, z); }
    public double3 zyw { [MethodImpl(AggressiveInlining)] get => new(z, y, w); [MethodImpl(AggressiveInlining)] set { z = value.x; y = value.y; w = value.z; } }
    public double3 zzx { [MethodImpl(AggressiveInlining)] get => new(z, z, x); }
    public double3 zzy { [MethodImpl(AggressiveInlining)] get => new(z, z, y); }
    public double3 zzz { [MethodImpl(AggressiveInlining)] get => new(z, z, z); }
    public double3 zzw { [MethodImpl(AggressiveInlining)] get => new(z, z, w); }
    public double3 zwx { [MethodImpl(AggressiveInlining)] get => new(z, w, x); [MethodImpl(AggressiveInlining)] set { z = value.x; w = value.y; x = value.z; } }
    public double3 zwy { [MethodImpl(AggressiveInlining)] get => new(z, w, y); [MethodImpl(AggressiveInlining)] set { z = value.x; w = value.y; y = value.z; } }
    public double3 zwz { [MethodImpl(AggressiveInlining)] get => new(z, w, z); }
    public double3 zww { [MethodImpl(AggressiveInlining)] get => new(z, w, w); }
    public double3 wxx { [MethodImpl(AggressiveInlining)] get => new(w, x, x); }
    public double3 wxy { [MethodImpl(AggressiveInlining)] get => new(w, x, y); [MethodImpl(AggressiveInlining)] set { w = value.x; x = value.y; y = value.z; } }
    public double3 wxz { [MethodImpl(AggressiveInlining)] get => new(w, x, z); [MethodImpl(AggressiveInlining)] set { w = value.x; x = value.y; z = value.z; } }
    public double3 wxw { [MethodImpl(AggressiveInlining)] get => new(w, x, w); }
    public double3 wyx { [MethodImpl(AggressiveInlining)] get => new(w, y, x); [MethodImpl(AggressiveInlining)] set { w = value.x; y = value.y; x = value.z; } }
    public double3 wyy { [MethodImpl(AggressiveInlining)] get => new(w, y, y); }
    public double3 wyz { [MethodImpl(AggressiveInlining)] get => new(w, y, z); [MethodImpl(AggressiveInlining)] set { w = value.x; y = value.y; z = value.z; } }
    public double3 wyw { [MethodImpl(AggressiveInlining)] get => new(w, y, w); }
    public double3 wzx { [MethodImpl(AggressiveInlining)] get => new(w, z, x); [MethodImpl(AggressiveInlining)] set { w = value.x; z = value.y; x = value.z; } }
    public double3 wzy { [MethodImpl(AggressiveInlining)] get => new(w, z, y); [MethodImpl(AggressiveInlining)] set { w = value.x; z = value.y; y = value.z; } }
    public double3 wzz { [MethodImpl(AggressiveInlining)] get => new(w, z, z); }
    public double3 wzw { [MethodImpl(AggressiveInlining)] get => new(w, z, w); }
    public double3 wwx { [MethodImpl(AggressiveInlining)] get => new(w, w, x); }
    public double3 wwy { [MethodImpl(AggressiveInlining)] get => new(w, w, y); }
    public double3 wwz { [MethodImpl(AggressiveInlining)] get => new(w, w, z); }
    public double3 www { [MethodImpl(AggressiveInlining)] get => new(w, w, w); }
}
