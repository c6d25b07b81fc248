using System;
using Glint.Host;

namespace UnityEngine;

[Serializable]
public struct Vector3Int : IEquatable<Vector3Int>, IFormattable
{
    int m_X;
    int m_Y;
    int m_Z;

    public Vector3Int(int x, int y) : this(x, y, 0)
    {
    }

    public Vector3Int(int x, int y, int z)
    {
        m_X = x;
        m_Y = y;
        m_Z = z;
    }

    public int x { get => m_X; set => m_X = value; }
    public int y { get => m_Y; set => m_Y = value; }
    public int z { get => m_Z; set => m_Z = value; }

    public int this[int index]
    {
        get => index switch
        {
            0 => m_X,
            1 => m_Y,
            2 => m_Z,
            _ =>
                throw new IndexOutOfRangeException($"Invalid Vector3Int index addressed: {index}!")
        };
        set
        {
            switch (index)
            {
                case 0: m_X = value; break;
                case 1: m_Y = value; break;
                case 2: m_Z = value; break;
                default: throw new IndexOutOfRangeException($"Invalid Vector3Int index addressed: {index}!");
            }
        }
    }

    public static Vector3Int zero => default;
    public static Vector3Int one => new(1, 1, 1);
    public static Vector3Int up => new(0, 1, 0);
    public static Vector3Int down => new(0, -1, 0);
    public static Vector3Int left => new(-1, 0, 0);
    public static Vector3Int right => new(1, 0, 0);
    public static Vector3Int forward => new(0, 0, 1);
    public static Vector3Int back => new(0, 0, -1);

    public float magnitude => Mathf.Sqrt(sqrMagnitude);
    public int sqrMagnitude => x * x + y * y + z * z;

    public void Set(int x, int y, int z) => this = new Vector3Int(x, y, z);
    public void Scale(Vector3Int scale) => this *= scale;
    public void Clamp(Vector3Int min, Vector3Int max) => this = Min(max, Max(min, this));

    public static float Distance(Vector3Int a, Vector3Int b) => (a - b).magnitude;
    public static Vector3Int Min(Vector3Int lhs, Vector3Int rhs) =>
        new(Math.Min(lhs.x, rhs.x), Math.Min(lhs.y, rhs.y), Math.Min(lhs.z, rhs.z));
    public static Vector3Int Max(Vector3Int lhs, Vector3Int rhs) =>
        new(Math.Max(lhs.x, rhs.x), Math.Max(lhs.y, rhs.y), Math.Max(lhs.z, rhs.z));
    public static Vector3Int Scale(Vector3Int a, Vector3Int b) => a * b;
    public static Vector3Int FloorToInt(Vector3 v) =>
        new(Mathf.FloorToInt(v.x), Mathf.FloorToInt(v.y), Mathf.FloorToInt(v.z));
    public static Vector3Int CeilToInt(Vector3 v) =>
        new(Mathf.CeilToInt(v.x), Mathf.CeilToInt(v.y), Mathf.CeilToInt(v.z));
    public static Vector3Int RoundToInt(Vector3 v) =>
        new(Mathf.RoundToInt(v.x), Mathf.RoundToInt(v.y), Mathf.RoundToInt(v.z));

    public static implicit operator Vector3(Vector3Int v) => new(v.x, v.y, v.z);
    public static explicit operator Vector2Int(Vector3Int v) => new(v.x, v.y);
    public static Vector3Int operator -(Vector3Int a) => new(-a.x, -a.y, -a.z);
    public static Vector3Int operator +(Vector3Int a, Vector3Int b) => new(a.x + b.x, a.y + b.y, a.z + b.z);
    public static Vector3Int operator -(Vector3Int a, Vector3Int b) => new(a.x - b.x, a.y - b.y, a.z - b.z);
    public static Vector3Int operator *(Vector3Int a, Vector3Int b) => new(a.x * b.x, a.y * b.y, a.z * b.z);
    public static Vector3Int operator *(int a, Vector3Int b) => new(a * b.x, a * b.y, a * b.z);
    public static Vector3Int operator *(Vector3Int a, int b) => new(a.x * b, a.y * b, a.z * b);
    public static Vector3Int operator /(Vector3Int a, int b) => new(a.x / b, a.y / b, a.z / b);
    public static bool operator ==(Vector3Int lhs, Vector3Int rhs) =>
        lhs.x == rhs.x && lhs.y == rhs.y && lhs.z == rhs.z;
    public static bool operator !=(Vector3Int lhs, Vector3Int rhs) => !(lhs == rhs);

    public override bool Equals(object other) => other is Vector3Int v && Equals(v);
    public bool Equals(Vector3Int other) => this == other;
    public override int GetHashCode() => unchecked((x * 73856093) ^ (y * 19349663) ^ (z * 83492791));
    public override string ToString() => ToString(null, null);
    public string ToString(string format) => ToString(format, null);
    public string ToString(string format, IFormatProvider formatProvider) =>
        FloatFormat.Tuple(format, formatProvider, x, y, z);
}
