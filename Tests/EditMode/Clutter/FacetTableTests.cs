using System;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>The table over facets against integrals over slopes of the formula that it is made of.</summary>
    public sealed class FacetTableTests
    {
        static readonly double3 s_up = new double3(0, 1, 0), s_wind = new double3(0, 0, 1);

        // Facets of 1 m of every tilt up to four standard deviations, at all angles to the wind.
        [Test]
        public void Read_OfAFacet_IsTheMeanOverItsUnresolvedSlopes()
        {
            var bed = new SeaTestBed(10);
            var rest = bed.Slopes(Math.PI);
            var table = new FacetTable(bed.Scattering, 0, rest);
            foreach (double incidence in new[] { 20, 30, 45, 60, 75, 85, 89.0 })
                foreach (double azimuth in new[] { 0, 30, 90, 200.0 })
                    foreach (var slope in new[] { new double3(0, 0, 0), new double3(0.1, 0, 0.2),
                        new double3(-0.15, 0, 0.05), new double3(0.05, 0, -0.3) })
                    {
                        var radar = SeaTestBed.Radar(incidence, azimuth);
                        var normal = math.normalize(s_up - slope);
                        if (math.dot(normal, radar) < 0.02)
                            continue;
                        AssertNear(table.Read(normal, radar, s_wind), Direct(bed.Scattering, normal, radar, rest), 0.1,
                            $"{incidence} deg, azimuth {azimuth}, slope {slope}");
                    }
        }

        // A mesh of waves up to pi over the facet's side, each facet with the rest of the slopes, is the whole sea.
        [TestCase(0.5, 5)]
        [TestCase(1, 10)]
        [TestCase(1, 15)]
        [TestCase(4, 10)]
        [TestCase(4, 20)]
        public void Read_OverResolvedSlopes_IsTheTwoScaleMean(double side, double wind)
        {
            var bed = new SeaTestBed(wind);
            double cut = Math.PI / side;
            var resolved = bed.Spectrum.SlopeVariance(SeaTestBed.LongestWave, cut);
            var table = new FacetTable(bed.Scattering, resolved, bed.Slopes(cut));
            foreach (double incidence in new[] { 30, 45, 60, 70, 80.0 })
                foreach (double azimuth in new[] { 0, 45, 90.0 })
                {
                    var radar = SeaTestBed.Radar(incidence, azimuth);
                    AssertNear(MeanOver(resolved, normal => table.Read(normal, radar, s_wind)),
                        bed.Scattering.TwoScaleMean(radar, s_wind, bed.Slopes(SeaTestBed.LongestWave)),
                        // Near the mirror direction the tails of the slopes count, which two tilts widen.
                        incidence < 40 ? 0.25 : 0.1, $"{incidence} deg, azimuth {azimuth}");
                }
        }

        [Test]
        public void Read_WithoutUnresolvedSlopes_IsThePlaneFacet()
        {
            var scattering = new SeaTestBed(10).Scattering;
            var table = new FacetTable(scattering, 0.01, 0);
            foreach (double incidence in new[] { 30, 60, 80.0 })
            {
                var normal = math.normalize(new double3(0.1, 1, -0.05));
                var radar = SeaTestBed.Radar(incidence, 50);
                AssertNear(table.Read(normal, radar, s_wind), scattering.Bragg(normal, radar, s_wind), 0.05,
                    $"{incidence} deg");
            }
        }

        [Test]
        public void Read_FromBehind_IsNone() => Assert.That(new FacetTable(new SeaTestBed(10).Scattering, 0, 0.005)
            .Read(new double3(0, -1, 0), SeaTestBed.Radar(40, 0), s_wind).VV, Is.Zero);

        // The published loss of HH where slopes that a mesh leaves out are ignored, and of VV: below 0.4 dB.
        [TestCase(60, 4, -1.7)]
        [TestCase(60, 1, -1.1)]
        [TestCase(60, 0.25, -0.6)]
        [TestCase(80, 4, -4.3)]
        [TestCase(80, 1, -2.5)]
        [TestCase(80, 0.25, -1.3)]
        public void TwoScaleMean_WithoutUnresolvedSlopes_LosesWhatIsPublished(double incidence, double side, double hh)
        {
            var bed = new SeaTestBed(10);
            var radar = SeaTestBed.Radar(incidence, 0);
            var all = bed.Scattering.TwoScaleMean(radar, s_wind, bed.Slopes(SeaTestBed.LongestWave));
            var part = bed.Scattering.TwoScaleMean(radar, s_wind,
                bed.Spectrum.SlopeVariance(SeaTestBed.LongestWave, Math.PI / side));
            Assert.That(Sigma0.Decibels(part.HH / all.HH), Is.EqualTo(hh).Within(0.1));
            Assert.That(Sigma0.Decibels(part.VV / all.VV), Is.EqualTo(0).Within(0.41));
        }

        // Published effect of the cut between tilting waves and Bragg waves.
        [TestCase(10, -43.1, -28.8)]
        [TestCase(5, -42.6, -28.6)]
        [TestCase(3, -42.2, -28.4)]
        [TestCase(2, -41.8, -28.2)]
        public void TwoScaleMean_ForACut_IsThePublishedOne(double divisor, double at80, double at60)
        {
            var bed = new SeaTestBed(10);
            var slopes = bed.Spectrum.SlopeVariance(SeaTestBed.LongestWave, bed.Scattering.WaveNumber / divisor);
            foreach (var (incidence, hh) in new[] { (80, at80), (60, at60) })
                Assert.That(Sigma0.Decibels(bed.Scattering.TwoScaleMean(SeaTestBed.Radar(incidence, 0), s_wind, slopes)
                    .HH), Is.EqualTo(hh).Within(0.08));
        }

        // Published slope variances that a facet leaves out, 10 GHz, 10 m/s.
        [TestCase(0.25, 0.0044, 0.0036)]
        [TestCase(0.5, 0.0060, 0.0049)]
        [TestCase(1, 0.0078, 0.0064)]
        [TestCase(2, 0.0100, 0.0081)]
        [TestCase(4, 0.0122, 0.0098)]
        [TestCase(8, 0.0145, 0.0112)]
        public void TestSpectrum_HasThePublishedUnresolvedSlopes(double side, double along, double across)
        {
            var slopes = new SeaTestBed(10).Slopes(Math.PI / side);
            Assert.That(slopes.x, Is.EqualTo(along).Within(0.00011));
            Assert.That(slopes.y, Is.EqualTo(across).Within(0.00011));
        }

        // Tilts of the part in the frame of the facet, as in the table.
        static Sigma0 Direct(SeaScattering scattering, double3 normal, double3 radar, double2 variance)
        {
            // The wind's direction on the facet, and the one across.
            var along = math.normalize(s_wind - math.dot(s_wind, normal) * normal);
            var across = math.cross(normal, along);
            var bragg = Mean(variance, (u, v) =>
                scattering.Bragg(math.normalize(normal - u * along - v * across), radar, s_wind));
            double specular = scattering.Specular(normal, radar, s_wind, variance);
            return bragg + new Sigma0(specular, specular, 0);
        }

        static Sigma0 MeanOver(double2 variance, Func<double3, Sigma0> sigma) =>
            Mean(variance, (u, v) => sigma(math.normalize(s_up - u * s_wind - v * math.cross(s_up, s_wind))));

        static Sigma0 Mean(double2 variance, Func<double, double, Sigma0> sigma)
        {
            var sum = default(Sigma0);
            double weights = 0;
            for (double x = -4.5; x <= 4.5; x += 0.15)
                for (double y = -4.5; y <= 4.5; y += 0.15)
                {
                    double weight = Math.Exp(-(x * x + y * y) / 2);
                    sum += weight * sigma(Math.Sqrt(variance.x) * x, Math.Sqrt(variance.y) * y);
                    weights += weight;
                }
            return 1 / weights * sum;
        }

        static void AssertNear(Sigma0 sigma, Sigma0 expected, double decibels, string of)
        {
            double hh = Sigma0.Decibels(sigma.HH / expected.HH), vv = Sigma0.Decibels(sigma.VV / expected.VV),
                hv = Sigma0.Decibels(sigma.HV / expected.HV);
            Assert.That(new[] { hh, vv }, Is.All.EqualTo(0).Within(decibels), of);
            // Near the mirror direction the crossed echo is the small difference of two others.
            if (expected.HV > 1e-3 * expected.VV)
                Assert.That(hv, Is.EqualTo(0).Within(decibels), of);
        }
    }
}
