using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>A box in double precision, accurate enough to check sums of float32.</summary>
    struct Bounds3
    {
        public double3 Min, Max;

        public static Bounds3 Empty => new Bounds3 { Min = double.PositiveInfinity, Max = double.NegativeInfinity };

        public void Add(double3 point)
        {
            Min = math.min(Min, point);
            Max = math.max(Max, point);
        }

        public void Add(in Bounds3 other)
        {
            Min = math.min(Min, other.Min);
            Max = math.max(Max, other.Max);
        }

        /// <summary>True if it contains the other box with a margin on each side.</summary>
        public bool Holds(in Bounds3 other, double3 margin) =>
            math.all(Min + margin <= other.Min) && math.all(Max - margin >= other.Max);
    }
}
