using System;
using Glint.Host;

namespace UnityEngine;

[Serializable]
public struct Vector2 : IEquatable<Vector2>, IFormattable
{
    public float x;
    public float y;
    public const float kEpsilon = 1E-05f;
    public const float kEpsilonNormalSqrt = 1E-15f;

    public Vector2(float x, float y)
    {
        this.x = x;
        this.y = y;
    }

    public float this[int index]
    {
        get => index switch { 0 => x, 1 => y, _ => throw new IndexOutOfRangeException("Invalid Vector2 index!") };
        set
        {
            switch (index)
            {
                case 0: x = value; break;
                case 1: y = value; break;
                default: throw new IndexOutOfRangeException("Invalid Vector2 index!");
            }
        }
    }

    public static Vector2 zero => default;
    public static Vector2 one => new(1f, 1f);
    public static Vector2 up => new(0f, 1f);
    public static Vector2 down => new(0f, -1f);
    public static Vector2 left => new(-1f, 0f);
    public static Vector2 right => new(1f, 0f);
    public static Vector2 positiveInfinity => new(float.PositiveInfinity, float.PositiveInfinity);
    public static Vector2 negativeInfinity => new(float.NegativeInfinity, float.NegativeInfinity);

    public float magnitude => (float)Math.Sqrt(sqrMagnitude);
    public float sqrMagnitude => x * x + y * y;
    public Vector2 normalized
    {
        get
        {
            float length = magnitude;
            return length > kEpsilon ? this / length : zero;
        }
    }

    public void Set(float newX, float newY) => this = new Vector2(newX, newY);
    public void Normalize() => this = normalized;
    public void Scale(Vector2 scale) => this = Scale(this, scale);
    public float SqrMagnitude() => sqrMagnitude;

    public static Vector2 Lerp(Vector2 a, Vector2 b, float t) => LerpUnclamped(a, b, Mathf.Clamp01(t));
    public static Vector2 LerpUnclamped(Vector2 a, Vector2 b, float t) =>
        new(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t);
    public static Vector2 Scale(Vector2 a, Vector2 b) => new(a.x * b.x, a.y * b.y);
    public static Vector2 Reflect(Vector2 inDirection, Vector2 inNormal) =>
        inDirection - 2f * Dot(inNormal, inDirection) * inNormal;
    public static Vector2 Perpendicular(Vector2 inDirection) => new(-inDirection.y, inDirection.x);
    public static float Dot(Vector2 lhs, Vector2 rhs) => lhs.x * rhs.x + lhs.y * rhs.y;
    public static float Distance(Vector2 a, Vector2 b) => (a - b).magnitude;
    public static float SqrMagnitude(Vector2 a) => a.sqrMagnitude;
    public static Vector2 Min(Vector2 lhs, Vector2 rhs) => new(Mathf.Min(lhs.x, rhs.x), Mathf.Min(lhs.y, rhs.y));
    public static Vector2 Max(Vector2 lhs, Vector2 rhs) => new(Mathf.Max(lhs.x, rhs.x), Mathf.Max(lhs.y, rhs.y));

    public static Vector2 MoveTowards(Vector2 current, Vector2 target, float maxDistanceDelta)
    {
        Vector2 way = target - current;
        float distance = way.magnitude;
        bool arrives = distance == 0f || (maxDistanceDelta >= 0f && distance <= maxDistanceDelta);
        return arrives ? target : current + way / distance * maxDistanceDelta;
    }

    public static Vector2 ClampMagnitude(Vector2 vector, float maxLength)
    {
        return vector.sqrMagnitude > maxLength * maxLength ? vector / vector.magnitude * maxLength : vector;
    }

    public static float Angle(Vector2 from, Vector2 to)
    {
        float lengths = (float)Math.Sqrt(from.sqrMagnitude * to.sqrMagnitude);
        return lengths < kEpsilonNormalSqrt
            ? 0f
            : Mathf.Acos(Mathf.Clamp(Dot(from, to) / lengths, -1f, 1f)) * Mathf.Rad2Deg;
    }

    /// <summary>Positive counter-clockwise, degrees.</summary>
    public static float SignedAngle(Vector2 from, Vector2 to)
    {
        return Angle(from, to) * Mathf.Sign(from.x * to.y - from.y * to.x);
    }

    public static Vector2 operator +(Vector2 a, Vector2 b) => new(a.x + b.x, a.y + b.y);
    public static Vector2 operator -(Vector2 a, Vector2 b) => new(a.x - b.x, a.y - b.y);
    public static Vector2 operator *(Vector2 a, Vector2 b) => new(a.x * b.x, a.y * b.y);
    public static Vector2 operator /(Vector2 a, Vector2 b) => new(a.x / b.x, a.y / b.y);
    public static Vector2 operator -(Vector2 a) => new(-a.x, -a.y);
    public static Vector2 operator *(Vector2 a, float d) => new(a.x * d, a.y * d);
    public static Vector2 operator *(float d, Vector2 a) => new(a.x * d, a.y * d);
    public static Vector2 operator /(Vector2 a, float d) => new(a.x / d, a.y / d);
    public static bool operator ==(Vector2 lhs, Vector2 rhs) => (lhs - rhs).sqrMagnitude < kEpsilon * kEpsilon;
    public static bool operator !=(Vector2 lhs, Vector2 rhs) => !(lhs == rhs);
    public static implicit operator Vector2(Vector3 v) => new(v.x, v.y);
    public static implicit operator Vector3(Vector2 v) => new(v.x, v.y, 0f);

    public override int GetHashCode() => x.GetHashCode() ^ (y.GetHashCode() << 2);
    public override bool Equals(object other) => other is Vector2 v && Equals(v);
    public bool Equals(Vector2 other) => x == other.x && y == other.y;
    public override string ToString() => ToString(null, null);
    public string ToString(string format) => ToString(format, null);
    public string ToString(string format, IFormatProvider formatProvider) =>
        FloatFormat.Tuple(format, formatProvider, "F2", x, y);
}
