using System;
using Glint.Host;

namespace UnityEngine;

/// <summary>The points p with normal . p + distance = 0.</summary>
public struct Plane : IFormattable
{
    Vector3 m_Normal;
    float m_Distance;

    public Plane(Vector3 inNormal, Vector3 inPoint)
    {
        m_Normal = inNormal.normalized;
        m_Distance = -Vector3.Dot(m_Normal, inPoint);
    }

    public Plane(Vector3 inNormal, float d)
    {
        m_Normal = inNormal.normalized;
        m_Distance = d;
    }

    /// <summary>The points are clockwise seen from the side of the normal.</summary>
    public Plane(Vector3 a, Vector3 b, Vector3 c) : this(Vector3.Cross(b - a, c - a), a)
    {
    }

    public Vector3 normal { get => m_Normal; set => m_Normal = value; }
    public float distance { get => m_Distance; set => m_Distance = value; }
    public Plane flipped => new(-m_Normal, -m_Distance);

    public void SetNormalAndPosition(Vector3 inNormal, Vector3 inPoint) => this = new Plane(inNormal, inPoint);
    public void Set3Points(Vector3 a, Vector3 b, Vector3 c) => this = new Plane(a, b, c);
    public void Flip() => this = flipped;
    public void Translate(Vector3 translation) => this = Translate(this, translation);

    public static Plane Translate(Plane plane, Vector3 translation)
    {
        plane.m_Distance -= Vector3.Dot(plane.m_Normal, translation);
        return plane;
    }

    public Vector3 ClosestPointOnPlane(Vector3 point) => point - m_Normal * GetDistanceToPoint(point);
    public float GetDistanceToPoint(Vector3 point) => Vector3.Dot(m_Normal, point) + m_Distance;
    public bool GetSide(Vector3 point) => GetDistanceToPoint(point) > 0f;
    public bool SameSide(Vector3 inPt0, Vector3 inPt1) => GetSide(inPt0) == GetSide(inPt1);

    /// <summary>
    /// If the plane is behind the ray, enter is negative and the result false; 0 if the ray is parallel to it.
    /// </summary>
    public bool Raycast(Ray ray, out float enter)
    {
        float slope = Vector3.Dot(ray.direction, m_Normal);
        enter = Mathf.Approximately(slope, 0f) ? 0f : -GetDistanceToPoint(ray.origin) / slope;
        return enter > 0f;
    }

    public override string ToString() => ToString(null, null);
    public string ToString(string format) => ToString(format, null);

    public string ToString(string format, IFormatProvider formatProvider)
    {
        return $"(normal:{m_Normal.ToString(format, formatProvider)}, "
            + $"distance:{FloatFormat.Text(m_Distance, format, formatProvider, "F2")})";
    }
}
