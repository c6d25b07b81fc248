using System;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>Conditioning and scale of transforms.</summary>
    static class TransformMath
    {
        /// <summary>
        /// Conditioning of a similarity, but for rounding: angles between facets stay as they are, and so do patches.
        /// </summary>
        public const double SimilarConditioning = 0.999;

        /// <summary>
        /// Minimum conditioning of a transform through whose inverse rays are transformed: below it they lose too many
        /// digits.
        /// </summary>
        public const double MinConditioning = 1e-3;

        /// <summary>
        /// Conditioning of a transform: 1 for a similarity, also mirrored; towards 0 with stretching, shearing or
        /// flattening; NaN for a singular transform. The ratio of maximum to minimum stretch is at most about 5 over
        /// it.
        /// </summary>
        public static double Conditioning(in Affine transform)
        {
            double maxStretch = MaxStretch(transform);
            return Math.Abs(transform.Determinant) / (maxStretch * maxStretch * maxStretch);
        }

        /// <summary>
        /// A power of two near the maximum stretch; multiplying by it is exact.
        /// </summary>
        public static double Unit(in Affine transform)
        {
            // The thresholds are not at 1, where most scales are and rounding would decide.
            double unit = PowerOfTwoBelow(Math.Sqrt(2) * MaxStretch(transform));
            return unit > 0 && unit <= double.MaxValue ? unit : 1;
        }

        /// <summary>The largest power of two not above a positive number.</summary>
        public static double PowerOfTwoBelow(double value) =>
            BitConverter.Int64BitsToDouble(BitConverter.DoubleToInt64Bits(value) & 0x7FF0000000000000);

        static double MaxStretch(in Affine transform) => Math.Sqrt(
            Math.Max(math.lengthsq(transform.X), Math.Max(math.lengthsq(transform.Y), math.lengthsq(transform.Z))));
    }
}
