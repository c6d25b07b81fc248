// Written by generate.py.
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

public partial struct bool3
{
    public bool2 xx { [MethodImpl(AggressiveInlining)] get => new(x, x); }
    public bool2 xy { [MethodImpl(AggressiveInlining)] get => new(x, y); [MethodImpl(AggressiveInlining)] set { x = value.x; y = value.y; } }
    public bool2 xz { [MethodImpl(AggressiveInlining)] get => new(x, z); [MethodImpl(AggressiveInlining)] set { x = value.x; z = value.y; } }
    public bool2 yx { [MethodImpl(AggressiveInlining)] get => new(y, x); [MethodImpl(AggressiveInlining)] set { y = value.x; x = value.y; } }
    public bool2 yy { [MethodImpl(AggressiveInlining)] get => new(y, y); }
    public bool2 yz { [MethodImpl(AggressiveInlining)] get => new(y, z); [MethodImpl(AggressiveInlining)] set { y = value.x; z = value.y; } }
    public bool2 zx { [MethodImpl(AggressiveInlining)] get => new(z, x); [MethodImpl(AggressiveInlining)] set { z = value.x; x = value.y; } }
    public bool2 zy { [MethodImpl(AggressiveInlining)] get => new(z, y); [MethodImpl(AggressiveInlining)] set { z = value.x; y = value.y; } }
    public bool2 zz { [MethodImpl(AggressiveInlining)] get => new(z, z); }
    public bool3 xxx { [MethodImpl(AggressiveInlining)] get => new(x, x, x); }
    public bool3 xxy { [MethodImpl(AggressiveInlining)] get => new(x, x, y); }
    public bool3 xxz { [MethodImpl(AggressiveInlining)] get => new(x, x, z); }
    public bool3 xyx { [MethodImpl(AggressiveInlining)] get => new(x, y, x); }
    public bool3 xyy { [MethodImpl(AggressiveInlining)] get => new(x, y, y); }
    public bool3 xyz { [MethodImpl(AggressiveInlining)] get => new(x, y, z); [MethodImpl(AggressiveInlining)] set { x = value.x; y = value.y; z = value.z; } }
    public bool3 xzx { [MethodImpl(AggressiveInlining)] get => new(x, z, x); }
    public bool3 xzy { [MethodImpl(AggressiveInlining)] get => new(x, z, y); [MethodImpl(AggressiveInlining)] set { x = value.x; z = value.y; y = value.z; } }
    public bool3 xzz { [MethodImpl(AggressiveInlining)] get => new(x, z, z); }
    public bool3 yxx { [MethodImpl(AggressiveInlining)] get => new(y, x, x); }
    public bool3 yxy { [MethodImpl(AggressiveInlining)] get => new(y, x, y); }
    public bool3 yxz { [MethodImpl(AggressiveInlining)] get => new(y, x, z); [MethodImpl(AggressiveInlining)] set { y = value.x; x = value.y; z = value.z; } }
    public bool3 yyx { [MethodImpl(AggressiveInlining)] get => new(y, y, x); }
    public bool3 yyy { [MethodImpl(AggressiveInlining)] get => new(y, y, y); }
    public bool3 yyz { [MethodImpl(AggressiveInlining)] get => new(y, y, z); }
    public bool3 yzx { [MethodImpl(AggressiveInlining)] get => new(y, z, x); [MethodImpl(AggressiveInlining)] set { y = value.x; z = value.y; x = value.z; } }
    public bool3 yzy { [MethodImpl(AggressiveInlining)] get => new(y, z, y); }
    public bool3 yzz { [MethodImpl(AggressiveInlining)] get => new(y, z, z); }
    public bool3 zxx { [MethodImpl(AggressiveInlining)] get => new(z, x, x); }
    public bool3 zxy { [MethodImpl(AggressiveInlining)] get => new(z, x, y); [MethodImpl(AggressiveInlining)] set { z = value.x; x = value.y; y = value.z; } }
    public bool3 zxz { [MethodImpl(AggressiveInlining)] get => new(z, x, z); }
    public bool3 zyx { [MethodImpl(AggressiveInlining)] get => new(z, y, x); [MethodImpl(AggressiveInlining)] set { z = value.x; y = value.y; x = value.z; } }
    public bool3 zyy { [MethodImpl(AggressiveInlining)] get => new(z, y, y); }
    public bool3 zyz { [MethodImpl(AggressiveInlining)] get => new(z, y, z); }
    public bool3 zzx { [MethodImpl(AggressiveInlining)] get => new(z, z, x); }
    public bool3 zzy { [MethodImpl(AggressiveInlining)] get => new(z, z, y); }
    public bool3 zzz { [MethodImpl(AggressiveInlining)] get => new(z, z, z); }
}
