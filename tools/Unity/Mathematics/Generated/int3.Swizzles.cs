// Written by generate.py.
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

public partial struct int3
{
    public int2 xx { [MethodImpl(AggressiveInlining)] get => new(x, x); }
    public int2 xy { [MethodImpl(AggressiveInlining)] get => new(x, y); [MethodImpl(AggressiveInlining)] set { x = value.x; y = value.y; } }
    public int2 xz { [MethodImpl(AggressiveInlining)] get => new(x, z); [MethodImpl(AggressiveInlining)] set { x = value.x; z = value.y; } }
    public int2 yx { [MethodImpl(AggressiveInlining)] get => new(y, x); [MethodImpl(AggressiveInlining)] set { y = value.x; x = value.y; } }
    public int2 yy { [MethodImpl(AggressiveInlining)] get => new(y, y); }
    public int2 yz { [MethodImpl(AggressiveInlining)] get => new(y, z); [MethodImpl(AggressiveInlining)] set { y = value.x; z = value.y; } }
    public int2 zx { [MethodImpl(AggressiveInlining)] get => new(z, x); [MethodImpl(AggressiveInlining)] set { z = value.x; x = value.y; } }
    public int2 zy { [MethodImpl(AggressiveInlining)] get => new(z, y); [MethodImpl(AggressiveInlining)] set { z = value.x; y = value.y; } }
    public int2 zz { [MethodImpl(AggressiveInlining)] get => new(z, z); }
    public int3 xxx { [MethodImpl(AggressiveInlining)] get => new(x, x, x); }
    public int3 xxy { [MethodImpl(AggressiveInlining)] get => new(x, x, y); }
    public int3 xxz { [MethodImpl(AggressiveInlining)] get => new(x, x, z); }
    public int3 xyx { [MethodImpl(AggressiveInlining)] get => new(x, y, x); }
    public int3 xyy { [MethodImpl(AggressiveInlining)] get => new(x, y, y); }
    public int3 xyz { [MethodImpl(AggressiveInlining)] get => new(x, y, z); [MethodImpl(AggressiveInlining)] set { x = value.x; y = value.y; z = value.z; } }
    public int3 xzx { [MethodImpl(AggressiveInlining)] get => new(x, z, x); }
    public int3 xzy { [MethodImpl(AggressiveInlining)] get => new(x, z, y); [MethodImpl(AggressiveInlining)] set { x = value.x; z = value.y; y = value.z; } }
    public int3 xzz { [MethodImpl(AggressiveInlining)] get => new(x, z, z); }
    public int3 yxx { [MethodImpl(AggressiveInlining)] get => new(y, x, x); }
    public int3 yxy { [MethodImpl(AggressiveInlining)] get => new(y, x, y); }
    public int3 yxz { [MethodImpl(AggressiveInlining)] get => new(y, x, z); [MethodImpl(AggressiveInlining)] set { y = value.x; x = value.y; z = value.z; } }
    public int3 yyx { [MethodImpl(AggressiveInlining)] get => new(y, y, x); }
    public int3 yyy { [MethodImpl(AggressiveInlining)] get => new(y, y, y); }
    public int3 yyz { [MethodImpl(AggressiveInlining)] get => new(y, y, z); }
    public int3 yzx { [MethodImpl(AggressiveInlining)] get => new(y, z, x); [MethodImpl(AggressiveInlining)] set { y = value.x; z = value.y; x = value.z; } }
    public int3 yzy { [MethodImpl(AggressiveInlining)] get => new(y, z, y); }
    public int3 yzz { [MethodImpl(AggressiveInlining)] get => new(y, z, z); }
    public int3 zxx { [MethodImpl(AggressiveInlining)] get => new(z, x, x); }
    public int3 zxy { [MethodImpl(AggressiveInlining)] get => new(z, x, y); [MethodImpl(AggressiveInlining)] set { z = value.x; x = value.y; y = value.z; } }
    public int3 zxz { [MethodImpl(AggressiveInlining)] get => new(z, x, z); }
    public int3 zyx { [MethodImpl(AggressiveInlining)] get => new(z, y, x); [MethodImpl(AggressiveInlining)] set { z = value.x; y = value.y; x = value.z; } }
    public int3 zyy { [MethodImpl(AggressiveInlining)] get => new(z, y, y); }
    public int3 zyz { [MethodImpl(AggressiveInlining)] get => new(z, y, z); }
    public int3 zzx { [MethodImpl(AggressiveInlining)] get => new(z, z, x); }
    public int3 zzy { [MethodImpl(AggressiveInlining)] get => new(z, z, y); }
    public int3 zzz { [MethodImpl(AggressiveInlining)] get => new(z, z, z); }
}
