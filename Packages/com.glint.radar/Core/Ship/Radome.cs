using Unity.Mathematics;

namespace Glint.Core
{
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
}
