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
}
