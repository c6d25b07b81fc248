using Unity.Mathematics;

namespace Glint.Core
{
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
}
