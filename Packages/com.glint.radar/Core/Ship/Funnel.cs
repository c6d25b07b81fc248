using Unity.Mathematics;

namespace Glint.Core
{
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
}
