using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>A funnel that leans aft, longer than wide, with a rim.</summary>
    static class Funnel
    {
        const double HalfWidth = 1.3, HalfLength = 2.4, Rake = 0.35;

        /// <param name="rings">Steps up its side.</param>
        public static ShipPart[] Build(double3 foot, double height, double2[] circle, int rings)
        {
            double3[] Ring(double up, double size) => Circle.Level(circle, foot + new double3(0, up, Rake * up), size * HalfWidth, size * HalfLength);
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
