using System;

namespace UnityEngine;

[Serializable]
public struct Bounds : IEquatable<Bounds>, IFormattable
{
    Vector3 m_Center;
    Vector3 m_Extents;

    public Bounds(Vector3 center, Vector3 size)
    {
        m_Center = center;
        m_Extents = size * 0.5f;
    }

    public Vector3 center { get => m_Center; set => m_Center = value; }
    public Vector3 size { get => m_Extents * 2f; set => m_Extents = value * 0.5f; }
    public Vector3 extents { get => m_Extents; set => m_Extents = value; }
    public Vector3 min { get => center - extents; set => SetMinMax(value, max); }
    public Vector3 max { get => center + extents; set => SetMinMax(min, value); }

    public void SetMinMax(Vector3 min, Vector3 max)
    {
        extents = (max - min) * 0.5f;
        center = min + extents;
    }

    public void Encapsulate(Vector3 point) => SetMinMax(Vector3.Min(min, point), Vector3.Max(max, point));

    public void Encapsulate(Bounds bounds)
    {
        Encapsulate(bounds.center - bounds.extents);
        Encapsulate(bounds.center + bounds.extents);
    }

    public void Expand(float amount) => Expand(new Vector3(amount, amount, amount));
    public void Expand(Vector3 amount) => extents += amount * 0.5f;

    public bool Intersects(Bounds bounds)
    {
        Vector3 low = min, high = max, otherLow = bounds.min, otherHigh = bounds.max;
        return low.x <= otherHigh.x && high.x >= otherLow.x
            && low.y <= otherHigh.y && high.y >= otherLow.y
            && low.z <= otherHigh.z && high.z >= otherLow.z;
    }

    public bool IntersectRay(Ray ray) => IntersectRay(ray, out _);

    /// <summary>The distance at which the ray's line enters; negative when the ray starts inside.</summary>
    public bool IntersectRay(Ray ray, out float distance)
    {
        float enter = float.NegativeInfinity, leave = float.PositiveInfinity;
        Vector3 low = min, high = max;
        for (int axis = 0; axis < 3; axis++)
        {
            float start = ray.origin[axis], step = ray.direction[axis];
            if (step == 0f)
            {
                if (start < low[axis] || start > high[axis])
                    leave = float.NegativeInfinity;
                continue;
            }
            float a = (low[axis] - start) / step, b = (high[axis] - start) / step;
            enter = Mathf.Max(enter, Mathf.Min(a, b));
            leave = Mathf.Min(leave, Mathf.Max(a, b));
        }
        bool hit = enter <= leave && leave >= 0f;
        distance = hit ? enter : 0f;
        return hit;
    }

    public bool Contains(Vector3 point)
    {
        Vector3 low = min, high = max;
        return point.x >= low.x && point.x <= high.x
            && point.y >= low.y && point.y <= high.y
            && point.z >= low.z && point.z <= high.z;
    }

    public float SqrDistance(Vector3 point) => (ClosestPoint(point) - point).sqrMagnitude;
    public Vector3 ClosestPoint(Vector3 point) => Vector3.Min(Vector3.Max(point, min), max);

    public static bool operator ==(Bounds lhs, Bounds rhs) => lhs.center == rhs.center && lhs.extents == rhs.extents;
    public static bool operator !=(Bounds lhs, Bounds rhs) => !(lhs == rhs);

    public override int GetHashCode() => center.GetHashCode() ^ (extents.GetHashCode() << 2);
    public override bool Equals(object other) => other is Bounds b && Equals(b);
    public bool Equals(Bounds other) => center.Equals(other.center) && extents.Equals(other.extents);
    public override string ToString() => ToString(null, null);
    public string ToString(string format) => ToString(format, null);

    public string ToString(string format, IFormatProvider formatProvider)
    {
        return "Center: " + center.ToString(format, formatProvider) + ", Extents: "
            + extents.ToString(format, formatProvider);
    }
}
