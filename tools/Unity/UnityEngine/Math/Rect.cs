using System;
using Glint.Host;

namespace UnityEngine;

[Serializable]
public struct Rect : IEquatable<Rect>, IFormattable
{
    float m_XMin;
    float m_YMin;
    float m_Width;
    float m_Height;

    public Rect(float x, float y, float width, float height)
    {
        m_XMin = x;
        m_YMin = y;
        m_Width = width;
        m_Height = height;
    }

    public Rect(Vector2 position, Vector2 size) : this(position.x, position.y, size.x, size.y)
    {
    }

    public Rect(Rect source) => this = source;

    public static Rect zero => default;
    public float x { get => m_XMin; set => m_XMin = value; }
    public float y { get => m_YMin; set => m_YMin = value; }
    public float width { get => m_Width; set => m_Width = value; }
    public float height { get => m_Height; set => m_Height = value; }
    public Vector2 position { get => new(x, y); set => this = new Rect(value, size); }
    public Vector2 size { get => new(width, height); set => this = new Rect(position, value); }
    public Vector2 center { get => position + size / 2f; set => position = value - size / 2f; }
    public Vector2 min { get => position; set => this = MinMaxRect(value.x, value.y, xMax, yMax); }
    public Vector2 max { get => new(xMax, yMax); set => this = MinMaxRect(x, y, value.x, value.y); }
    public float xMin { get => x; set => this = MinMaxRect(value, yMin, xMax, yMax); }
    public float yMin { get => y; set => this = MinMaxRect(xMin, value, xMax, yMax); }
    public float xMax { get => x + width; set => width = value - x; }
    public float yMax { get => y + height; set => height = value - y; }

    public static Rect MinMaxRect(float xmin, float ymin, float xmax, float ymax) =>
        new(xmin, ymin, xmax - xmin, ymax - ymin);
    public void Set(float x, float y, float width, float height) => this = new Rect(x, y, width, height);

    /// <summary>The far edges are not part of the rectangle.</summary>
    public bool Contains(Vector2 point) => point.x >= xMin && point.x < xMax && point.y >= yMin && point.y < yMax;
    public bool Contains(Vector3 point) => Contains((Vector2)point);
    public bool Overlaps(Rect other) =>
        other.xMax > xMin && other.xMin < xMax && other.yMax > yMin && other.yMin < yMax;

    public static Vector2 NormalizedToPoint(Rect rectangle, Vector2 normalizedRectCoordinates)
    {
        return new Vector2(
            Mathf.Lerp(rectangle.x, rectangle.xMax, normalizedRectCoordinates.x),
            Mathf.Lerp(rectangle.y, rectangle.yMax, normalizedRectCoordinates.y));
    }

    public static Vector2 PointToNormalized(Rect rectangle, Vector2 point)
    {
        return new Vector2(
            Mathf.InverseLerp(rectangle.x, rectangle.xMax, point.x),
            Mathf.InverseLerp(rectangle.y, rectangle.yMax, point.y));
    }

    public static bool operator ==(Rect lhs, Rect rhs) =>
        lhs.x == rhs.x && lhs.y == rhs.y && lhs.width == rhs.width && lhs.height == rhs.height;
    public static bool operator !=(Rect lhs, Rect rhs) => !(lhs == rhs);

    public override int GetHashCode() =>
        x.GetHashCode() ^ (width.GetHashCode() << 2) ^ (y.GetHashCode() >> 2) ^ (height.GetHashCode() >> 1);
    public override bool Equals(object other) => other is Rect r && Equals(r);
    public bool Equals(Rect other) => position.Equals(other.position) && size.Equals(other.size);
    public override string ToString() => ToString(null, null);
    public string ToString(string format) => ToString(format, null);

    public string ToString(string format, IFormatProvider formatProvider)
    {
        return $"(x:{Text(x)}, y:{Text(y)}, width:{Text(width)}, height:{Text(height)})";

        string Text(float value) => FloatFormat.Text(value, format, formatProvider, "F2");
    }
}
