using System;

namespace Glint.Core
{
    /// <summary>How the sea's echo changes in time: Bragg waves, coherence and mean velocity.</summary>
    public static class ClutterMotion
    {
        /// <summary>Surface tension over density, m3/s2.</summary>
        internal const double Tension = 7.2e-5;

        // Where surface tension equals gravity: the published Bragg lines have this value. Elfouhaily's spectrum has
        // 370 rad/m, which lowers a line by up to 0.25 %.
        static readonly double s_slowestWave = Math.Sqrt(SeaSpectrum.Gravity / Tension);

        // Of the coherence time (OceanSAR): 3.29 wavelength / (U sqrt(erf(2.688 size / U^2))).
        const double CoherenceFactor = 3.29, SizeFactor = 2.688;

        static readonly Interval s_winds = Interval.Closed(1, 30);

        /// <summary>Angular frequency, rad/s, of short waves under gravity and surface tension.</summary>
        /// <param name="waveNumber">rad/m.</param>
        public static double AngularFrequency(double waveNumber) =>
            waveNumber * SeaSpectrum.PhaseSpeed(waveNumber, s_slowestWave);

        /// <summary>Time in seconds in which the correlation of the field falls to 1/e, as exp(-t^2 / tau^2).</summary>
        /// <param name="wavelength">Of the radar, m.</param>
        /// <param name="wind">10 m above the sea, m/s.</param>
        /// <param name="size">Side in metres of the cell whose inner motion is not resolved.</param>
        /// <exception cref="GlintException">The wind is out of range, or the size is not above 0.</exception>
        public static double CoherenceTime(double wavelength, double wind, double size)
        {
            if (!s_winds.Contains(wind))
                throw new GlintException($"sea clutter: the wind {Medium.Number(wind)} m/s must be {s_winds} m/s for "
                    + "the coherence time");
            if (!(size > 0))
                throw new GlintException($"sea clutter: the size {Medium.Number(size)} m of a cell must be above 0");
            double part = ErrorFunction.Erf(SizeFactor * size / (wind * wind));
            return CoherenceFactor * wavelength / (wind * Math.Sqrt(part));
        }

        /// <summary>
        /// Share of the Bragg waves' power that runs towards the radar. The short waves' density is the same both ways,
        /// so that it is divided by cos^2s of half the angle to the wind.
        /// </summary>
        /// <param name="windCosine">Cosine of the angle from the direction to the radar to the wind.</param>
        /// <param name="exponent">s, above 0; large: all waves run with the wind.</param>
        public static double ApproachingShare(double windCosine, double exponent) =>
            1 / (1 + Math.Pow(Math.Max(0, 1 - windCosine) / Math.Max(0, 1 + windCosine), exponent));

        /// <summary>
        /// Mean velocity towards the radar in m/s of a sea that travels towards it: linear waves without shadow and
        /// without modulation of the short waves. The Doppler frequency is twice it over the wavelength.
        /// </summary>
        /// <param name="incidence">From the vertical, rad.</param>
        /// <param name="logSlope">-d ln sigma0 / d incidence, per rad.</param>
        /// <param name="stokesDrift">Of the waves that tilt Bragg waves, m/s.</param>
        /// <param name="braggWaveNumber">rad/m.</param>
        /// <param name="surfaceDrift">m/s; 1.5 to 3 % of the wind.</param>
        public static double MeanVelocity(double incidence, double logSlope, double stokesDrift, double braggWaveNumber,
            double surfaceDrift) => logSlope * Math.Cos(incidence) * stokesDrift / 2
                + (AngularFrequency(braggWaveNumber) / braggWaveNumber + surfaceDrift) * Math.Sin(incidence);
    }
}
