using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// A procedural naval vessel of intersecting closed solids. Bow towards -Z, y up, the water at y = 0,
    /// x = z = 0 in the middle of its length.
    /// The same settings give the same bits on every machine: sums, products,
    /// quotients and square roots in double, rounded to 2^-16 m.
    /// A new part is a class that returns a ShipPart, and a line in Build;
    /// the hull gets the triangles that the other parts do not use.
    /// </summary>
    public static class ShipModel
    {
        /// <summary>
        /// Patches of a surface do not share vertices: normals computed from the triangles are smooth within a patch
        /// and sharp at its edges.
        /// </summary>
        /// <exception cref="GlintException">A setting is out of its range.</exception>
        public static TriangleMesh Build(in ShipSettings settings)
        {
            settings.Validate();
            // Steps of round parts grow, like the hull's, with the square root of the triangles.
            double fineness = math.sqrt(settings.Triangles / 44000.0);
            int Steps(int standard) => math.max(1, (int)math.round(standard * fineness));
            double2[] fine = Circle.Points(Steps(5)), coarse = Circle.Points(Steps(2));

            var hull = new Hull(settings);
            var house = new Deckhouse(settings, hull);
            var bridge = new Bridge(settings, house);

            double3 OnLower(double x, double z) => new double3(x, house.LowerRoof, z);
            double3 OnCasing(double z) => new double3(0, house.CasingRoof, z);
            var parts = new List<ShipPart>();
            parts.AddRange(house.Build());
            parts.Add(bridge.Build());
            parts.Add(bridge.BuildRoof());
            parts.AddRange(Radome.Build(new double3(0, bridge.Roof, bridge.Front + 2), 0.8, fine));
            parts.AddRange(Gun.Build(OnLower(0, 0.84 * settings.HouseFrontZ), coarse));
            parts.AddRange(Mast.Build(OnCasing(house.CasingFront + 2), bridge.Roof + settings.MastHeight, coarse));
            parts.AddRange(
                Funnel.Build(OnCasing(house.CasingAft - 5), 5.5, 0.65 * house.CasingHalfWidth, fine, Steps(14)));
            parts.AddRange(Radome.Build(OnLower(0, settings.HouseAftZ - 4), 0.9, fine));
            foreach (var part in LifeBoat.Build(OnLower(house.LowerHalfWidth - 1, house.CasingAft - 7), fine))
            {
                parts.Add(part);
                parts.Add(part.Mirrored());
            }
            parts.Add(hull.Build(settings.Triangles - parts.Sum(part => part.TriangleCount)));

            var vertices = new List<float3>();
            var indices = new List<int>();
            foreach (var part in parts)
                part.AddTo(vertices, indices);
            return new TriangleMesh(vertices.ToArray(), indices.ToArray());
        }
    }

    /// <summary>A funnel that leans aft, longer than wide, with a rim.</summary>
    static class Funnel
    {
        // Lean aft as a fraction of the height; length as a multiple of the width.
        const double Lean = 0.35, Length = 2.2;

        /// <param name="halfWidth">Half the width at the foot.</param>
        /// <param name="rings">Steps up its side.</param>
        public static ShipPart[] Build(double3 foot, double height, double halfWidth, double2[] circle, int rings)
        {
            double3[] Ring(double up, double size) =>
                Circle.Level(circle, foot + new double3(0, up, Lean * up), size * halfWidth, size * Length * halfWidth);
            var side = new double3[rings + 1][];
            for (int i = 0; i <= rings; i++)
            {
                double part = (double)i / rings;
                side[i] = Ring(-Deckhouse.Overlap + part * (height + Deckhouse.Overlap), 1 - 0.3 * part * (2 - part));
            }
            return new[]
            {
                ShipPart.Loft(side),
                ShipPart.Loft(new[] { Ring(height - 0.5, 0.76), Ring(height + 0.1, 0.76) }),
            };
        }
    }

    /// <summary>
    /// A gun in a turret with sloped faces, on the deckhouse before the bridge, where it does not hide the deckhouse's
    /// front from a radar ahead.
    /// </summary>
    static class Gun
    {
        public static ShipPart[] Build(double3 foot, double2[] circle)
        {
            double3 At(double x, double y, double z) => foot + new double3(x, y, z);
            // Seen from above: a front of 1.2 m, sides that widen aft.
            double3[] Outline(double height, double width, double front, double aft) => new[]
            {
                At(0.5 * width, height, front), At(width, height, front + 0.9), At(width, height, aft),
                At(-width, height, aft), At(-width, height, front + 0.9), At(-0.5 * width, height, front),
            };
            return new[]
            {
                Circle.Turned(circle, foot, true, new double2(1.05, -Deckhouse.Overlap), new double2(1.05, 0.4)),
                ShipPart.Block(Outline(0.35, 1.15, -1.5, 1.3), Outline(1.75, 0.8, -0.7, 1.1)),
                // Barrel, raised by 6 degrees, and its thicker root.
                Circle.Rod(circle, At(0, 1.05, -0.9), At(0, 1.33, -3.9), 0.085, 0.06),
                Circle.Rod(circle, At(0, 1.05, -0.9), At(0, 1.15, -2), 0.15, 0.12),
            };
        }
    }

    /// <summary>An enclosed life boat, pointed at both ends, on two chocks.</summary>
    static class LifeBoat
    {
        const double HalfLength = 3.2, HalfWidth = 1.0, Height = 1.9;

        // Its keel over the deck that it stands on.
        const double KeelHeight = 0.35;

        /// <param name="foot">Point of the deck below its centre.</param>
        public static ShipPart[] Build(double3 foot, double2[] circle)
        {
            double3 centre = foot + new double3(0, KeelHeight + Height / 2, 0);
            // Half a circle from end to end.
            var frames = new double3[(circle.Length + 1) / 2][];
            for (int i = 0; i < frames.Length; i++)
            {
                double at = circle[i].x, size = circle[i].y;
                // The ends rise; frames are between circle and square.
                frames[i] = System.Array.ConvertAll(circle, p =>
                    centre + new double3(HalfWidth * size * Full(p.x),
                        Height / 2 * size * Full(p.y) + 0.25 * at * at, HalfLength * at));
            }
            return new[] { ShipPart.Loft(frames), Chock(foot, -0.5 * HalfLength), Chock(foot, 0.5 * HalfLength) };
        }

        static double Full(double value) => value * (1.25 - 0.25 * value * value);

        static ShipPart Chock(double3 foot, double z) =>
            ShipPart.Box(foot + new double3(-0.6, -Deckhouse.Overlap, z - 0.12),
                foot + new double3(0.6, KeelHeight + 0.5, z + 0.12));
    }

    /// <summary>A pyramid with a pole on it, two yards, a radar drum on a platform.</summary>
    static class Mast
    {
        /// <param name="foot">Centre of the pyramid's base.</param>
        /// <param name="top">Height of the pole's top.</param>
        public static IEnumerable<ShipPart> Build(double3 foot, double top, double2[] circle)
        {
            double height = top - foot.y, shoulder = 0.55 * height;
            double3 At(double x, double y, double z) => foot + new double3(x, y, z);
            double3[] Square(double y, double half) =>
                new[] { At(-half, y, -half), At(half, y, -half), At(half, y, half), At(-half, y, half) };

            yield return ShipPart.Block(Square(-Deckhouse.Overlap, 1.8), Square(shoulder, 0.9));
            yield return Circle.Turned(circle, foot, true, new double2(0.3, shoulder - 0.1), new double2(0.08, height));
            // Platform and drum on the pyramid, before the pole.
            yield return Circle.Turned(circle, At(0, shoulder, 0), true,
                new double2(1.1, -0.05), new double2(1.3, 0.15));
            yield return Circle.Turned(circle, At(0, shoulder, 0), true, new double2(0.9, 0.1), new double2(0.95, 0.25),
                new double2(0.95, 0.85), new double2(0.8, 1.05));
            foreach (var (at, half) in new[] { (0.68, 2.4), (0.82, 1.6) })
                yield return Circle.Rod(circle, At(-half, at * height, 0), At(half, at * height, 0), 0.07, 0.07);
        }
    }

    /// <summary>A ball on a round foot.</summary>
    static class Radome
    {
        public static ShipPart[] Build(double3 foot, double radius, double2[] circle)
        {
            // Half a circle from the lowest point to the highest.
            var profile = new double2[(circle.Length + 1) / 2];
            for (int i = 0; i < profile.Length; i++)
                profile[i] = radius * new double2(circle[i].y, 1.2 - circle[i].x);
            return new[]
            {
                Circle.Turned(circle, foot, true, new double2(0.6 * radius, -Deckhouse.Overlap),
                    new double2(0.5 * radius, 0.5 * radius)),
                Circle.Turned(circle, foot, false, profile),
            };
        }
    }

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
