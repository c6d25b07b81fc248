using UnityEngine;

namespace Glint.Host;

/// <summary>Converts between a unit quaternion and the columns of its 3x3 matrix, the images of x, y and z.</summary>
internal static class RotationMatrix
{
    internal static void Columns(Quaternion q, out Vector3 right, out Vector3 up, out Vector3 forward)
    {
        float x2 = q.x * 2f, y2 = q.y * 2f, z2 = q.z * 2f;
        float xx = q.x * x2, yy = q.y * y2, zz = q.z * z2;
        float xy = q.x * y2, xz = q.x * z2, yz = q.y * z2;
        float wx = q.w * x2, wy = q.w * y2, wz = q.w * z2;
        right = new Vector3(1f - (yy + zz), xy + wz, xz - wy);
        up = new Vector3(xy - wz, 1f - (xx + zz), yz + wx);
        forward = new Vector3(xz + wy, yz - wx, 1f - (xx + yy));
    }

    /// <summary>
    /// From orthonormal columns with determinant 1. The largest component is calculated by a square root, so that none
    /// is lost to cancellation.
    /// </summary>
    internal static Quaternion ToQuaternion(Vector3 right, Vector3 up, Vector3 forward)
    {
        float xx = right.x, yy = up.y, zz = forward.z;
        Quaternion q;
        if (xx + yy + zz > 0f)
            q = new Quaternion(up.z - forward.y, forward.x - right.z, right.y - up.x, 1f + xx + yy + zz);
        else if (xx >= yy && xx >= zz)
            q = new Quaternion(1f + xx - yy - zz, up.x + right.y, forward.x + right.z, up.z - forward.y);
        else if (yy >= zz)
            q = new Quaternion(up.x + right.y, 1f + yy - xx - zz, forward.y + up.z, forward.x - right.z);
        else
            q = new Quaternion(forward.x + right.z, forward.y + up.z, 1f + zz - xx - yy, right.y - up.x);
        return Quaternion.Normalize(q);
    }
}
