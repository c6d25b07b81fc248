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
    public float lineWidth { get; set; }

    public Color strokeColor { get; set; }

    public Color fillColor { get; set; }

    internal int Strokes { get; private set; }

    internal int Fills { get; private set; }

    internal int BadCorners { get; private set; }

    public void BeginPath()
    {
    }

    public void ClosePath()
    {
    }

    public void MoveTo(Vector2 pos) => Note(pos);

    public void LineTo(Vector2 pos) => Note(pos);

    public void Arc(
        Vector2 center, float radius, Angle startAngle, Angle endAngle,
        ArcDirection direction = ArcDirection.Clockwise) => Note(center);

    public void Stroke() => Strokes++;

    public void Fill(FillRule fillRule = FillRule.NonZero) => Fills++;

    void Note(Vector2 corner)
    {
        if (!float.IsFinite(corner.x) || !float.IsFinite(corner.y))
            BadCorners++;
    }
}
