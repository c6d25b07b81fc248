using System;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>
    /// The mean echo of a sea of one wind, without a mesh: the product's spectrum, water, two-scale mean and breaking
    /// waves. The wind blows along Z.
    /// </summary>
    sealed class AnalyticSea
    {
        const double LongestWave = 1e-3;

        static readonly double3 s_wind = new double3(0, 0, 1);

        readonly ShortWaves _waves;
        readonly double2 _slopes;
        readonly double _breaking;

        public AnalyticSea(double wind, double frequency)
        {
            var settings = SeaSettings.Default;
            (settings.WindSpeed, settings.GridSize) = (wind, 4);
            _waves = new ShortWaves(new SeaSurface(settings));
            Scattering = new SeaScattering(frequency, Medium.SeaWater().At(frequency).permittivity,
                _waves.Spectrum.Density);
            var (along, across) = _waves.SlopeVariances(LongestWave, Scattering.TiltCut);
            _slopes = new double2(along, across);
            _breaking = WhitecapLaw.Default.Fraction(wind);
        }

        public SeaScattering Scattering { get; }

        public Elfouhaily Spectrum => _waves.Spectrum;

        /// <summary>Slope variance along and across the wind of the waves that tilt Bragg waves.</summary>
        public double2 Slopes => _slopes;

        /// <summary>Bragg scattering and mirror points.</summary>
        /// <param name="incidence">From the vertical, deg.</param>
        /// <param name="azimuth">From the direction against which the wind blows, deg.</param>
        public Sigma0 TwoScale(double incidence, double azimuth) =>
            Scattering.TwoScaleMean(SeaTestBed.Radar(incidence, azimuth), s_wind, _slopes);

        /// <summary>The same with breaking waves on their fraction of the surface.</summary>
        public Sigma0 WithBreaking(double incidence, double azimuth)
        {
            double breaker = _breaking * SeaScattering.Breaking(Math.Cos(math.radians(incidence)));
            return (1 - _breaking) * TwoScale(incidence, azimuth) + new Sigma0(breaker, breaker, 0);
        }

        /// <summary>The same with Smith's shadow.</summary>
        public Sigma0 WithShadow(double incidence, double azimuth)
        {
            double towards = Math.Cos(math.radians(azimuth)), across = Math.Sin(math.radians(azimuth));
            double slope = Math.Sqrt(towards * towards * _slopes.x + across * across * _slopes.y);
            return ClutterGeometry.LitFraction(math.radians(90 - incidence), slope) * WithBreaking(incidence, azimuth);
        }
    }
}
