using System;

namespace Glint.Core
{
    /// <summary>
    /// The unified wave spectrum of Elfouhaily, Chapron, Katsaros and Vandemark, JGR 102 (1997) 15781: long waves,
    /// ripples and capillary waves of one wind. Wave numbers are in rad/m.
    /// </summary>
    public readonly struct Elfouhaily
    {
        // Wave number and phase speed (m/s) of the slowest wave, where surface tension and gravity are equal.
        const double SlowestWave = 370, SlowestSpeed = 0.23;

        // Inverse wave age of a fully developed sea.
        const double FullyDeveloped = 0.84;

        // Fetch over the wind's square at which the inverse wave age is 5, the model's largest, s2/m.
        const double MinFetchOverSquaredWind = 5.91;

        // ln 2 / 4 and ln 10.
        const double QuarterOfLn2 = 0.17328679513998632, Ln10 = 2.302585092994046;

        internal const double MaxWaveNumber = 2e3;

        /// <summary>Wave numbers for which the spectrum is used, rad/m.</summary>
        public static readonly Interval WaveNumbers = Interval.Closed(1e-3, MaxWaveNumber);

        internal const double MinWind = 3, MaxWind = 20;

        internal static readonly Interval Winds = Interval.Closed(MinWind, MaxWind);

        readonly double _peak, _peakSpeed, _inverseAge, _logEnhancement, _width, _longLevel, _shortLevel, _windTerm;

        /// <summary>The spectrum of a wind.</summary>
        /// <param name="wind">Metres a second, 10 m above the sea, 3 to 20.</param>
        /// <param name="fetch">Metres; 0: unlimited, a fully developed sea.</param>
        /// <exception cref="GlintException">Wind or fetch is out of its range.</exception>
        public Elfouhaily(double wind, double fetch = 0)
        {
            Validate("Elfouhaily's spectrum", wind, fetch);
            // Wave number whose inertia is the wind's.
            double ofWind = SeaSpectrum.Gravity / (wind * wind);
            _inverseAge = fetch == 0 ? FullyDeveloped
                : FullyDeveloped
                    * PortableMath.Pow(Tanh(PortableMath.Pow(ofWind * fetch / 2.2e4, 0.4)), -0.75);
            _peak = ofWind * _inverseAge * _inverseAge;
            _peakSpeed = PhaseSpeed(_peak);
            _logEnhancement = PortableMath.Log(
                _inverseAge <= 1 ? 1.7 : 1.7 + 6 / Ln10 * PortableMath.Log(_inverseAge));
            _width = 0.08 * (1 + 4 / (_inverseAge * _inverseAge * _inverseAge));
            _longLevel = 0.006 * Math.Sqrt(_inverseAge);
            double friction = FrictionVelocity(wind) / SlowestSpeed;
            _shortLevel = 0.01 * (1 + (friction <= 1 ? 1 : 3) * PortableMath.Log(friction));
            _windTerm = 0.13 * friction;
        }

        /// <summary>Phase speed in m/s of a deep-water wave with surface tension.</summary>
        public static double PhaseSpeed(double waveNumber) => SeaSpectrum.PhaseSpeed(waveNumber, SlowestWave);

        /// <summary>
        /// Friction velocity in m/s of a wind 10 m above the sea, by the drag coefficient of Wu (1980).
        /// </summary>
        public static double FrictionVelocity(double wind) => Math.Sqrt((0.8 + 0.065 * wind) * 1e-3) * wind;

        /// <summary>Variance of the height per wave number, over all directions, m3.</summary>
        public double Omnidirectional(double waveNumber)
        {
            double speed = PhaseSpeed(waveNumber), toPeak = _peak / waveNumber,
                offPeak = Math.Sqrt(waveNumber / _peak) - 1, widths = offPeak / _width,
                fromSlowest = waveNumber / SlowestWave - 1;
            double peak = PortableMath.Exp(-1.25 * toPeak * toPeak
                + _logEnhancement * PortableMath.Exp(-0.5 * widths * widths));
            double longWaves = _longLevel * _peakSpeed
                    * PortableMath.Exp(-_inverseAge / Math.Sqrt(10) * offPeak),
                shortWaves = _shortLevel * SlowestSpeed * PortableMath.Exp(-0.25 * fromSlowest * fromSlowest);
            return 0.5 * (longWaves + shortWaves) * peak / (speed * waveNumber * waveNumber * waveNumber);
        }

        /// <summary>
        /// Delta of the distribution over directions, (1 + Delta cos 2 phi) / (2 pi), phi from the wind: 0 to 1.
        /// </summary>
        public double Spreading(double waveNumber)
        {
            double speed = PhaseSpeed(waveNumber), toPeak = speed / _peakSpeed, toSlowest = SlowestSpeed / speed;
            return Tanh(QuarterOfLn2 + 4 * toPeak * toPeak * Math.Sqrt(toPeak)
                + _windTerm * toSlowest * toSlowest * Math.Sqrt(toSlowest));
        }

        /// <summary>
        /// Variance per wave vector, m4, as published: equal along and against the wind. Its integral over all vectors
        /// is that of the height.
        /// </summary>
        /// <param name="cosine">Cosine of the angle from the wind.</param>
        public double Density(double waveNumber, double cosine) => Omnidirectional(waveNumber)
            * (1 + Spreading(waveNumber) * (2 * cosine * cosine - 1)) / (2 * Math.PI * waveNumber);

        /// <summary>Refuses a wind and a fetch outside the model.</summary>
        /// <param name="subject">Whose they are, for messages.</param>
        internal static void Validate(string subject, double wind, double fetch)
        {
            if (!Winds.Contains(wind))
                throw new GlintException($"{subject}: wind speed {RadarSettings.Text(wind)} m/s must be {Winds}, the "
                    + "range of Elfouhaily's spectrum: give one in that range, or long waves of another spectrum");
            var fetches = Interval.Closed(
                Math.Floor(MinFetchOverSquaredWind * wind * wind) + 1, SeaSettings.MaxFetch);
            if (fetch != 0 && !fetches.Contains(fetch))
                throw new GlintException($"{subject}: fetch {RadarSettings.Text(fetch)} m must be 0, which is "
                    + $"unlimited, or {fetches}, the range of Elfouhaily's spectrum for a wind of "
                    + $"{RadarSettings.Text(wind)} m/s");
        }

        // Of an argument of 0 or more; above 20 it is 1 in double.
        static double Tanh(double x) => x > 20 ? 1 : 1 - 2 / (PortableMath.Exp(2 * x) + 1);
    }
}
