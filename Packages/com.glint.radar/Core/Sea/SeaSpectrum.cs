using System;

namespace Glint.Core
{
    /// <summary>
    /// Variance of a sea's height over wave vectors, m4: its integral over them is m0.
    /// No wave travels against the wind, as in a local wind sea. Directions have the squared cosine of the angle from
    /// the wind, or Elfouhaily's distribution folded to the wind's half-plane. Sources: Documentation~/sea.md.
    /// </summary>
    static class SeaSpectrum
    {
        /// <summary>Gravity, rounded as in the sources of the spectra, m/s2.</summary>
        public const double Gravity = 9.81;

        // Of the integral of a height: its wave numbers, rad/m, outside of which nothing counts, and midpoints in equal
        // ratios.
        const double LongestWave = 1e-3, ShortestWave = 1e3;
        const int HeightSteps = 1000;

        /// <summary>
        /// Density at wave number k (rad/m) and the cosine of the angle from the wind.
        /// The constant of the Phillips spectrum is 1.
        /// </summary>
        public static double Density(in SeaSettings settings, double waveNumber, double cosine)
        {
            if (!(cosine >= 0) || settings.ShortestWave > 0 && waveNumber * settings.ShortestWave > 2 * Math.PI)
                return 0;
            if (settings.Kind == SeaSpectrumKind.Elfouhaily)
                return Folded(new Elfouhaily(settings.WindSpeed, settings.Fetch), waveNumber, cosine);
            double squared = cosine * cosine;
            return settings.Kind == SeaSpectrumKind.Phillips
                ? Phillips(waveNumber, settings.WindSpeed) * squared
                : Omnidirectional(settings, waveNumber) / waveNumber * (2 / Math.PI) * squared;
        }

        /// <summary>Density of Elfouhaily's spectrum without waves against the wind, m4.</summary>
        public static double Folded(in Elfouhaily spectrum, double waveNumber, double cosine) =>
            cosine >= 0 ? 2 * spectrum.Density(waveNumber, cosine) : 0;

        /// <summary>
        /// Angular frequency in rad/s of a deep-water wave; the wave number in rad/m. Elfouhaily's waves have surface
        /// tension, the others w^2 = g k.
        /// </summary>
        public static double AngularFrequency(SeaSpectrumKind kind, double waveNumber) =>
            kind == SeaSpectrumKind.Elfouhaily
                ? waveNumber * Elfouhaily.PhaseSpeed(waveNumber)
                : Math.Sqrt(Gravity * waveNumber);

        /// <summary>Phase speed in m/s of a deep-water wave with surface tension.</summary>
        /// <param name="waveNumber">rad/m.</param>
        /// <param name="slowest">
        /// Wave number of the slowest wave, where surface tension and gravity are equal, rad/m.
        /// </param>
        public static double PhaseSpeed(double waveNumber, double slowest)
        {
            double ratio = waveNumber / slowest;
            return Math.Sqrt(Gravity / waveNumber * (1 + ratio * ratio));
        }

        // Tessendorf 2001, eq. 40.
        static double Phillips(double k, double wind)
        {
            double longest = wind * wind / Gravity, kL = k * longest, kk = k * k;
            return PortableMath.Exp(-1 / (kL * kL)) / (kk * kk);
        }

        /// <summary>Variance per wave number, over all directions, m3.</summary>
        public static double Omnidirectional(in SeaSettings settings, double k)
        {
            switch (settings.Kind)
            {
                case SeaSpectrumKind.Phillips: return Phillips(k, settings.WindSpeed) * k * (Math.PI / 2);
                case SeaSpectrumKind.PiersonMoskowitz: return PiersonMoskowitz(k, settings.WindSpeed);
                case SeaSpectrumKind.Jonswap: return Jonswap(settings, k);
                default: return new Elfouhaily(settings.WindSpeed, settings.Fetch).Omnidirectional(k);
            }
        }

        /// <summary>
        /// Significant height in metres of the waves of all lengths, also those that a tile does not hold: four times the
        /// root of the variance. Not of the Phillips spectrum, whose constant is 1.
        /// </summary>
        public static double SignificantHeight(in SeaSettings settings)
        {
            double width = PortableMath.Log(ShortestWave / LongestWave) / HeightSteps, variance = 0;
            for (int i = 0; i < HeightSteps; i++)
            {
                double waveNumber = LongestWave * PortableMath.Exp((i + 0.5) * width);
                variance += waveNumber * width * Omnidirectional(settings, waveNumber);
            }
            return 4 * Math.Sqrt(variance);
        }

        // Pierson and Moskowitz 1964, with the wind at 19.5 m.
        static double PiersonMoskowitz(double k, double wind)
        {
            double high = 1.026 * wind, ratio = Gravity / (k * high * high);
            return 0.0081 / 2 / (k * k * k) * PortableMath.Exp(-0.74 * ratio * ratio);
        }

        // Hasselmann et al. 1973, from frequency to wave number by dw/dk = g / 2w.
        static double Jonswap(in SeaSettings settings, double k)
        {
            double wind = settings.WindSpeed, fetch = settings.Fetch;
            double alpha = 0.076 * PortableMath.Pow(wind * wind / (fetch * Gravity), 0.22);
            double peak = 22 * PortableMath.Pow(Gravity * Gravity / (wind * fetch), 1.0 / 3);
            double w = AngularFrequency(settings.Kind, k), ratio = peak / w, ratio2 = ratio * ratio;
            double width = (w <= peak ? 0.07 : 0.09) * peak, off = (w - peak) / width;
            double enhancement =
                PortableMath.Exp(PortableMath.Exp(-0.5 * off * off) * PortableMath.Log(settings.PeakEnhancement));
            return alpha / (2 * k * k * k) * PortableMath.Exp(-1.25 * ratio2 * ratio2) * enhancement;
        }
    }
}
