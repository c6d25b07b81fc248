using System;
using System.Numerics;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>
    /// Sigma0 of facets and of a whole sea at 10 GHz, against values computed by another program from the same
    /// published formulas.
    /// </summary>
    public sealed class SeaScatteringTests
    {
        static readonly double3 s_up = new double3(0, 1, 0), s_wind = new double3(0, 0, 1);

        [TestCase(10, 3.05280, 0.1)]
        [TestCase(10, 5.65182e-3, 1)]
        [TestCase(10, 4.07045e-6, 10)]
        [TestCase(10, 7.80091e-9, 100)]
        [TestCase(10, 1.68921e-10, 419.2)]
        public void TestSpectrum_IsThePublishedOne(double wind, double expected, double k) =>
            Assert.That(new ElfouhailyFromPaper(wind).Omnidirectional(k), Is.EqualTo(expected).Within(3e-4).Percent);

        [Test]
        public void TestSpectrum_HasThePublishedSlopes()
        {
            var slopes = new SeaTestBed(10).Slopes(SeaTestBed.LongestWave);
            Assert.That(slopes.x, Is.EqualTo(0.01967).Within(0.00003));
            Assert.That(slopes.y, Is.EqualTo(0.01338).Within(0.00003));
        }

        [TestCase(30, 0.8159, 1.2729)]
        [TestCase(60, 0.8891, 4.5063)]
        [TestCase(80, 0.9600, 22.630)]
        public void BraggCoefficients_HaveThePublishedMagnitudes(double incidence, double hh, double vv)
        {
            var found = SeaScattering.BraggCoefficients(SeaTestBed.SeaWater, Math.Cos(math.radians(incidence)));
            Assert.That(Complex.Abs(found.hh), Is.EqualTo(hh).Within(1e-4 * hh));
            Assert.That(Complex.Abs(found.vv), Is.EqualTo(vv).Within(1e-4 * vv));
        }

        // Perfect conductor: 1 and (1 + sin^2) / cos^2.
        [Test]
        public void BraggCoefficients_OfAMetal_AreTheLimit()
        {
            var (hh, vv) = SeaScattering.BraggCoefficients(new Complex(1, -1e12), 0.5);
            Assert.That(Complex.Abs(hh - 1), Is.LessThan(1e-5));
            Assert.That(Complex.Abs(vv - 7), Is.LessThan(1e-4));
        }

        [TestCase(80, 0, 0, -51.19, -23.74, double.NegativeInfinity)]
        [TestCase(80, 0.1, 0, -43.27, -20.77, double.NegativeInfinity)]
        [TestCase(80, 0.1, 0.1, -42.29, -20.89, -41.23)]
        [TestCase(87, 0.2, 0.1, -43.82, -21.45, -41.77)]
        [TestCase(60, -0.1, 0.2, -33.54, -18.81, -33.31)]
        [TestCase(45, 0.1, -0.1, -19.00, -12.87, -34.59)]
        public void Bragg_OfATiltedFacet_IsThePublishedValue(double incidence, double towards, double across,
            double hh, double vv, double hv)
        {
            var found = X.Bragg(Tilted(towards, across), Radar(incidence), s_wind);
            Assert.That(Sigma0.Decibels(found.HH), Is.EqualTo(hh).Within(0.0051));
            Assert.That(Sigma0.Decibels(found.VV), Is.EqualTo(vv).Within(0.0051));
            if (double.IsInfinity(hv))
                Assert.That(found.HV, Is.LessThan(1e-12 * found.VV));
            else
                Assert.That(Sigma0.Decibels(found.HV), Is.EqualTo(hv).Within(0.0051));
        }

        // A turn of sea, radar and wind together changes nothing: the formulas have no axis but the vertical one.
        [Test]
        public void Bragg_TurnedAboutTheVertical_IsTheSame()
        {
            double c = Math.Cos(0.7), s = Math.Sin(0.7);
            double3 Turned(double3 v) => new double3(c * v.x + s * v.z, v.y, c * v.z - s * v.x);
            var normal = Tilted(0.1, -0.2);
            var wind = math.normalize(new double3(1, 0, 2));
            var before = X.Bragg(normal, Radar(70), wind);
            var after = X.Bragg(Turned(normal), Turned(Radar(70)), Turned(wind));
            Assert.That(after.HH, Is.EqualTo(before.HH).Within(1e-9).Percent);
            Assert.That(after.VV, Is.EqualTo(before.VV).Within(1e-9).Percent);
            Assert.That(after.HV, Is.EqualTo(before.HV).Within(1e-9).Percent);
        }

        [Test]
        public void Bragg_FromBehindOrOfALongWave_IsNone()
        {
            Assert.That(X.Bragg(Tilted(-0.3, 0), Radar(80), s_wind).VV, Is.Zero);
            // 2 sin of the incidence is a third at 9.59 deg.
            Assert.That(X.Bragg(s_up, Radar(9.5), s_wind).VV, Is.Zero);
            Assert.That(X.Bragg(s_up, Radar(9.7), s_wind).VV, Is.GreaterThan(0));
            Assert.That(X.Bragg(s_up, s_up, s_wind).VV, Is.Zero);
        }

        [TestCase(0)]
        [TestCase(8)]
        public void Specular_IsThePrintedFormula(double incidence)
        {
            double tangent = Math.Tan(math.radians(incidence)), cosine = Math.Cos(math.radians(incidence));
            double expected = 0.7906 * 0.7906 / (2 * Math.Sqrt(0.006 * 0.0049) * Math.Pow(cosine, 4));
            double2 slopes = new double2(0.006, 0.0049);
            Assert.That(X.Specular(s_up, Radar(incidence), s_wind, slopes),
                Is.EqualTo(expected * Math.Exp(-tangent * tangent / (2 * 0.006))).Within(0.02).Percent);
            Assert.That(X.Specular(s_up, Radar(incidence), new double3(1, 0, 0), slopes),
                Is.EqualTo(expected * Math.Exp(-tangent * tangent / (2 * 0.0049))).Within(0.02).Percent);
        }

        // The mirror points of tilted facets with the rest of the slopes are those of the whole sea.
        [Test]
        public void Specular_OverResolvedSlopes_IsThatOfAllSlopes()
        {
            double2 resolved = new double2(0.012, 0.008), rest = new double2(0.006, 0.005);
            double sum = 0, weights = 0;
            for (double x = -5; x <= 5; x += 0.1)
                for (double y = -5; y <= 5; y += 0.1)
                {
                    var slope = new double3(Math.Sqrt(resolved.y) * y, 0, Math.Sqrt(resolved.x) * x);
                    double weight = Math.Exp(-(x * x + y * y) / 2);
                    sum += weight * X.Specular(math.normalize(s_up - slope), Radar(8), s_wind, rest);
                    weights += weight;
                }
            // Slopes about a tilted facet are those about the vertical up to their squares.
            Assert.That(sum / weights, Is.EqualTo(X.Specular(s_up, Radar(8), s_wind, resolved + rest)).Within(3)
                .Percent);
        }

        [Test]
        public void Specular_WithoutSlopesOrAtGrazing_IsNone()
        {
            Assert.That(X.Specular(s_up, s_up, s_wind, 0), Is.Zero);
            Assert.That(X.Specular(s_up, Radar(89.999), s_wind, 0.01), Is.Zero);
            Assert.That(X.Specular(s_up, Radar(100), s_wind, 0.01), Is.Zero);
        }

        [TestCase(20, 5.30)]
        [TestCase(30, 2.16)]
        [TestCase(40, -3.96)]
        [TestCase(45, -8.69)]
        [TestCase(50, -13.59)]
        [TestCase(60, -15.8)]
        [TestCase(89, -15.8)]
        public void Breaking_HasThePublishedValues(double incidence, double expected) => Assert.That(
            Sigma0.Decibels(SeaScattering.Breaking(Math.Cos(math.radians(incidence)))),
            Is.EqualTo(expected).Within(incidence < 60 ? 0.0051 : 0.051));

        // Ripples of a saturation of 0.01 on slopes across the radar's direction, of half the breakers' variance of 0.19.
        [TestCase(25)]
        [TestCase(45)]
        [TestCase(70)]
        [TestCase(85)]
        public void BreakingCross_IsThatOfTiltedRipples(double incidence)
        {
            const double slope = 0.001;
            var ripples = new SeaScattering(1e10, Medium.SeaWater(20, 35).At(1e10).permittivity,
                (k, cosine) => 0.01 / (k * k * k * k));
            var normal = math.normalize(s_up + new double3(slope, 0, 0));
            var radar = Radar(incidence);
            Assert.That(math.dot(radar, new double3(1, 0, 0)), Is.EqualTo(0).Within(1e-9));
            Assert.That(ripples.BreakingCross(radar.y),
                Is.EqualTo(0.19 / 2 * ripples.Bragg(normal, radar, s_wind).HV / (slope * slope)).Within(0.1).Percent);
        }

        [TestCase(5, 0.00093)]
        [TestCase(7, 0.00292)]
        [TestCase(10, 0.00987)]
        [TestCase(15, 0.0393)]
        public void WhitecapFraction_HasThePublishedValues(double wind, double expected) =>
            Assert.That(WhitecapLaw.Default.Fraction(wind), Is.EqualTo(expected).Within(0.6).Percent);

        [Test]
        public void WhitecapFraction_IsProportionalToItsCoefficientAndAtMostOne()
        {
            Assert.That(new WhitecapLaw(2 * WhitecapLaw.DefaultCoefficient).Fraction(8),
                Is.EqualTo(2 * WhitecapLaw.Default.Fraction(8)).Within(1e-9).Percent);
            Assert.That(new WhitecapLaw(0).Fraction(8), Is.Zero);
            Assert.That(new WhitecapLaw(1e-3).Fraction(30), Is.EqualTo(1));
        }

        // The published means are without mirror points. At 30 deg they depend on where Bragg scattering ends: the page
        // says to hold them to 0.5 dB.
        [TestCase(30, 10, -10.79, -8.48, 0.5)]
        [TestCase(45, 10, -19.90, -13.68, 0.05)]
        [TestCase(60, 10, -28.42, -17.06, 0.05)]
        [TestCase(70, 10, -34.67, -19.45, 0.05)]
        [TestCase(80, 10, -42.20, -23.09, 0.05)]
        [TestCase(60, 5, -35.07, -23.06, 0.05)]
        [TestCase(60, 15, -25.53, -14.65, 0.05)]
        public void TwoScaleMean_IsThePublishedOne(double incidence, double wind, double hh, double vv,
            double tolerance)
        {
            var bed = new SeaTestBed(wind);
            var slopes = bed.Slopes(SeaTestBed.LongestWave);
            var found = bed.Scattering.TwoScaleMean(Radar(incidence), s_wind, slopes);
            double specular = bed.Scattering.Specular(s_up, Radar(incidence), s_wind, slopes);
            Assert.That(Sigma0.Decibels(found.HH - specular), Is.EqualTo(hh).Within(tolerance));
            Assert.That(Sigma0.Decibels(found.VV - specular), Is.EqualTo(vv).Within(tolerance));
        }

        [TestCase(0, 50, -40, "frequency 0 Hz must be from 1e9 to 4.7e10 Hz")]
        [TestCase(9.4e10, 50, -40, "frequency 94000000000 Hz")]
        [TestCase(1e10, 0.5, -1, "permittivity 0.5 - j 1")]
        [TestCase(1e10, 50, 40, "permittivity 50 - j -40")]
        public void Scattering_OfWhatIsNoSea_IsRefused(double frequency, double real, double imaginary, string says) =>
            Assert.That(() => new SeaScattering(frequency, new Complex(real, imaginary), (k, cosine) => 0),
                Throws.TypeOf<GlintException>().With.Message.Contains(says));

        [Test]
        public void WhitecapLaw_OutOfRange_IsRefused()
        {
            Assert.That(() => new WhitecapLaw(-1), Throws.TypeOf<GlintException>().With.Message.Contains("-1"));
            Assert.That(() => WhitecapLaw.Default.Fraction(31), Throws.TypeOf<GlintException>().With.Message
                .Contains("31 m/s"));
        }

        static SeaScattering X { get; } = new SeaTestBed(10).Scattering;

        /// <summary>Upwind: the radar looks against the wind, which blows along Z towards it.</summary>
        static double3 Radar(double incidence) => SeaTestBed.Radar(incidence, 0);

        // Tilted about X by one angle, then by the other: slopes towards the radar and across.
        static double3 Tilted(double towards, double across)
        {
            double a = Math.Atan(towards), d = Math.Atan(across);
            return new double3(Math.Sin(d), Math.Cos(a) * Math.Cos(d), Math.Sin(a) * Math.Cos(d));
        }
    }

    /// <summary>A sea of one wind under a radar, of 10 GHz if not said otherwise.</summary>
    sealed class SeaTestBed
    {
        public const double Frequency = 10e9;

        public const double Wavelength = 0.0299792458;

        /// <summary>rad/m.</summary>
        public const double LongestWave = 1e-3;

        /// <summary>Meissner and Wentz, 20 C, 35 psu, 10 GHz.</summary>
        public static readonly Complex SeaWater = new Complex(55.062, -37.514);

        public SeaTestBed(double wind) : this(wind, Frequency, SeaWater) { }

        public SeaTestBed(double wind, double frequency, Complex permittivity)
        {
            Spectrum = new ElfouhailyFromPaper(wind);
            Scattering = new SeaScattering(frequency, permittivity, Spectrum.Density);
        }

        public ElfouhailyFromPaper Spectrum { get; }

        public SeaScattering Scattering { get; }

        /// <summary>
        /// Slope variance, along and across the wind, of the waves that tilt Bragg waves, from a wave number on.
        /// </summary>
        public double2 Slopes(double from) => Spectrum.SlopeVariance(from, Scattering.TiltCut);

        /// <summary>Unit vector to the radar; degrees from the vertical, and from Z towards X.</summary>
        public static double3 Radar(double incidence, double azimuth)
        {
            double theta = math.radians(incidence), phi = math.radians(azimuth);
            return new double3(Math.Sin(theta) * Math.Sin(phi), Math.Cos(theta), Math.Sin(theta) * Math.Cos(phi));
        }
    }
}
