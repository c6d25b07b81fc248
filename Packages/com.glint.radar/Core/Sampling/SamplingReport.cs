namespace Glint.Core
{
    /// <summary>Sampling quality of a pose: Documentation~/accuracy.md.</summary>
    public readonly struct SamplingReport
    {
        /// <summary>A report.</summary>
        public SamplingReport(double error, double? largestPathStep, bool undersampled) =>
            (Error, LargestPathStep, Undersampled) = (error, largestPathStep, undersampled);

        /// <summary>
        /// Estimated distance of <see cref="RadarResult.NormalisedAmplitude"/> from its limit for infinitely many rays,
        /// in its unit.
        /// </summary>
        public double Error { get; }

        /// <summary>
        /// Maximum path difference between received rays of neighbouring pixels, wavelengths; null for ray tubes, which
        /// have none.
        /// </summary>
        public double? LargestPathStep { get; }

        /// <summary>
        /// True when the rays are too far apart, or too few return, for the amplitude and its error to be trusted. Of ray
        /// tubes: when the error is larger than the tolerance.
        /// </summary>
        public bool Undersampled { get; }
    }
}
