namespace UnityEngine;

/// <summary>The host has no window; Unity in batch mode returns this size too.</summary>
public sealed class Screen
{
    public static int width => 640;

    public static int height => 480;
}
