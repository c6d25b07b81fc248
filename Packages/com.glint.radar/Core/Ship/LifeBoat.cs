using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>An enclosed life boat, pointed at both ends, on two chocks.</summary>
    static class LifeBoat
    {
        const double HalfLength = 2.8, HalfWidth = 1.0, Height = 1.9;

        // Its keel over the deck that it stands on.
        const double KeelHeight = 0.35;

        /// <param name="foot">Below its middle, on the deck.</param>
        /// <param name="rings">Steps from end to end.</param>
        public static ShipPart[] Build(double3 foot, double2[] circle, int rings)
        {
            double3 middle = foot + new double3(0, KeelHeight + Height / 2, 0);
            var frames = new double3[rings + 1][];
            for (int i = 0; i <= rings; i++)
            {
                double at = 2.0 * i / rings - 1, size = math.sqrt(1 - at * at);
                // The ends rise, and frames are between circle and square.
                frames[i] = System.Array.ConvertAll(circle, p =>
                    middle + new double3(HalfWidth * size * Full(p.x), Height / 2 * size * Full(p.y) + 0.25 * at * at, HalfLength * at));
            }
            return new[] { ShipPart.Loft(frames), Chock(foot, -0.5 * HalfLength), Chock(foot, 0.5 * HalfLength) };
        }

        static double Full(double value) => value * (1.25 - 0.25 * value * value);

        static ShipPart Chock(double3 foot, double z) =>
            ShipPart.Box(foot + new double3(-0.6, -Deckhouse.Overlap, z - 0.12), foot + new double3(0.6, KeelHeight + 0.5, z + 0.12));
    }
}
