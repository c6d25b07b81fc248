using System;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>What a transform does to shapes and sizes.</summary>
    static class TransformMath
    {
        /// <summary>Evenness of a transform that does not spoil the shapes of triangles and boxes.</summary>
        public const double GoodConditioning = 0.1;

        /// <summary>
        /// Least evenness of a transform whose inverse the rays are taken through:
        /// below it they would lose too many digits.
        /// </summary>
        public const double MinConditioning = 1e-3;

        /// <summary>
        /// 1 when shapes stay similar, also mirrored; towards 0 the more they are stretched, sheared or flattened;
        /// no number when the transform has no inverse.
        /// The ratio of the greatest stretch to the least is at most about 5 over it.
        /// </summary>
        public static double Conditioning(in Affine transform)
        {
            double maxStretch = MaxStretch(transform);
            return Math.Abs(transform.Determinant) / (maxStretch * maxStretch * maxStretch);
        }

        /// <summary>
        /// A power of two near the most that a length grows, so that multiplying by it rounds nothing.
        /// </summary>
        public static double Unit(in Affine transform)
        {
            // Not at 1 itself, where most scales are: there rounding would choose now this, now that power.
            double unit = PowerOfTwoBelow(Math.Sqrt(2) * MaxStretch(transform));
            return unit > 0 && unit <= double.MaxValue ? unit : 1;
        }

        /// <summary>The greatest power of two that is at most a positive number.</summary>
        public static double PowerOfTwoBelow(double value) =>
            BitConverter.Int64BitsToDouble(BitConverter.DoubleToInt64Bits(value) & 0x7FF0000000000000);

        static double MaxStretch(in Affine transform) => Math.Sqrt(
            Math.Max(math.lengthsq(transform.X), Math.Max(math.lengthsq(transform.Y), math.lengthsq(transform.Z))));
    }
}
