using System;
using Glint.Host;

namespace UnityEngine;

[Serializable]
public struct Quaternion : IEquatable<Quaternion>, IFormattable
{
    public float x;
    public float y;
    public float z;
    public float w;
    public const float kEpsilon = 1E-06f;

    public Quaternion(float x, float y, float z, float w)
    {
        this.x = x;
        this.y = y;
        this.z = z;
        this.w = w;
    }

    public float this[int index]
    {
        get => index switch
        {
            0 => x,
            1 => y,
            2 => z,
            3 => w,
            _ => throw new IndexOutOfRangeException("Invalid Quaternion index!")
        };
        set
        {
            switch (index)
            {
                case 0: x = value; break;
                case 1: y = value; break;
                case 2: z = value; break;
                case 3: w = value; break;
                default: throw new IndexOutOfRangeException("Invalid Quaternion index!");
            }
        }
    }

    public static Quaternion identity => new(0f, 0f, 0f, 1f);
    public Quaternion normalized => Normalize(this);
    public Vector3 eulerAngles { get => EulerAngles.From(this); set => this = Euler(value); }

    public void Set(float newX, float newY, float newZ, float newW) => this = new Quaternion(newX, newY, newZ, newW);
    public void Normalize() => this = Normalize(this);
    public void SetLookRotation(Vector3 view) => this = LookRotation(view);
    public void SetLookRotation(Vector3 view, Vector3 up) => this = LookRotation(view, up);
    public void SetFromToRotation(Vector3 fromDirection, Vector3 toDirection) =>
        this = FromToRotation(fromDirection, toDirection);

    /// <summary>Angle in degrees; the axis of no rotation is x.</summary>
    public void ToAngleAxis(out float angle, out Vector3 axis)
    {
        Quaternion q = Normalize(this);
        var imaginary = new Vector3(q.x, q.y, q.z);
        float sine = imaginary.magnitude;
        angle = 2f * Mathf.Atan2(sine, q.w) * Mathf.Rad2Deg;
        axis = sine > 0f ? imaginary / sine : Vector3.right;
    }

    /// <summary>About z, then x, then y, in degrees.</summary>
    public static Quaternion Euler(float x, float y, float z) => EulerAngles.ToQuaternion(x, y, z);
    public static Quaternion Euler(Vector3 euler) => Euler(euler.x, euler.y, euler.z);

    public static Quaternion AngleAxis(float angle, Vector3 axis)
    {
        double length = Math.Sqrt((double)axis.x * axis.x + (double)axis.y * axis.y + (double)axis.z * axis.z);
        if (!(length > 0.0))
            return identity;
        double half = angle * (Math.PI / 360.0);
        double scale = Math.Sin(half) / length;
        return new Quaternion((float)(axis.x * scale), (float)(axis.y * scale),
            (float)(axis.z * scale), (float)Math.Cos(half));
    }

    public static Quaternion LookRotation(Vector3 forward) => LookRotation(forward, Vector3.up);

    /// <summary>Rotates +z to forward and +y as close to upwards as possible.</summary>
    public static Quaternion LookRotation(Vector3 forward, Vector3 upwards)
    {
        Vector3 ahead = forward.normalized;
        if (ahead == Vector3.zero)
        {
            Debug.Log("Look rotation viewing vector is zero");
            return identity;
        }
        Vector3 side = Vector3.Cross(upwards.normalized, ahead);
        if (side.magnitude < Vector3.kEpsilon)
            return FromToRotation(Vector3.forward, ahead);
        side = side.normalized;
        return RotationMatrix.ToQuaternion(side, Vector3.Cross(ahead, side), ahead);
    }

    public static Quaternion FromToRotation(Vector3 fromDirection, Vector3 toDirection)
    {
        Vector3 from = fromDirection.normalized, to = toDirection.normalized;
        if (from == Vector3.zero || to == Vector3.zero)
            return identity;
        float dot = Vector3.Dot(from, to);
        if (dot < -1f + kEpsilon)
            return AngleAxis(180f, Vector3.AnyPerpendicular(from));
        Vector3 cross = Vector3.Cross(from, to);
        return Normalize(new Quaternion(cross.x, cross.y, cross.z, 1f + dot));
    }

    /// <summary>The conjugate, which is exact for unit quaternions.</summary>
    public static Quaternion Inverse(Quaternion rotation) => new(-rotation.x, -rotation.y, -rotation.z, rotation.w);

    public static Quaternion Slerp(Quaternion a, Quaternion b, float t) => SlerpUnclamped(a, b, Mathf.Clamp01(t));

    public static Quaternion SlerpUnclamped(Quaternion a, Quaternion b, float t)
    {
        float dot = Dot(a, b);
        float side = dot < 0f ? -1f : 1f;
        dot *= side;
        if (dot > 0.9995f)
            return LerpUnclamped(a, b, t);
        float angle = Mathf.Acos(dot);
        float sine = Mathf.Sin(angle);
        return Blend(a, Mathf.Sin((1f - t) * angle) / sine, b, side * Mathf.Sin(t * angle) / sine);
    }

    public static Quaternion Lerp(Quaternion a, Quaternion b, float t) => LerpUnclamped(a, b, Mathf.Clamp01(t));

    public static Quaternion LerpUnclamped(Quaternion a, Quaternion b, float t)
    {
        return Normalize(Blend(a, 1f - t, b, Dot(a, b) < 0f ? -t : t));
    }

    public static Quaternion RotateTowards(Quaternion from, Quaternion to, float maxDegreesDelta)
    {
        float angle = Angle(from, to);
        return angle == 0f ? to : SlerpUnclamped(from, to, Mathf.Min(1f, maxDegreesDelta / angle));
    }

    public static float Dot(Quaternion a, Quaternion b) => a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;

    public static float Angle(Quaternion a, Quaternion b)
    {
        float dot = Mathf.Min(Mathf.Abs(Dot(a, b)), 1f);
        return dot > 1f - kEpsilon ? 0f : Mathf.Acos(dot) * 2f * Mathf.Rad2Deg;
    }

    public static Quaternion Normalize(Quaternion q)
    {
        float length = Mathf.Sqrt(Dot(q, q));
        return length < Mathf.Epsilon
            ? identity
            : new Quaternion(q.x / length, q.y / length, q.z / length, q.w / length);
    }

    /// <summary>The right rotation is applied first.</summary>
    public static Quaternion operator *(Quaternion lhs, Quaternion rhs)
    {
        return new Quaternion(
            lhs.w * rhs.x + lhs.x * rhs.w + lhs.y * rhs.z - lhs.z * rhs.y,
            lhs.w * rhs.y + lhs.y * rhs.w + lhs.z * rhs.x - lhs.x * rhs.z,
            lhs.w * rhs.z + lhs.z * rhs.w + lhs.x * rhs.y - lhs.y * rhs.x,
            lhs.w * rhs.w - lhs.x * rhs.x - lhs.y * rhs.y - lhs.z * rhs.z);
    }

    public static Vector3 operator *(Quaternion rotation, Vector3 point)
    {
        RotationMatrix.Columns(rotation, out Vector3 right, out Vector3 up, out Vector3 forward);
        return new Vector3(
            right.x * point.x + up.x * point.y + forward.x * point.z,
            right.y * point.x + up.y * point.y + forward.y * point.z,
            right.z * point.x + up.z * point.y + forward.z * point.z);
    }

    public static bool operator ==(Quaternion lhs, Quaternion rhs) => Dot(lhs, rhs) > 1f - kEpsilon;
    public static bool operator !=(Quaternion lhs, Quaternion rhs) => !(lhs == rhs);

    public override int GetHashCode()
    {
        return x.GetHashCode() ^ (y.GetHashCode() << 2) ^ (z.GetHashCode() >> 2) ^ (w.GetHashCode() >> 1);
    }

    public override bool Equals(object other) => other is Quaternion q && Equals(q);
    public bool Equals(Quaternion other) => x == other.x && y == other.y && z == other.z && w == other.w;
    public override string ToString() => ToString(null, null);
    public string ToString(string format) => ToString(format, null);
    public string ToString(string format, IFormatProvider formatProvider) =>
        FloatFormat.Tuple(format, formatProvider, "F5", x, y, z, w);

    static Quaternion Blend(Quaternion a, float weightA, Quaternion b, float weightB)
    {
        return new Quaternion(
            a.x * weightA + b.x * weightB,
            a.y * weightA + b.y * weightB,
            a.z * weightA + b.z * weightB,
            a.w * weightA + b.w * weightB);
    }
}
