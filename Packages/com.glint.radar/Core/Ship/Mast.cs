using System.Collections.Generic;
using Unity.Mathematics;

namespace Glint.Core
{
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
}
