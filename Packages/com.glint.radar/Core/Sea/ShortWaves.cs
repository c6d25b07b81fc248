using System;

namespace Glint.Core
{
    /// <summary>
    /// The waves that the mesh of a sea leaves out: Elfouhaily's, from the wave number where the mesh ends. They
    /// scatter diffusely and roughen its facets.
    /// </summary>
    public sealed class ShortWaves
    {
        // A larger step is reported, dB.
        const double LargestStep = 3;

        // Midpoints of an integral over wave numbers: its relative error is below 1e-5.
        const int Steps = 1000;

        const double DecibelsPerUnitOfLog = 4.342944819032518;

        // Part of the wind over which the spectrum's growth is taken: about that of gusts.
        const double Gust = 0.1;

        readonly Elfouhaily _spectrum, _weaker, _stronger;
        readonly double _logOfWinds;

        /// <summary>The short waves of a sea.</summary>
        /// <param name="longWaves">The sea whose mesh is used.</param>
        /// <param name="wind">
        /// Wind of the short waves, 3 to 20 m/s: the clutter wind. 0: <see cref="DefaultWind"/>.
        /// </param>
        /// <exception cref="GlintException">
        /// The wind is out of its range, or the mesh ends outside the wave numbers of the spectrum.
        /// </exception>
        public ShortWaves(SeaSurface longWaves, double wind = 0)
        {
            var settings = longWaves.Settings;
            Wind = wind == 0 ? DefaultWind(settings) : wind;
            if (!Elfouhaily.Winds.Contains(Wind))
                throw new GlintException(FormattableString.Invariant($"sea: clutter wind {Wind:0.###} m/s")
                    + (wind == 0 ? $", that of waves of {RadarSettings.Text(settings.SignificantWaveHeight)} m," : "")
                    + $" must be {Elfouhaily.Winds}, the range of Elfouhaily's spectrum: give a clutter wind in that "
                    + "range");
            _spectrum = new Elfouhaily(Wind, settings.Kind == SeaSpectrumKind.Elfouhaily ? settings.Fetch : 0);
            double weaker = (1 - Gust) * Wind, stronger = (1 + Gust) * Wind;
            weaker = weaker < Elfouhaily.MinWind ? Elfouhaily.MinWind : weaker;
            stronger = stronger > Elfouhaily.MaxWind ? Elfouhaily.MaxWind : stronger;
            (_weaker, _stronger) = (new Elfouhaily(weaker), new Elfouhaily(stronger));
            _logOfWinds = PortableMath.Log(stronger / weaker);
            Cut = CutOf(settings);
            if (!Elfouhaily.WaveNumbers.Contains(Cut))
                throw new GlintException($"sea: its mesh holds waves up to {RadarSettings.Text(Cut)} rad/m, and its "
                    + $"short ones must begin {Elfouhaily.WaveNumbers}, the range of Elfouhaily's spectrum: change "
                    + "cells, grid or tile size");
            Step = DecibelsPerUnitOfLog * PortableMath.Log(_spectrum.Omnidirectional(Cut)
                / (longWaves.DensityScale * SeaSpectrum.Omnidirectional(settings, Cut)));
            Height = HeightDeviation(Cut, Elfouhaily.MaxWaveNumber);
        }

        /// <summary>Wind of the short waves, m/s.</summary>
        public double Wind { get; }

        /// <summary>Their spectrum, of both directions along the wind as published.</summary>
        public Elfouhaily Spectrum => _spectrum;

        /// <summary>Wave number where the mesh ends, rad/m.</summary>
        public double Cut { get; }

        /// <summary>
        /// Variance per wave number of the short waves over that of the long ones at <see cref="Cut"/>, dB.
        /// </summary>
        public double Step { get; }

        /// <summary>
        /// Root mean square height of all waves that the mesh leaves out, metres: up to the end of the spectrum.
        /// </summary>
        public double Height { get; }

        /// <summary>Message about a step above 3 dB, to follow the sea's name; null without one.</summary>
        public string StepWarning => !(Math.Abs(Step) > LargestStep) ? null
            : FormattableString.Invariant($"where its mesh ends, at waves of {2 * Math.PI / Cut:0.###} m, ")
                + FormattableString.Invariant($"the short waves of a clutter wind of {Wind:0.#} m/s are ")
                + FormattableString.Invariant($"{Math.Abs(Step):0.0} dB ") + (Step > 0 ? "above" : "below")
                + " the long ones: give a clutter wind that fits the sea, or the sea Elfouhaily's spectrum and the "
                + "height of its wind";

        /// <summary>Largest wave number that facets of a side in metres hold: two facets a wave.</summary>
        public static double CutOf(double facetSide) => Math.PI / facetSide;

        /// <summary>Largest wave number of a tile: that of its facets or of its waves, whichever is less.</summary>
        public static double CutOf(in SeaSettings settings)
        {
            // Each wave of the grid stands for a cell of wave vectors around it.
            double ofFacets = CutOf(settings.TileSize / settings.Cells),
                ofGrid = Math.PI * (settings.GridSize - 1) / settings.TileSize;
            double cut = ofFacets < ofGrid ? ofFacets : ofGrid;
            return settings.ShortestWave * cut > 2 * Math.PI ? 2 * Math.PI / settings.ShortestWave : cut;
        }

        /// <summary>
        /// The clutter wind if none is given, m/s: the sea's own with Elfouhaily's spectrum or the height of the wind;
        /// otherwise that which raises a sea of the requested height, <see cref="SeaStateFits.Wind"/>.
        /// </summary>
        public static double DefaultWind(in SeaSettings settings) =>
            settings.Kind == SeaSpectrumKind.Elfouhaily || settings.SignificantWaveHeight == 0
                ? settings.WindSpeed
                : SeaStateFits.RisenWind(settings.SignificantWaveHeight);

        /// <summary>Mean square slopes along and across the wind of waves between two wave numbers, rad/m.</summary>
        /// <exception cref="GlintException">A wave number is out of the spectrum's range.</exception>
        public (double Along, double Across) SlopeVariances(double from, double to)
        {
            // Means of cos^2 and sin^2 over the directions of a wave number.
            double along = Integral(from, to, k => k * k * _spectrum.Omnidirectional(k)
                * (0.5 + 0.25 * _spectrum.Spreading(k))),
                both = Integral(from, to, k => k * k * _spectrum.Omnidirectional(k));
            return (along, both - along);
        }

        /// <summary>
        /// Power of the wind with which the density of ripples grows: d ln density / d ln wind. They follow gusts in
        /// about a second, whatever the fetch.
        /// </summary>
        /// <param name="waveNumber">rad/m.</param>
        /// <param name="cosine">Cosine of the angle from the wind.</param>
        public double WindExponent(double waveNumber, double cosine) => PortableMath.Log(
            _stronger.Density(waveNumber, cosine) / _weaker.Density(waveNumber, cosine)) / _logOfWinds;

        /// <summary>Root mean square height of waves between two wave numbers, metres.</summary>
        /// <exception cref="GlintException">A wave number is out of the spectrum's range.</exception>
        public double HeightDeviation(double from, double to) =>
            Math.Sqrt(Integral(from, to, _spectrum.Omnidirectional));

        // Midpoints in equal ratios.
        static double Integral(double from, double to, Func<double, double> density)
        {
            if (!(Elfouhaily.WaveNumbers.Contains(from) && Elfouhaily.WaveNumbers.Contains(to)))
                throw new GlintException($"sea: waves from {RadarSettings.Text(from)} to {RadarSettings.Text(to)} "
                    + $"rad/m must be {Elfouhaily.WaveNumbers}, the range of Elfouhaily's spectrum");
            double width = PortableMath.Log(to / from) / Steps, sum = 0;
            for (int i = 0; i < Steps; i++)
            {
                double k = from * PortableMath.Exp(width * (i + 0.5));
                sum += density(k) * k;
            }
            return sum * width;
        }
    }
}
