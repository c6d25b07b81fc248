using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>The radar's settings, except its pose.</summary>
    public struct RadarSettings
    {
        /// <summary>Upper limit of <see cref="MaxBounces"/>: each bounce costs a closest-hit query.</summary>
        public const int BounceLimit = 16;

        /// <summary>Maximum rays across or down: tiles of 8 x 8 have 16-bit columns and rows.</summary>
        public const int RaysPerAxisLimit = 65535 * 8;

        /// <summary>Range of the carrier frequency, hertz: wavelengths from 0.3 mm to 300,000 km.</summary>
        public const double LowestFrequencyHz = 1, HighestFrequencyHz = 1e12;

        /// <summary>Carrier frequency in hertz.</summary>
        public double FrequencyHz;

        /// <summary>
        /// Rays across the view, 1 to 524,280; with <see cref="RaysDown"/> they set the aspect ratio.
        /// </summary>
        public int RaysAcross;

        /// <summary>Rays down the view, 1 to 524,280.</summary>
        public int RaysDown;

        /// <summary>Maximum number of specular reflections of a ray, 1 to 16.</summary>
        public int MaxBounces;

        /// <summary>Part of the picture to trace; by default all of it.</summary>
        public RayRegion Region;

        /// <summary>
        /// Skips the estimate of the sampling error, which traces sub-rays around received rays.
        /// </summary>
        public bool SkipSamplingError;

        /// <summary>
        /// Tolerance of the amplitude in decibels, above 0: the amplitude is integrated over ray tubes to it. 0: one
        /// phasor a ray, as in the published experiment.
        /// </summary>
        public double ToleranceDb;

        /// <summary>Range of a tolerance, decibels.</summary>
        public const double MinToleranceDb = 0.001, MaxToleranceDb = 10;

        /// <summary>The published experiment: 10 GHz, 1920 x 1080 rays, 4 bounces.</summary>
        public static RadarSettings Default =>
            new RadarSettings { FrequencyHz = 10e9, RaysAcross = 1920, RaysDown = 1080, MaxBounces = 4 };

        /// <summary>Wavelength in metres.</summary>
        public double Wavelength => Signal.Wavelength(FrequencyHz);

        /// <summary>Rays of the whole picture.</summary>
        public long RayCount => (long)RaysAcross * RaysDown;

        /// <summary>Rays emitted in a pose: those of the region.</summary>
        public long RaysEmitted => (long)TracedRegion.Width * TracedRegion.Height;

        /// <summary><see cref="Region"/>, or all of the picture as one.</summary>
        public readonly RayRegion TracedRegion =>
            Region.IsWhole ? new RayRegion { Width = RaysAcross, Height = RaysDown } : Region;

        /// <summary>Column and row of a pixel (<see cref="RayData.Pixel"/>) in the whole picture.</summary>
        public readonly int2 PositionOf(uint pixel) =>
            new int2((int)(pixel % (uint)RaysAcross), (int)(pixel / (uint)RaysAcross));

        /// <summary>The pixel at a column and row of the whole picture.</summary>
        public readonly uint PixelAt(int x, int y) => (uint)(x + (long)y * RaysAcross);

        /// <summary>Width of the view over its height.</summary>
        public double Aspect => (double)RaysAcross / RaysDown;

        /// <summary>Refuses values out of range.</summary>
        /// <param name="owner">Who holds the settings, for the message.</param>
        /// <exception cref="GlintException">A value is out of its range.</exception>
        public void Validate(string owner)
        {
            if (!(FrequencyHz >= LowestFrequencyHz && FrequencyHz <= HighestFrequencyHz))
                throw new GlintException($"{owner}: frequency {Text(FrequencyHz)} Hz must be from "
                    + $"{Text(LowestFrequencyHz)} to {Text(HighestFrequencyHz)}");
            ValidateRays(owner, "across", RaysAcross);
            ValidateRays(owner, "down", RaysDown);
            if (RayCount > uint.MaxValue)
                throw new GlintException($"{owner}: {RaysAcross} x {RaysDown} are {RayCount} rays, "
                    + $"and a ray's number has 32 bits: use at most {uint.MaxValue}");
            if (!Region.IsWhole && !IsInPicture(Region))
                throw new GlintException($"{owner}: region "
                    + $"{Region.Left},{Region.Bottom},{Region.Width},{Region.Height} must have rays and lie within the "
                    + $"picture of {RaysAcross} x {RaysDown}");
            if (MaxBounces < 1 || MaxBounces > BounceLimit)
                throw new GlintException($"{owner}: maximum bounces {MaxBounces} must be from 1 to {BounceLimit}");
            ValidateTolerance(owner);
        }

        // NaN is in no range.
        void ValidateTolerance(string owner)
        {
            if (ToleranceDb != 0 && !(ToleranceDb >= MinToleranceDb && ToleranceDb <= MaxToleranceDb))
                throw new GlintException($"{owner}: tolerance {Text(ToleranceDb)} dB must be from "
                    + $"{Text(MinToleranceDb)} to {Text(MaxToleranceDb)}, or 0 for one phasor a ray");
            if (ToleranceDb != 0 && SkipSamplingError)
                throw new GlintException($"{owner}: a tolerance of {Text(ToleranceDb)} dB needs the error that is "
                    + "skipped: clear Skip Sampling Error, or set the tolerance to 0");
        }

        bool IsInPicture(in RayRegion region) =>
            region.Left >= 0 && region.Bottom >= 0 && region.Width > 0 && region.Height > 0
            && region.Left <= RaysAcross - region.Width && region.Bottom <= RaysDown - region.Height;

        static void ValidateRays(string owner, string axis, int rays)
        {
            if (rays < 1 || rays > RaysPerAxisLimit)
                throw new GlintException($"{owner}: rays {axis} {rays} must be from 1 to {RaysPerAxisLimit}");
        }

        internal static string Text(double value) => value.ToString(System.Globalization.CultureInfo.InvariantCulture);
    }

    /// <summary>
    /// A rectangle of the picture, in rays from its left and bottom edge; the rays outside are not emitted.
    /// Without area: the whole picture.
    /// </summary>
    public struct RayRegion
    {
        /// <summary>Left and bottom edge, width and height, all in rays of the whole picture.</summary>
        public int Left, Bottom, Width, Height;

        /// <summary>True for the whole picture.</summary>
        public readonly bool IsWhole => Width == 0 && Height == 0;
    }
}
