using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// Points of the unit circle from square roots and rational functions alone,
    /// so that they are the same bits on every machine.
    /// </summary>
    static class Circle
    {
        /// <summary>
        /// One turn from (1, 0) over (0, 1) back to (1, 0), which occurs twice; eight times this number of steps, equal
        /// within a sixth.
        /// </summary>
        public static double2[] Points(int stepsPerEighth)
        {
            int quarter = 2 * stepsPerEighth;
            var points = new double2[4 * quarter + 1];
            for (int i = 0; i <= stepsPerEighth; i++)
            {
                // ((1 - u^2)/(1 + u^2), 2u/(1 + u^2)) is the circle; u is the tangent of half the angle,
                // that of 45 degrees sqrt(2) - 1.
                double u = (math.sqrt(2.0) - 1) * i / stepsPerEighth;
                var point = new double2((1 - u * u) / (1 + u * u), 2 * u / (1 + u * u));
                points[i] = point;
                points[quarter - i] = point.yx;
            }
            for (int i = 0; i < quarter; i++)
            {
                points[quarter + i] = new double2(-points[i].y, points[i].x);
                points[2 * quarter + i] = -points[i];
                points[3 * quarter + i] = new double2(points[i].y, -points[i].x);
            }
            points[4 * quarter] = points[0];
            return points;
        }

        /// <summary>A ring about a centre, level, round or stretched along z.</summary>
        public static double3[] Level(double2[] circle, double3 centre, double radiusX, double radiusZ) =>
            System.Array.ConvertAll(circle, p => centre + new double3(radiusX * p.x, 0, radiusZ * p.y));

        /// <summary>
        /// A solid of revolution about a vertical axis: (radius, height) from ring to ring, heights above the foot.
        /// </summary>
        public static ShipPart Turned(double2[] circle, double3 foot, bool creases, params double2[] profile) =>
            ShipPart.Loft(
                System.Array.ConvertAll(profile, at => Level(circle, foot + new double3(0, at.y, 0), at.x, at.x)),
                creases);

        /// <summary>A tapered round rod; it must not be vertical.</summary>
        public static ShipPart Rod(double2[] circle, double3 from, double3 to, double radiusFrom, double radiusTo)
        {
            double3 side = math.normalize(math.cross(to - from, new double3(0, 1, 0))),
                over = math.normalize(math.cross(side, to - from));
            double3[] Ring(double3 centre, double radius) =>
                System.Array.ConvertAll(circle, p => centre + radius * (p.x * side + p.y * over));
            return ShipPart.Loft(new[] { Ring(from, radiusFrom), Ring(to, radiusTo) });
        }
    }
}
