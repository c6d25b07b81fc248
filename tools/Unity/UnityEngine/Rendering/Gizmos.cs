using System;

namespace UnityEngine;

/// <summary>Without effect in the host, which has no view.</summary>
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
