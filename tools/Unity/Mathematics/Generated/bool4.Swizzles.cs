// Written by generate.py.
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

public partial struct bool4
{
    public bool2 xx { [MethodImpl(AggressiveInlining)] get => new(x, x); }
    public bool2 xy { [MethodImpl(AggressiveInlining)] get => new(x, y); [MethodImpl(AggressiveInlining)] set { x = value.x; y = value.y; } }
    public bool2 xz { [MethodImpl(AggressiveInlining)] get => new(x, z); [MethodImpl(AggressiveInlining)] set { x = value.x; z = value.y; } }
    public bool2 xw { [MethodImpl(AggressiveInlining)] get => new(x, w); [MethodImpl(AggressiveInlining)] set { x = value.x; w = value.y; } }
    public bool2 yx { [MethodImpl(AggressiveInlining)] get => new(y, x); [MethodImpl(AggressiveInlining)] set { y = value.x; x = value.y; } }
    public bool2 yy { [MethodImpl(AggressiveInlining)] get => new(y, y); }
    public bool2 yz { [MethodImpl(AggressiveInlining)] get => new(y, z); [MethodImpl(AggressiveInlining)] set { y = value.x; z = value.y; } }
    public bool2 yw { [MethodImpl(AggressiveInlining)] get => new(y, w); [MethodImpl(AggressiveInlining)] set { y = value.x; w = value.y; } }
    public bool2 zx { [MethodImpl(AggressiveInlining)] get => new(z, x); [MethodImpl(AggressiveInlining)] set { z = value.x; x = value.y; } }
    public bool2 zy { [MethodImpl(AggressiveInlining)] get => new(z, y); [MethodImpl(AggressiveInlining)] set { z = value.x; y = value.y; } }
    public bool2 zz { [MethodImpl(AggressiveInlining)] get => new(z, z); }
    public bool2 zw { [MethodImpl(AggressiveInlining)] get => new(z, w); [MethodImpl(AggressiveInlining)] set { z = value.x; w = value.y; } }
    public bool2 wx { [MethodImpl(AggressiveInlining)] get => new(w, x); [MethodImpl(AggressiveInlining)] set { w = value.x; x = value.y; } }
    public bool2 wy { [MethodImpl(AggressiveInlining)] get => new(w, y); [MethodImpl(AggressiveInlining)] set { w = value.x; y = value.y; } }
    public bool2 wz { [MethodImpl(AggressiveInlining)] get => new(w, z); [MethodImpl(AggressiveInlining)] set { w = value.x; z = value.y; } }
    public bool2 ww { [MethodImpl(AggressiveInlining)] get => new(w, w); }
    public bool3 xxx { [MethodImpl(AggressiveInlining)] get => new(x, x, x); }
    public bool3 xxy { [MethodImpl(AggressiveInlining)] get => new(x, x, y); }
    public bool3 xxz { [MethodImpl(AggressiveInlining)] get => new(x, x, z); }
    public bool3 xxw { [MethodImpl(AggressiveInlining)] get => new(x, x, w); }
    public bool3 xyx { [MethodImpl(AggressiveInlining)] get => new(x, y, x); }
    public bool3 xyy { [MethodImpl(AggressiveInlining)] get => new(x, y, y); }
    public bool3 xyz { [MethodImpl(AggressiveInlining)] get => new(x, y, z); [MethodImpl(AggressiveInlining)] set { x = value.x; y = value.y; z = value.z; } }
    public bool3 xyw { [MethodImpl(AggressiveInlining)] get => new(x, y, w); [MethodImpl(AggressiveInlining)] set { x = value.x; y = value.y; w = value.z; } }
    public bool3 xzx { [MethodImpl(AggressiveInlining)] get => new(x, z, x); }
    public bool3 xzy { [MethodImpl(AggressiveInlining)] get => new(x, z, y); [MethodImpl(AggressiveInlining)] set { x = value.x; z = value.y; y = value.z; } }
    public bool3 xzz { [MethodImpl(AggressiveInlining)] get => new(x, z, z); }
    public bool3 xzw { [MethodImpl(AggressiveInlining)] get => new(x, z, w); [MethodImpl(AggressiveInlining)] set { x = value.x; z = value.y; w = value.z; } }
    public bool3 xwx { [MethodImpl(AggressiveInlining)] get => new(x, w, x); }
    public bool3 xwy { [MethodImpl(AggressiveInlining)] get => new(x, w, y); [MethodImpl(AggressiveInlining)] set { x = value.x; w = value.y; y = value.z; } }
    public bool3 xwz { [MethodImpl(AggressiveInlining)] get => new(x, w, z); [MethodImpl(AggressiveInlining)] set { x = value.x; w = value.y; z = value.z; } }
    public bool3 xww { [MethodImpl(AggressiveInlining)] get => new(x, w, w); }
    public bool3 yxx { [MethodImpl(AggressiveInlining)] get => new(y, x, x); }
    public bool3 yxy { [MethodImpl(AggressiveInlining)] get => new(y, x, y); }
    public bool3 yxz { [MethodImpl(AggressiveInlining)] get => new(y, x, z); [MethodImpl(AggressiveInlining)] set { y = value.x; x = value.y; z = value.z; } }
    public bool3 yxw { [MethodImpl(AggressiveInlining)] get => new(y, x, w); [MethodImpl(AggressiveInlining)] set { y = value.x; x = value.y; w = value.z; } }
    public bool3 yyx { [MethodImpl(AggressiveInlining)] get => new(y, y, x); }
    public bool3 yyy { [MethodImpl(AggressiveInlining)] get => new(y, y, y); }
    public bool3 yyz { [MethodImpl(AggressiveInlining)] get => new(y, y, z); }
    public bool3 yyw { [MethodImpl(AggressiveInlining)] get => new(y, y, w); }
    public bool3 yzx { [MethodImpl(AggressiveInlining)] get => new(y, z, x); [MethodImpl(AggressiveInlining)] set { y = value.x; z = value.y; x = value.z; } }
    public bool3 yzy { [MethodImpl(AggressiveInlining)] get => new(y, z, y); }
    public bool3 yzz { [MethodImpl(AggressiveInlining)] get => new(y, z, z); }
    public bool3 yzw { [MethodImpl(AggressiveInlining)] get => new(y, z, w); [MethodImpl(AggressiveInlining)] set { y = value.x; z = value.y; w = value.z; } }
    public bool3 ywx { [MethodImpl(AggressiveInlining)] get => new(y, w, x); [MethodImpl(AggressiveInlining)] set { y = value.x; w = value.y; x = value.z; } }
    public bool3 ywy { [MethodImpl(AggressiveInlining)] get => new(y, w, y); }
    public bool3 ywz { [MethodImpl(AggressiveInlining)] get => new(y, w, z); [MethodImpl(AggressiveInlining)] set { y = value.x; w = value.y; z = value.z; } }
    public bool3 yww { [MethodImpl(AggressiveInlining)] get => new(y, w, w); }
    public bool3 zxx { [MethodImpl(AggressiveInlining)] get => new(z, x, x); }
    public bool3 zxy { [MethodImpl(AggressiveInlining)] get => new(z, x, y); [MethodImpl(AggressiveInlining)] set { z = value.x; x = value.y; y = value.z; } }
    public bool3 zxz { [MethodImpl(AggressiveInlining)] get => new(z, x, z); }
    public bool3 zxw { [MethodImpl(AggressiveInlining)] get => new(z, x, w); [MethodImpl(AggressiveInlining)] set { z = value.x; x = value.y; w = value.z; } }
    public bool3 zyx { [MethodImpl(AggressiveInlining)] get => new(z, y, x); [MethodImpl(AggressiveInlining)] set { z = value.x; y = value.y; x = value.z; } }
    public bool3 zyy { [MethodImpl(AggressiveInlining)] get => new(z, y, y); }
    public bool3 zyz { [MethodImpl(AggressiveInlining)] get => new(z, y, z); }
    public bool3 zyw { [MethodImpl(AggressiveInlining)] get => new(z, y, w); [MethodImpl(AggressiveInlining)] set { z = value.x; y = value.y; w = value.z; } }
    public bool3 zzx { [MethodImpl(AggressiveInlining)] get => new(z, z, x); }
    public bool3 zzy { [MethodImpl(AggressiveInlining)] get => new(z, z, y); }
    public bool3 zzz { [MethodImpl(AggressiveInlining)] get => new(z, z, z); }
    public bool3 zzw { [MethodImpl(AggressiveInlining)] get => new(z, z, w); }
    public bool3 zwx { [MethodImpl(AggressiveInlining)] get => new(z, w, x); [MethodImpl(AggressiveInlining)] set { z = value.x; w = value.y; x = value.z; } }
    public bool3 zwy { [MethodImpl(AggressiveInlining)] get => new(z, w, y); [MethodImpl(AggressiveInlining)] set { z = value.x; w = value.y; y = value.z; } }
    public bool3 zwz { [MethodImpl(AggressiveInlining)] get => new(z, w, z); }
    public bool3 zww { [MethodImpl(AggressiveInlining)] get => new(z, w, w); }
    public bool3 wxx { [MethodImpl(AggressiveInlining)] get => new(w, x, x); }
    public bool3 wxy { [MethodImpl(AggressiveInlining)] get => new(w, x, y); [MethodImpl(AggressiveInlining)] set { w = value.x; x = value.y; y = value.z; } }
    public bool3 wxz { [MethodImpl(AggressiveInlining)] get => new(w, x, z); [MethodImpl(AggressiveInlining)] set { w = value.x; x = value.y; z = value.z; } }
    public bool3 wxw { [MethodImpl(AggressiveInlining)] get => new(w, x, w); }
    public bool3 wyx { [MethodImpl(AggressiveInlining)] get => new(w, y, x); [MethodImpl(AggressiveInlining)] set { w = value.x; y = value.y; x = value.z; } }
    public bool3 wyy { [MethodImpl(AggressiveInlining)] get => new(w, y, y); }
    public bool3 wyz { [MethodImpl(AggressiveInlining)] get => new(w, y, z); [MethodImpl(AggressiveInlining)] set { w = value.x; y = value.y; z = value.z; } }
    public bool3 wyw { [MethodImpl(AggressiveInlining)] get => new(w, y, w); }
    public bool3 wzx { [MethodImpl(AggressiveInlining)] get => new(w, z, x); [MethodImpl(AggressiveInlining)] set { w = value.x; z = value.y; x = value.z; } }
    public bool3 wzy { [MethodImpl(AggressiveInlining)] get => new(w, z, y); [MethodImpl(AggressiveInlining)] set { w = value.x; z = value.y; y = value.z; } }
    public bool3 wzz { [MethodImpl(AggressiveInlining)] get => new(w, z, z); }
    public bool3 wzw { [MethodImpl(AggressiveInlining)] get => new(w, z, w); }
    public bool3 wwx { [MethodImpl(AggressiveInlining)] get => new(w, w, x); }
    public bool3 wwy { [MethodImpl(AggressiveInlining)] get => new(w, w, y); }
    public bool3 wwz { [MethodImpl(AggressiveInlining)] get => new(w, w, z); }
    public bool3 www { [MethodImpl(AggressiveInlining)] get => new(w, w, w); }
}
