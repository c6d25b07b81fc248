using System;

namespace UnityEngine.UIElements;

public enum ArcDirection
{
    Clockwise,
    CounterClockwise,
}

public enum FillRule
{
    NonZero,
    OddEven,
}

public class MeshGenerationContext
{
    internal MeshGenerationContext()
    {
    }

    public Painter2D painter2D { get; } = new();
}

/// <summary>Counts the shapes instead of drawing them, and records corners that are not numbers.</summary>
public class Painter2D
{
    int _corners;

    public float lineWidth { get; set; }

    public Color strokeColor { get; set; }

    public Color fillColor { get; set; }

    internal int Strokes { get; private set; }

    internal int Fills { get; private set; }

    internal int BadCorners { get; private set; }

    /// <summary>Corners of the longest path that was stroked or filled.</summary>
    internal int LongestPath { get; private set; }

    public void BeginPath() => _corners = 0;

    public void ClosePath()
    {
    }

    public void MoveTo(Vector2 pos) => Note(pos);

    public void LineTo(Vector2 pos) => Note(pos);

    public void Arc(
        Vector2 center, float radius, Angle startAngle, Angle endAngle,
        ArcDirection direction = ArcDirection.Clockwise) => Note(center);

    public void Stroke()
    {
        Strokes++;
        LongestPath = Math.Max(LongestPath, _corners);
    }

    public void Fill(FillRule fillRule = FillRule.NonZero)
    {
        Fills++;
        LongestPath = Math.Max(LongestPath, _corners);
    }

    void Note(Vector2 corner)
    {
        _corners++;
        if (!float.IsFinite(corner.x) || !float.IsFinite(corner.y))
            BadCorners++;
    }
}
