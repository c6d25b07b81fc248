// Written by generate.py.
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

public partial struct double2
{
    public double2 xx { [MethodImpl(AggressiveInlining)] get => new(x, x); }
    public double2 xy { [MethodImpl(AggressiveInlining)] get => new(x, y); [MethodImpl(AggressiveInlining)] set { x = value.x; y = value.y; } }
    public double2 yx { [MethodImpl(AggressiveInlining)] get => new(y, x); [MethodImpl(AggressiveInlining)] set { y = value.x; x = value.y; } }
    public double2 yy { [MethodImpl(AggressiveInlining)] get => new(y, y); }
    public double3 xxx { [MethodImpl(AggressiveInlining)] get => new(x, x, x); }
    public double3 xxy { [MethodImpl(AggressiveInlining)] get => new(x, x, y); }
    public double3 xyx { [MethodImpl(AggressiveInlining)] get => new(x, y, x); }
    public double3 xyy { [MethodImpl(AggressiveInlining)] get => new(x, y, y); }
    public double3 yxx { [MethodImpl(AggressiveInlining)] get => new(y, x, x); }
    public double3 yxy { [MethodImpl(AggressiveInlining)] get => new(y, x, y); }
    public double3 yyx { [MethodImpl(AggressiveInlining)] get => new(y, y, x); }
    public double3 yyy { [MethodImpl(AggressiveInlining)] get => new(y, y, y); }
}
