// Written by generate.py.
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

public partial struct double3
{
    public double2 xx { [MethodImpl(AggressiveInlining)] get => new(x, x); }
    public double2 xy { [MethodImpl(AggressiveInlining)] get => new(x, y); [MethodImpl(AggressiveInlining)] set { x = value.x; y = value.y; } }
    public double2 xz { [MethodImpl(AggressiveInlining)] get => new(x, z); [MethodImpl(AggressiveInlining)] set { x = value.x; z = value.y; } }
    public double2 yx { [MethodImpl(AggressiveInlining)] get => new(y, x); [MethodImpl(AggressiveInlining)] set { y = value.x; x = value.y; } }
    public double2 yy { [MethodImpl(AggressiveInlining)] get => new(y, y); }
    public double2 yz { [MethodImpl(AggressiveInlining)] get => new(y, z); [MethodImpl(AggressiveInlining)] set { y = value.x; z = value.y; } }
    public double2 zx { [MethodImpl(AggressiveInlining)] get => new(z, x); [MethodImpl(AggressiveInlining)] set { z = value.x; x = value.y; } }
    public double2 zy { [MethodImpl(AggressiveInlining)] get => new(z, y); [MethodImpl(AggressiveInlining)] set { z = value.x; y = value.y; } }
    public double2 zz { [MethodImpl(AggressiveInlining)] get => new(z, z); }
    public double3 xxx { [MethodImpl(AggressiveInlining)] get => new(x, x, x); }
    public double3 xxy { [MethodImpl(AggressiveInlining)] get => new(x, x, y); }
    public double3 xxz { [MethodImpl(AggressiveInlining)] get => new(x, x, z); }
    public double3 xyx { [MethodImpl(AggressiveInlining)] get => new(x, y, x); }
    public double3 xyy { [MethodImpl(AggressiveInlining)] get => new(x, y, y); }
    public double3 xyz { [MethodImpl(AggressiveInlining)] get => new(x, y, z); [MethodImpl(AggressiveInlining)] set { x = value.x; y = value.y; z = value.z; } }
    public double3 xzx { [MethodImpl(AggressiveInlining)] get => new(x, z, x); }
    public double3 xzy { [MethodImpl(AggressiveInlining)] get => new(x, z, y); [MethodImpl(AggressiveInlining)] set { x = value.x; z = value.y; y = value.z; } }
    public double3 xzz { [MethodImpl(AggressiveInlining)] get => new(x, z, z); }
    public double3 yxx { [MethodImpl(AggressiveInlining)] get => new(y, x, x); }
    public double3 yxy { [MethodImpl(AggressiveInlining)] get => new(y, x, y); }
    public double3 yxz { [MethodImpl(AggressiveInlining)] get => new(y, x, z); [MethodImpl(AggressiveInlining)] set { y = value.x; x = value.y; z = value.z; } }
    public double3 yyx { [MethodImpl(AggressiveInlining)] get => new(y, y, x); }
    public double3 yyy { [MethodImpl(AggressiveInlining)] get => new(y, y, y); }
    public double3 yyz { [MethodImpl(AggressiveInlining)] get => new(y, y, z); }
    public double3 yzx { [MethodImpl(AggressiveInlining)] get => new(y, z, x); [MethodImpl(AggressiveInlining)] set { y = value.x; z = value.y; x = value.z; } }
    public double3 yzy { [MethodImpl(AggressiveInlining)] get => new(y, z, y); }
    public double3 yzz { [MethodImpl(AggressiveInlining)] get => new(y, z, z); }
    public double3 zxx { [MethodImpl(AggressiveInlining)] get => new(z, x, x); }
    public double3 zxy { [MethodImpl(AggressiveInlining)] get => new(z, x, y); [MethodImpl(AggressiveInlining)] set { z = value.x; x = value.y; y = value.z; } }
    public double3 zxz { [MethodImpl(AggressiveInlining)] get => new(z, x, z); }
    public double3 zyx { [MethodImpl(AggressiveInlining)] get => new(z, y, x); [MethodImpl(AggressiveInlining)] set { z = value.x; y = value.y; x = value.z; } }
    public double3 zyy { [MethodImpl(AggressiveInlining)] get => new(z, y, y); }
    public double3 zyz { [MethodImpl(AggressiveInlining)] get => new(z, y, z); }
    public double3 zzx { [MethodImpl(AggressiveInlining)] get => new(z, z, x); }
    public double3 zzy { [MethodImpl(AggressiveInlining)] get => new(z, z, y); }
    public double3 zzz { [MethodImpl(AggressiveInlining)] get => new(z, z, z); }
}
