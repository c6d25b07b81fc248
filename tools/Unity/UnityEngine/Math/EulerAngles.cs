using System;
using UnityEngine;

namespace Glint.Host;

/// <summary>Unity's Euler angles in degrees: about z, then x, then y, all about fixed axes.</summary>
internal static class EulerAngles
{
    // Sine of the x angle above which float32 cannot distinguish y and z.
    const double GimbalLock = 0.999999;

    internal static Quaternion ToQuaternion(float x, float y, float z)
    {
        (double sx, double cx) = Math.SinCos(x * (Math.PI / 360.0));
        (double sy, double cy) = Math.SinCos(y * (Math.PI / 360.0));
        (double sz, double cz) = Math.SinCos(z * (Math.PI / 360.0));
        return new Quaternion(
            (float)(cy * sx * cz + sy * cx * sz),
            (float)(sy * cx * cz - cy * sx * sz),
            (float)(cy * cx * sz - sy * sx * cz),
            (float)(cy * cx * cz + sy * sx * sz));
    }

    internal static Vector3 From(Quaternion rotation)
    {
        double x = rotation.x, y = rotation.y, z = rotation.z, w = rotation.w;
        double square = x * x + y * y + z * z + w * w;
        if (!(square > 0.0))
            return Vector3.zero;
        double s = 2.0 / square;
        double sine = s * (x * w - y * z);
        if (Math.Abs(sine) > GimbalLock)
        {
            double turn = Math.Atan2(s * (y * w - x * z), 1.0 - s * (y * y + z * z));
            return new Vector3(Positive(Math.CopySign(Math.PI / 2.0, sine)), Positive(turn), 0f);
        }
        return new Vector3(
            Positive(Math.Asin(sine)),
            Positive(Math.Atan2(s * (x * z + y * w), 1.0 - s * (x * x + y * y))),
            Positive(Math.Atan2(s * (x * y + z * w), 1.0 - s * (x * x + z * z))));
    }

    // Angles a rounding error below zero remain there instead of becoming 360.
    static float Positive(double radians)
    {
        const double Rounding = 1e-4;
        double turned = radians < -Rounding ? radians + 2.0 * Math.PI : radians;
        return (float)(turned * (180.0 / Math.PI));
    }
}
