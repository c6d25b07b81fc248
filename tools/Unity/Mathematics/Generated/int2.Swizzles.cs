// Written by generate.py.
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

public partial struct int2
{
    public int2 xx { [MethodImpl(AggressiveInlining)] get => new(x, x); }
    public int2 xy { [MethodImpl(AggressiveInlining)] get => new(x, y); [MethodImpl(AggressiveInlining)] set { x = value.x; y = value.y; } }
    public int2 yx { [MethodImpl(AggressiveInlining)] get => new(y, x); [MethodImpl(AggressiveInlining)] set { y = value.x; x = value.y; } }
    public int2 yy { [MethodImpl(AggressiveInlining)] get => new(y, y); }
    public int3 xxx { [MethodImpl(AggressiveInlining)] get => new(x, x, x); }
    public int3 xxy { [MethodImpl(AggressiveInlining)] get => new(x, x, y); }
    public int3 xyx { [MethodImpl(AggressiveInlining)] get => new(x, y, x); }
    public int3 xyy { [MethodImpl(AggressiveInlining)] get => new(x, y, y); }
    public int3 yxx { [MethodImpl(AggressiveInlining)] get => new(y, x, x); }
    public int3 yxy { [MethodImpl(AggressiveInlining)] get => new(y, x, y); }
    public int3 yyx { [MethodImpl(AggressiveInlining)] get => new(y, y, x); }
    public int3 yyy { [MethodImpl(AggressiveInlining)] get => new(y, y, y); }
}
