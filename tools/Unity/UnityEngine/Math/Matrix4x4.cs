using System;
using System.Runtime.CompilerServices;
using Glint.Host;

namespace UnityEngine;

/// <summary>Column vectors: translation in m03, m13, m23; fields in memory column by column.</summary>
[Serializable]
public partial struct Matrix4x4 : IEquatable<Matrix4x4>, IFormattable
{
    public float m00;
    public float m10;
    public float m20;
    public float m30;
    public float m01;
    public float m11;
    public float m21;
    public float m31;
    public float m02;
    public float m12;
    public float m22;
    public float m32;
    public float m03;
    public float m13;
    public float m23;
    public float m33;

    public Matrix4x4(Vector4 column0, Vector4 column1, Vector4 column2, Vector4 column3)
    {
        m00 = column0.x; m10 = column0.y; m20 = column0.z; m30 = column0.w;
        m01 = column1.x; m11 = column1.y; m21 = column1.z; m31 = column1.w;
        m02 = column2.x; m12 = column2.y; m22 = column2.z; m32 = column2.w;
        m03 = column3.x; m13 = column3.y; m23 = column3.z; m33 = column3.w;
    }

    public float this[int row, int column]
    {
        get => this[row + column * 4];
        set => this[row + column * 4] = value;
    }

    public float this[int index]
    {
        get => Unsafe.Add(ref m00, Checked(index));
        set => Unsafe.Add(ref m00, Checked(index)) = value;
    }

    public static Matrix4x4 zero => default;
    public static Matrix4x4 identity => Scale(Vector3.one);

    public bool isIdentity => this == identity;
    public float determinant => Determinant(this);
    public Matrix4x4 inverse => Inverse(this);
    public Matrix4x4 transpose => Transpose(this);

    public Vector4 GetColumn(int index) => new(this[0, Line(index)], this[1, index], this[2, index], this[3, index]);
    public Vector4 GetRow(int index) => new(this[Line(index), 0], this[index, 1], this[index, 2], this[index, 3]);
    public Vector3 GetPosition() => new(m03, m13, m23);

    public void SetColumn(int index, Vector4 column)
    {
        for (int row = 0; row < 4; row++)
            this[row, Line(index)] = column[row];
    }

    public void SetRow(int index, Vector4 row)
    {
        for (int column = 0; column < 4; column++)
            this[Line(index), column] = row[column];
    }

    /// <summary>Includes the division by w for projections.</summary>
    public Vector3 MultiplyPoint(Vector3 point)
    {
        float w = m30 * point.x + m31 * point.y + m32 * point.z + m33;
        return MultiplyPoint3x4(point) * (1f / w);
    }

    public Vector3 MultiplyPoint3x4(Vector3 point)
    {
        return new Vector3(
            m00 * point.x + m01 * point.y + m02 * point.z + m03,
            m10 * point.x + m11 * point.y + m12 * point.z + m13,
            m20 * point.x + m21 * point.y + m22 * point.z + m23);
    }

    public Vector3 MultiplyVector(Vector3 vector)
    {
        return new Vector3(
            m00 * vector.x + m01 * vector.y + m02 * vector.z,
            m10 * vector.x + m11 * vector.y + m12 * vector.z,
            m20 * vector.x + m21 * vector.y + m22 * vector.z);
    }

    /// <summary>The right matrix is applied first.</summary>
    public static Matrix4x4 operator *(Matrix4x4 lhs, Matrix4x4 rhs)
    {
        return new Matrix4x4(lhs * rhs.GetColumn(0), lhs * rhs.GetColumn(1),
            lhs * rhs.GetColumn(2), lhs * rhs.GetColumn(3));
    }

    public static Vector4 operator *(Matrix4x4 lhs, Vector4 vector)
    {
        return new Vector4(
            lhs.m00 * vector.x + lhs.m01 * vector.y + lhs.m02 * vector.z + lhs.m03 * vector.w,
            lhs.m10 * vector.x + lhs.m11 * vector.y + lhs.m12 * vector.z + lhs.m13 * vector.w,
            lhs.m20 * vector.x + lhs.m21 * vector.y + lhs.m22 * vector.z + lhs.m23 * vector.w,
            lhs.m30 * vector.x + lhs.m31 * vector.y + lhs.m32 * vector.z + lhs.m33 * vector.w);
    }

    public static bool operator ==(Matrix4x4 lhs, Matrix4x4 rhs)
    {
        return lhs.GetColumn(0) == rhs.GetColumn(0) && lhs.GetColumn(1) == rhs.GetColumn(1)
            && lhs.GetColumn(2) == rhs.GetColumn(2) && lhs.GetColumn(3) == rhs.GetColumn(3);
    }

    public static bool operator !=(Matrix4x4 lhs, Matrix4x4 rhs) => !(lhs == rhs);

    public override int GetHashCode()
    {
        return GetColumn(0).GetHashCode() ^ (GetColumn(1).GetHashCode() << 2)
            ^ (GetColumn(2).GetHashCode() >> 2) ^ (GetColumn(3).GetHashCode() >> 1);
    }

    public override bool Equals(object other) => other is Matrix4x4 m && Equals(m);

    public bool Equals(Matrix4x4 other)
    {
        return GetColumn(0).Equals(other.GetColumn(0)) && GetColumn(1).Equals(other.GetColumn(1))
            && GetColumn(2).Equals(other.GetColumn(2)) && GetColumn(3).Equals(other.GetColumn(3));
    }

    public override string ToString() => ToString(null, null);
    public string ToString(string format) => ToString(format, null);

    public string ToString(string format, IFormatProvider formatProvider)
    {
        string text = "";
        for (int row = 0; row < 4; row++)
        {
            for (int column = 0; column < 4; column++)
                text += FloatFormat.Text(this[row, column], format, formatProvider, "F5") + (column < 3 ? "\t" : "\n");
        }
        return text;
    }

    static int Checked(int index)
    {
        return (uint)index < 16u ? index : throw new IndexOutOfRangeException("Invalid matrix index!");
    }

    static int Line(int index)
    {
        return (uint)index < 4u ? index : throw new IndexOutOfRangeException("Invalid matrix row or column index!");
    }
}
