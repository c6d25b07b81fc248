namespace UnityEngine;

/// <summary>There is no window; Unity in batch mode says this size too.</summary>
public sealed class Screen
{
    public static int width => 640;

    public static int height => 480;
}
