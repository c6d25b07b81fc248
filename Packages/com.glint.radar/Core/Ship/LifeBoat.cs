using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>An enclosed life boat, pointed at both ends, on two chocks.</summary>
    static class LifeBoat
    {
        const double HalfLength = 3.2, HalfWidth = 1.0, Height = 1.9;

        // Height of the keel above the deck, metres.
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
}
