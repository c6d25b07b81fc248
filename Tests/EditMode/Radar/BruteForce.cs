using Glint.Core;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>The closest triangle by a test of each one, in double (Moeller and Trumbore).</summary>
    static class BruteForce
    {
        public static int ClosestHit(TriangleMesh scene, double3 origin, double3 direction, out double nearest)
        {
            int hit = -1;
            nearest = double.PositiveInfinity;
            for (int t = 0; t < scene.TriangleCount; t++)
            {
                scene.GetTriangle(t, out var a, out var b, out var c);
                double3 e1 = (double3)b - a, e2 = (double3)c - a, p = cross(direction, e2),
                    s = origin - a, q = cross(s, e1);
                double determinant = dot(e1, p), u = dot(s, p) / determinant, v = dot(direction, q) / determinant,
                    distance = dot(e2, q) / determinant;
                if (u >= 0 && v >= 0 && u + v <= 1 && distance > 0 && distance < nearest)
                    (hit, nearest) = (t, distance);
            }
            return hit;
        }

        /// <summary>Distance from the camera to a ray's last hit: the first segment of a ray of one bounce.</summary>
        public static double ToLastHit(double3 camera, RayData ray) => distance(camera, (double3)ray.LastHit);
    }
}
