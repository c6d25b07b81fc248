namespace Glint.Core
{
    /// <summary>
    /// The sea states of the World Meteorological Organization (code table 3700, the Douglas scale) as
    /// significant wave heights in metres.
    /// </summary>
    public static class SeaState
    {
        /// <summary>The codes with a range of heights: 0 is calm, and 9 (above 14 m) has no upper end.</summary>
        public const int Lowest = 1, Highest = 8;

        // Range of code c: from s_ends[c - 1] to s_ends[c].
        static readonly double[] s_ends = { 0, 0.1, 0.5, 1.25, 2.5, 4, 6, 9, 14 };

        /// <summary>The middle of the code's range, metres: 3.25 m for sea state 5, 5 m for sea state 6.</summary>
        /// <exception cref="GlintException">The code is not one of 1 to 8.</exception>
        public static double WaveHeight(int code)
        {
            var (from, to) = Range(code);
            return (from + to) / 2;
        }

        /// <summary>Range of the significant wave height of the code, metres.</summary>
        /// <exception cref="GlintException">The code is not one of 1 to 8.</exception>
        public static (double From, double To) Range(int code)
        {
            if (code < Lowest || code > Highest)
                throw new GlintException($"sea state {code} must be from {Lowest} to {Highest}: "
                    + "0 has no waves and 9 no greatest height; ask for the significant wave height in metres instead");
            return (s_ends[code - 1], s_ends[code]);
        }
    }
}
