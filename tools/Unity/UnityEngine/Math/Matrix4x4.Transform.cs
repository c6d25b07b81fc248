using System;
using Glint.Host;

namespace UnityEngine;

public partial struct Matrix4x4
{
    public Quaternion rotation
    {
        get
        {
            Vector3 size = lossyScale;
            return RotationMatrix.ToQuaternion(Axis(0, size.x), Axis(1, size.y), Axis(2, size.z));
        }
    }

    /// <summary>Lengths of the columns; x is negative for a mirroring matrix.</summary>
    public Vector3 lossyScale
    {
        get
        {
            float x = MultiplyVector(Vector3.right).magnitude;
            float y = MultiplyVector(Vector3.up).magnitude;
            float z = MultiplyVector(Vector3.forward).magnitude;
            return new Vector3(Determinant3x3() < 0.0 ? -x : x, y, z);
        }
    }

    public FrustumPlanes decomposeProjection
    {
        get
        {
            bool perspective = m32 != 0f;
            float near = perspective ? m23 / (m22 - 1f) : (m23 + 1f) / m22;
            float far = perspective ? m23 / (m22 + 1f) : (m23 - 1f) / m22;
            float width = perspective ? near : 1f;
            float shiftX = perspective ? m02 : -m03, shiftY = perspective ? m12 : -m13;
            return new FrustumPlanes
            {
                left = (shiftX - 1f) / m00 * width,
                right = (shiftX + 1f) / m00 * width,
                bottom = (shiftY - 1f) / m11 * width,
                top = (shiftY + 1f) / m11 * width,
                zNear = near,
                zFar = far,
            };
        }
    }

    public bool ValidTRS()
    {
        const float Skew = 1e-4f;
        Vector3 a = MultiplyVector(Vector3.right).normalized, b = MultiplyVector(Vector3.up).normalized,
            c = MultiplyVector(Vector3.forward).normalized;
        return m30 == 0f && m31 == 0f && m32 == 0f && m33 == 1f
            && Mathf.Abs(Vector3.Dot(a, b)) < Skew && Mathf.Abs(Vector3.Dot(b, c)) < Skew
            && Mathf.Abs(Vector3.Dot(c, a)) < Skew;
    }

    public void SetTRS(Vector3 pos, Quaternion q, Vector3 s) => this = TRS(pos, q, s);

    /// <summary>Scales first, then rotates, then moves.</summary>
    public static Matrix4x4 TRS(Vector3 pos, Quaternion q, Vector3 s)
    {
        RotationMatrix.Columns(q, out Vector3 right, out Vector3 up, out Vector3 forward);
        return new Matrix4x4(right * s.x, up * s.y, forward * s.z, new Vector4(pos.x, pos.y, pos.z, 1f));
    }

    public static Matrix4x4 Scale(Vector3 vector)
    {
        return new Matrix4x4
        {
            m00 = vector.x,
            m11 = vector.y,
            m22 = vector.z,
            m33 = 1f,
        };
    }

    public static Matrix4x4 Translate(Vector3 vector) => TRS(vector, Quaternion.identity, Vector3.one);
    public static Matrix4x4 Rotate(Quaternion q) => TRS(Vector3.zero, q, Vector3.one);

    /// <summary>From the viewer's space, +z ahead, to the world.</summary>
    public static Matrix4x4 LookAt(Vector3 from, Vector3 to, Vector3 up)
    {
        return TRS(from, Quaternion.LookRotation(to - from, up), Vector3.one);
    }

    /// <summary>
    /// As OpenGL's: the viewer looks along -z, depth from -1 (near) to 1. The vertical field of view in degrees.
    /// </summary>
    public static Matrix4x4 Perspective(float fov, float aspect, float zNear, float zFar)
    {
        double cotangent = 1.0 / Math.Tan(fov * (Math.PI / 360.0));
        double depth = (double)zNear - zFar;
        return new Matrix4x4
        {
            m00 = (float)(cotangent / aspect),
            m11 = (float)cotangent,
            m22 = (float)(((double)zFar + zNear) / depth),
            m23 = (float)(2.0 * zNear * zFar / depth),
            m32 = -1f,
        };
    }

    public static Matrix4x4 Ortho(float left, float right, float bottom, float top, float zNear, float zFar)
    {
        return new Matrix4x4
        {
            m00 = 2f / (right - left),
            m11 = 2f / (top - bottom),
            m22 = -2f / (zFar - zNear),
            m03 = -(right + left) / (right - left),
            m13 = -(top + bottom) / (top - bottom),
            m23 = -(zFar + zNear) / (zFar - zNear),
            m33 = 1f,
        };
    }

    public static Matrix4x4 Frustum(float left, float right, float bottom, float top, float zNear, float zFar)
    {
        return new Matrix4x4
        {
            m00 = 2f * zNear / (right - left),
            m11 = 2f * zNear / (top - bottom),
            m02 = (right + left) / (right - left),
            m12 = (top + bottom) / (top - bottom),
            m22 = -(zFar + zNear) / (zFar - zNear),
            m23 = -2f * zNear * zFar / (zFar - zNear),
            m32 = -1f,
        };
    }

    public static Matrix4x4 Frustum(FrustumPlanes fp) =>
        Frustum(fp.left, fp.right, fp.bottom, fp.top, fp.zNear, fp.zFar);

    public Plane TransformPlane(Plane plane)
    {
        Vector4 moved =
            Transpose(Inverse(this)) * new Vector4(plane.normal.x, plane.normal.y, plane.normal.z, plane.distance);
        return new Plane((Vector3)moved, moved.w);
    }

    Vector3 Axis(int column, float length) => length == 0f ? Vector3.zero : (Vector3)GetColumn(column) / length;

    double Determinant3x3()
    {
        return m00 * ((double)m11 * m22 - (double)m12 * m21)
            - m01 * ((double)m10 * m22 - (double)m12 * m20)
            + m02 * ((double)m10 * m21 - (double)m11 * m20);
    }
}
