using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>A box in double precision, in which sums of float32 are exact enough to judge them.</summary>
    struct Bounds3
    {
        public double3 Low, High;

        public static Bounds3 Empty => new Bounds3 { Low = double.PositiveInfinity, High = double.NegativeInfinity };

        public void Add(double3 point)
        {
            Low = math.min(Low, point);
            High = math.max(High, point);
        }

        public void Add(in Bounds3 other)
        {
            Low = math.min(Low, other.Low);
            High = math.max(High, other.High);
        }

        /// <summary>Whether it reaches beyond the other box by a margin on each side.</summary>
        public bool Holds(in Bounds3 other, double3 margin) =>
            math.all(Low + margin <= other.Low) && math.all(High - margin >= other.High);
    }
}
