using System;

namespace UnityEngine;

/// <summary>There is no view to draw in.</summary>
public sealed class Gizmos
{
    public static Color color { get; set; } = Color.white;

    public static void DrawLineStrip(ReadOnlySpan<Vector3> points, bool looped)
    {
    }

    public static void DrawRay(Vector3 from, Vector3 direction)
    {
    }
}
