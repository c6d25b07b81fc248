using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>
    /// Doppler centroid at C band, 10 m/s, against the wind: the mean over facets of a Gaussian sea, each with its tilt
    /// and the velocity of the waves that tilt it, against the closed form and against CDOP.
    /// </summary>
    public sealed class DopplerCentroidTests
    {
        const double Frequency = 5.35e9, Wind = 10, Drift = 0.015 * Wind;

        // Of the integral over slopes, in standard deviations.
        const double LastSlope = 5, SlopeStep = 0.1;

        static readonly AnalyticSea s_sea = new AnalyticSea(Wind, Frequency);

        static readonly double s_halfStokes = new ElfouhailyFromPaper(Wind).HalfStokesDrift(s_sea.Scattering.TiltCut);

        [Test]
        public void Centroid_AgainstTheWind_IsNearTheClosedFormAndCdop()
        {
            var rows = new[] { false, true }.SelectMany(isHorizontal => new double[] { 30, 35, 40 }.Select(incidence =>
                ($"{(isHorizontal ? "HH" : "VV")}, {incidence}", new[]
                {
                    Centroid(incidence, isHorizontal), ClosedForm(incidence, isHorizontal),
                    Cdop.Hertz(Wind, 0, incidence, isHorizontal)
                }))).ToArray();
            foreach (var (label, hertz) in rows)
            {
                Assert.That(hertz[0], Is.EqualTo(hertz[1]).Within(10).Percent, $"{label}: closed form");
                Assert.That(hertz[0], Is.EqualTo(hertz[2]).Within(35).Percent, $"{label}: CDOP");
            }
            ClutterPage.AssertTable("## Doppler centroid at C band", rows);
        }

        // Waves along Z, to the radar. A facet that faces the radar rises: of a wave cos(k z - w t) the vertical
        // velocity is -w/k times the slope, and a Gaussian sea's is linear in the slope on average.
        static double Centroid(double incidence, bool isHorizontal)
        {
            var radar = SeaTestBed.Radar(incidence, 0);
            double3 wind = new double3(0, 0, 1);
            double2 deviation = math.sqrt(s_sea.Slopes);
            double sum = 0, weights = 0;
            for (double u = -LastSlope; u <= LastSlope; u += SlopeStep)
                for (double v = -LastSlope; v <= LastSlope; v += SlopeStep)
                {
                    double along = u * deviation.x, across = v * deviation.y;
                    var normal = math.normalize(new double3(-across, 1, -along));
                    var sigma = s_sea.Scattering.Bragg(normal, radar, wind);
                    double weight = Math.Exp(-(u * u + v * v) / 2) * (isHorizontal ? sigma.HH : sigma.VV) / normal.y;
                    double towards = -along * s_halfStokes / s_sea.Slopes.x * radar.y + Drift * radar.z;
                    sum += weight * (2 * towards / Signal.Wavelength(Frequency) + BraggLine(normal, radar, wind));
                    weights += weight;
                }
            return sum / weights;
        }

        static double BraggLine(double3 normal, double3 radar, double3 wind)
        {
            var view = new FacetView(normal, radar, wind);
            if (!(view.Cosine > 0))
                return 0;
            double share = ClutterMotion.ApproachingShare(view.WindCosine, SeaClutter.ApproachingExponent);
            return (2 * share - 1) * ClutterMotion.AngularFrequency(2 * s_sea.Scattering.WaveNumber * view.Sine)
                / (2 * Math.PI);
        }

        static double ClosedForm(double incidence, bool isHorizontal)
        {
            double Level(double degrees)
            {
                double mirrors = s_sea.Scattering.Specular(new double3(0, 1, 0), SeaTestBed.Radar(degrees, 0),
                    new double3(0, 0, 1), s_sea.Slopes);
                var sigma = s_sea.TwoScale(degrees, 0);
                return (isHorizontal ? sigma.HH : sigma.VV) - mirrors;
            }

            const double step = 0.5;
            double theta = math.radians(incidence);
            return 2 / Signal.Wavelength(Frequency) * ClutterMotion.MeanVelocity(theta,
                Math.Log(Level(incidence - step) / Level(incidence + step)) / math.radians(2 * step), 2 * s_halfStokes,
                2 * s_sea.Scattering.WaveNumber * Math.Sin(theta), Drift);
        }
    }
}
