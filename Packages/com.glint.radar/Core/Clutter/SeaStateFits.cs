using System;

namespace Glint.Core
{
    /// <summary>Sea state, wave height and wind, by the fits of the published models.</summary>
    public static class SeaStateFits
    {
        // Of the wind of a fully risen sea: factor and exponent.
        const double WindFactor = 7.18, WindExponent = 0.4;

        static readonly Interval s_states = Interval.Closed(0, 6), s_heights = Interval.Closed(0, 12),
            s_winds = Interval.Closed(0, 20);

        /// <summary>Significant wave height in metres of a Douglas sea state, Nathanson's fit.</summary>
        /// <exception cref="GlintException">The sea state is out of the range of the fit.</exception>
        public static double WaveHeight(double state) =>
            0.04 + 0.1 * Math.Pow(Checked(s_states, state, "sea state", ""), 2.1);

        /// <summary>
        /// Wind in m/s that raises a significant wave height in metres, in a fully risen sea: 7.18 Hs^0.4.
        /// </summary>
        /// <exception cref="GlintException">The height is out of the range of the fit.</exception>
        public static double Wind(double waveHeight) =>
            RisenWind(Checked(s_heights, waveHeight, "significant wave height", " m"));

        /// <summary>Significant wave height in metres of a wind in m/s: the inverse of <see cref="Wind"/>.</summary>
        /// <exception cref="GlintException">The wind is out of the range of the fit.</exception>
        public static double WaveHeightOfWind(double wind) =>
            Math.Pow(Checked(s_winds, wind, "wind", " m/s") / WindFactor, 1 / WindExponent);

        /// <summary>Douglas sea state of a significant wave height in metres: the inverse of Nathanson's fit.</summary>
        /// <exception cref="GlintException">The height is out of the range of the fit.</exception>
        public static double OfWaveHeight(double waveHeight)
        {
            var range = Interval.Closed(WaveHeight(0), WaveHeight(6));
            return OfAnyHeight(Checked(range, waveHeight, "significant wave height", " m"));
        }

        /// <summary><see cref="OfWaveHeight"/>, also above the range of the fit; 0 below.</summary>
        internal static double OfAnyHeight(double waveHeight) =>
            Math.Pow(Math.Max(0, waveHeight - 0.04) / 0.1, 1 / 2.1);

        /// <summary><see cref="Wind"/> of any height, the same bits on any machine.</summary>
        internal static double RisenWind(double waveHeight) =>
            waveHeight > 0 ? WindFactor * PortableMath.Pow(waveHeight, WindExponent) : 0;

        /// <summary>Wind in m/s of Georgia Tech's model.</summary>
        internal static double GitWind(double state) => 2.15 * Math.Pow(state, 1.04);

        static double Checked(in Interval range, double value, string noun, string unit) => range.Contains(value)
            ? value
            : throw new GlintException($"sea: the {noun} {Medium.Number(value)}{unit} must be {range}{unit} for the "
                + "fits between sea state, wave height and wind");
    }
}
