using System;
using Glint.Host;

namespace UnityEngine;

[Serializable]
public struct Vector3 : IEquatable<Vector3>, IFormattable
{
    public const float kEpsilon = 1E-05f;
    public const float kEpsilonNormalSqrt = 1E-15f;
    public float x;
    public float y;
    public float z;

    public Vector3(float x, float y, float z)
    {
        this.x = x;
        this.y = y;
        this.z = z;
    }

    public Vector3(float x, float y) : this(x, y, 0f)
    {
    }

    public float this[int index]
    {
        get =>
            index switch { 0 => x, 1 => y, 2 => z, _ => throw new IndexOutOfRangeException("Invalid Vector3 index!") };
        set
        {
            switch (index)
            {
                case 0: x = value; break;
                case 1: y = value; break;
                case 2: z = value; break;
                default: throw new IndexOutOfRangeException("Invalid Vector3 index!");
            }
        }
    }

    public static Vector3 zero => default;
    public static Vector3 one => new(1f, 1f, 1f);
    public static Vector3 forward => new(0f, 0f, 1f);
    public static Vector3 back => new(0f, 0f, -1f);
    public static Vector3 up => new(0f, 1f, 0f);
    public static Vector3 down => new(0f, -1f, 0f);
    public static Vector3 left => new(-1f, 0f, 0f);
    public static Vector3 right => new(1f, 0f, 0f);
    public static Vector3 positiveInfinity =>
        new(float.PositiveInfinity, float.PositiveInfinity, float.PositiveInfinity);
    public static Vector3 negativeInfinity =>
        new(float.NegativeInfinity, float.NegativeInfinity, float.NegativeInfinity);

    public float magnitude => (float)Math.Sqrt(sqrMagnitude);
    public float sqrMagnitude => x * x + y * y + z * z;
    public Vector3 normalized => Normalize(this);

    public void Set(float newX, float newY, float newZ) => this = new Vector3(newX, newY, newZ);
    public void Normalize() => this = Normalize(this);
    public void Scale(Vector3 scale) => this = Scale(this, scale);

    /// <summary>Zero for vectors shorter than 1e-5.</summary>
    public static Vector3 Normalize(Vector3 value)
    {
        float length = value.magnitude;
        return length > kEpsilon ? value / length : zero;
    }

    public static Vector3 Lerp(Vector3 a, Vector3 b, float t) => LerpUnclamped(a, b, Mathf.Clamp01(t));

    public static Vector3 LerpUnclamped(Vector3 a, Vector3 b, float t)
    {
        return new Vector3(a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.z + (b.z - a.z) * t);
    }

    public static Vector3 Slerp(Vector3 a, Vector3 b, float t) => SlerpUnclamped(a, b, Mathf.Clamp01(t));

    /// <summary>Rotates the direction along the great circle and interpolates the length linearly.</summary>
    public static Vector3 SlerpUnclamped(Vector3 a, Vector3 b, float t)
    {
        float lengthA = a.magnitude, lengthB = b.magnitude;
        if (lengthA < kEpsilon || lengthB < kEpsilon)
            return LerpUnclamped(a, b, t);
        Vector3 from = a / lengthA, to = b / lengthB;
        float dot = Dot(from, to);
        float length = Mathf.LerpUnclamped(lengthA, lengthB, t);
        if (dot > 1f - kEpsilon)
            return LerpUnclamped(a, b, t);
        Vector3 axis = dot < -1f + kEpsilon ? AnyPerpendicular(from) : Cross(from, to).normalized;
        float angle = Mathf.Acos(Mathf.Clamp(dot, -1f, 1f)) * t;
        return (from * Mathf.Cos(angle) + Cross(axis, from) * Mathf.Sin(angle)) * length;
    }

    public static Vector3 RotateTowards(Vector3 current, Vector3 target, float maxRadiansDelta, float maxMagnitudeDelta)
    {
        float length = Mathf.MoveTowards(current.magnitude, target.magnitude, maxMagnitudeDelta);
        float angle = Angle(current, target) * Mathf.Deg2Rad;
        if (angle == 0f)
            return target.normalized * length;
        return Slerp(current.normalized, target.normalized, maxRadiansDelta / angle).normalized * length;
    }

    public static Vector3 MoveTowards(Vector3 current, Vector3 target, float maxDistanceDelta)
    {
        Vector3 way = target - current;
        float distance = way.magnitude;
        bool arrives = distance == 0f || (maxDistanceDelta >= 0f && distance <= maxDistanceDelta);
        return arrives ? target : current + way / distance * maxDistanceDelta;
    }

    public static void OrthoNormalize(ref Vector3 normal, ref Vector3 tangent)
    {
        normal = normal.magnitude > kEpsilon ? normal.normalized : right;
        Vector3 rest = tangent - Dot(normal, tangent) * normal;
        tangent = rest.magnitude > kEpsilon ? rest.normalized : AnyPerpendicular(normal);
    }

    public static Vector3 Scale(Vector3 a, Vector3 b) => new(a.x * b.x, a.y * b.y, a.z * b.z);

    public static Vector3 Cross(Vector3 lhs, Vector3 rhs)
    {
        return new Vector3(lhs.y * rhs.z - lhs.z * rhs.y, lhs.z * rhs.x - lhs.x * rhs.z, lhs.x * rhs.y - lhs.y * rhs.x);
    }

    public static float Dot(Vector3 lhs, Vector3 rhs) => lhs.x * rhs.x + lhs.y * rhs.y + lhs.z * rhs.z;
    public static Vector3 Reflect(Vector3 inDirection, Vector3 inNormal) =>
        inDirection - 2f * Dot(inNormal, inDirection) * inNormal;

    public static Vector3 Project(Vector3 vector, Vector3 onNormal)
    {
        float square = Dot(onNormal, onNormal);
        return square < Mathf.Epsilon ? zero : onNormal * (Dot(vector, onNormal) / square);
    }

    public static Vector3 ProjectOnPlane(Vector3 vector, Vector3 planeNormal) => vector - Project(vector, planeNormal);

    public static float Angle(Vector3 from, Vector3 to)
    {
        float lengths = (float)Math.Sqrt(from.sqrMagnitude * to.sqrMagnitude);
        return lengths < kEpsilonNormalSqrt
            ? 0f
            : Mathf.Acos(Mathf.Clamp(Dot(from, to) / lengths, -1f, 1f)) * Mathf.Rad2Deg;
    }

    public static float SignedAngle(Vector3 from, Vector3 to, Vector3 axis) =>
        Angle(from, to) * Mathf.Sign(Dot(axis, Cross(from, to)));
    public static float Distance(Vector3 a, Vector3 b) => (a - b).magnitude;

    public static Vector3 ClampMagnitude(Vector3 vector, float maxLength)
    {
        return vector.sqrMagnitude > maxLength * maxLength ? vector / vector.magnitude * maxLength : vector;
    }

    public static float Magnitude(Vector3 vector) => vector.magnitude;
    public static float SqrMagnitude(Vector3 vector) => vector.sqrMagnitude;

    public static Vector3 Min(Vector3 lhs, Vector3 rhs)
    {
        return new Vector3(Mathf.Min(lhs.x, rhs.x), Mathf.Min(lhs.y, rhs.y), Mathf.Min(lhs.z, rhs.z));
    }

    public static Vector3 Max(Vector3 lhs, Vector3 rhs)
    {
        return new Vector3(Mathf.Max(lhs.x, rhs.x), Mathf.Max(lhs.y, rhs.y), Mathf.Max(lhs.z, rhs.z));
    }

    public static Vector3 operator +(Vector3 a, Vector3 b) => new(a.x + b.x, a.y + b.y, a.z + b.z);
    public static Vector3 operator -(Vector3 a, Vector3 b) => new(a.x - b.x, a.y - b.y, a.z - b.z);
    public static Vector3 operator -(Vector3 a) => new(-a.x, -a.y, -a.z);
    public static Vector3 operator *(Vector3 a, float d) => new(a.x * d, a.y * d, a.z * d);
    public static Vector3 operator *(float d, Vector3 a) => new(a.x * d, a.y * d, a.z * d);
    public static Vector3 operator /(Vector3 a, float d) => new(a.x / d, a.y / d, a.z / d);
    public static bool operator ==(Vector3 lhs, Vector3 rhs) => (lhs - rhs).sqrMagnitude < kEpsilon * kEpsilon;
    public static bool operator !=(Vector3 lhs, Vector3 rhs) => !(lhs == rhs);

    public override int GetHashCode() => x.GetHashCode() ^ (y.GetHashCode() << 2) ^ (z.GetHashCode() >> 2);
    public override bool Equals(object other) => other is Vector3 v && Equals(v);
    public bool Equals(Vector3 other) => x == other.x && y == other.y && z == other.z;
    public override string ToString() => ToString(null, null);
    public string ToString(string format) => ToString(format, null);
    public string ToString(string format, IFormatProvider formatProvider) =>
        FloatFormat.Tuple(format, formatProvider, "F2", x, y, z);

    internal static Vector3 AnyPerpendicular(Vector3 unit)
    {
        return Mathf.Abs(unit.z) > 0.7f
            ? Normalize(new Vector3(0f, -unit.z, unit.y))
            : Normalize(new Vector3(-unit.y, unit.x, 0f));
    }
}
