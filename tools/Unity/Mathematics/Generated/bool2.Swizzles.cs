// Written by generate.py.
using System.Runtime.CompilerServices;
using static System.Runtime.CompilerServices.MethodImplOptions;

namespace Unity.Mathematics;

public partial struct bool2
{
    public bool2 xx { [MethodImpl(AggressiveInlining)] get => new(x, x); }
    public bool2 xy { [MethodImpl(AggressiveInlining)] get => new(x, y); [MethodImpl(AggressiveInlining)] set { x = value.x; y = value.y; } }
    public bool2 yx { [MethodImpl(AggressiveInlining)] get => new(y, x); [MethodImpl(AggressiveInlining)] set { y = value.x; x = value.y; } }
    public bool2 yy { [MethodImpl(AggressiveInlining)] get => new(y, y); }
    public bool3 xxx { [MethodImpl(AggressiveInlining)] get => new(x, x, x); }
    public bool3 xxy { [MethodImpl(AggressiveInlining)] get => new(x, x, y); }
    public bool3 xyx { [MethodImpl(AggressiveInlining)] get => new(x, y, x); }
    public bool3 xyy { [MethodImpl(AggressiveInlining)] get => new(x, y, y); }
    public bool3 yxx { [MethodImpl(AggressiveInlining)] get => new(y, x, x); }
    public bool3 yxy { [MethodImpl(AggressiveInlining)] get => new(y, x, y); }
    public bool3 yyx { [MethodImpl(AggressiveInlining)] get => new(y, y, x); }
    public bool3 yyy { [MethodImpl(AggressiveInlining)] get => new(y, y, y); }
}
