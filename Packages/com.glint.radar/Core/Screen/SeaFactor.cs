using System;
using System.Numerics;

namespace Glint.Core
{
    /// <summary>
    /// Interference of the direct echo with its images in a smooth sea: the field at a reflector is F times that in free
    /// space, F = 1 - rho exp(j k delta), and that of the echo F^2 times. The earth is curved; the divergence of the
    /// reflected rays is left out, which matters near the horizon.
    /// </summary>
    public static class SeaFactor
    {
        /// <summary>Magnitude of F^2, 0 to 4.</summary>
        /// <param name="antenna">Height of the antenna above the sea, metres.</param>
        /// <param name="reflector">Height of the reflector above the sea, metres.</param>
        /// <param name="distance">Between them along the sea, metres.</param>
        /// <param name="reflection">Magnitude rho of the sea's reflection, whose sign is negative.</param>
        /// <param name="waveNumber">rad/m.</param>
        public static double Squared(double antenna, double reflector, double distance, double reflection,
            double waveNumber)
        {
            if (!(reflection > 0 && antenna > 0))
                return 1;
            reflector = Math.Max(0, reflector);
            var factor = 1 - Complex.FromPolarCoordinates(reflection,
                waveNumber * Detour(antenna, reflector, distance));
            return PowerLevel.Of(factor);
        }

        /// <summary>Metres by which the reflected way is longer than the direct one; 0 at the horizon.</summary>
        public static double Detour(double antenna, double reflector, double distance)
        {
            // The grazing angles on both sides of the point of reflection are equal.
            double near = 0, far = distance;
            for (int halvings = 0; halvings < 60; halvings++)
            {
                double middle = (near + far) / 2;
                (near, far) = Angle(antenna, middle) > Angle(reflector, distance - middle)
                    ? (middle, far) : (near, middle);
            }
            double a = Above(antenna, near), b = Above(reflector, distance - near);
            return a > 0 && b > 0
                ? 4 * a * b / (Math.Sqrt(distance * distance + (a + b) * (a + b))
                    + Math.Sqrt(distance * distance + (a - b) * (a - b)))
                : 0;
        }

        static double Angle(double height, double distance) => Above(height, distance) / distance;

        // Height over the tangent plane at the point of reflection.
        static double Above(double height, double distance) =>
            height - ClutterGeometry.DropAt(distance);
    }
}
