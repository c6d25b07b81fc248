using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>Gusts over a tile against the published spectrum and coherence of the wind, over many draws.</summary>
    public sealed class GustsTests
    {
        const double Wind = 9, Tile = 640, Height = 10;

        // Facets of 5 m hold gusts down to 10 m.
        const int Cells = 128, Draws = 40;

        // Deviations over the mean wind, by draw, row and column.
        double[][] _gusts;

        [OneTimeSetUp]
        public void Draw() => _gusts = Enumerable.Range(1, Draws).Select(seed => At(0, (uint)seed)).ToArray();

        // n S / u*^2 = 105 f / (1 + 33 f)^(5/3), f = n z / U, u* by Wu's drag, for waves of 640 to 80 m along the wind. Less
        // the waves shorter than 10 m: the coherence's transform over wave numbers across the wind is d / (d^2 + k^2) / pi.
        // Columns 8 to 30 m apart are independent: 20 to 80 numbers in each of 40 draws, 2 to 4 %.
        [TestCase(1)]
        [TestCase(2)]
        [TestCase(4)]
        [TestCase(8)]
        public void SpectrumAlongTheWind_IsKaimals(int mode)
        {
            double n = mode * Wind / Tile, f = n * Height / Wind, drag = (0.8 + 0.065 * Wind) * 1e-3;
            double expected = drag * 105 * f / Math.Pow(1 + 33 * f, 5.0 / 3) / mode
                * 2 / Math.PI * Math.Atan(2 * Math.PI / Height / Decay(mode));
            double found = _gusts.Average(gust => Enumerable.Range(0, Cells).Average(column =>
                Power(Amplitude(gust, column, mode))));
            Assert.That(found, Is.EqualTo(expected).Within(10).Percent);
        }

        // Between columns 10 to 40 m apart across the wind, over draws and columns. The waves that are left out are 3 to 8 %.
        [TestCase(1, 2)]
        [TestCase(1, 8)]
        [TestCase(2, 4)]
        [TestCase(4, 4)]
        public void CoherenceAcrossTheWind_IsExponential(int mode, int columns)
        {
            double sum = 0, power = 0;
            foreach (var gust in _gusts)
                for (int column = 0; column < Cells; column++)
                {
                    double2 a = Amplitude(gust, column, mode), b = Amplitude(gust, (column + columns) % Cells, mode);
                    sum += math.dot(a, b);
                    power += Power(a);
                }
            Assert.That(sum / power, Is.EqualTo(Math.Exp(-Decay(mode) * columns * Tile / Cells)).Within(0.06));
        }

        // The logarithm of the wind is lowered by half its variance. A tile has no gust longer than itself, so that its
        // mean is that of the wind within the variance's own scatter.
        [Test]
        public void MeanOfTheWind_Stays() => Assert.That(Enumerable.Range(1, 4).Average(seed =>
            LogWinds(0, (uint)seed, Gusts.DefaultGustiness).Average(Math.Exp)), Is.EqualTo(1).Within(5e-4));

        // A cell of 5 m in 5/9 s, and thirty of them.
        [TestCase(1)]
        [TestCase(30)]
        public void Gusts_MoveWithTheWind(int cells)
        {
            double[] moved = At(cells * Tile / Cells / Wind, 1);
            for (int row = 0; row < Cells; row++)
                for (int column = 0; column < Cells; column++)
                    Assert.That(moved[(row + cells) % Cells * Cells + column],
                        Is.EqualTo(_gusts[0][row * Cells + column]).Within(1e-9));
        }

        [Test]
        public void Gusts_OfNoGustiness_AreNone() => Assert.That(LogWinds(0, 1, 0), Is.All.Zero);

        [Test]
        public void Gusts_OfOtherSeeds_Differ() => Assert.That(Correlation(_gusts[0], _gusts[1]), Is.Zero.Within(0.2));

        // Waves and gusts of one seed have numbers of their own.
        [Test]
        public void Gusts_OfTheSeedOfTheWaves_HaveNothingToDoWithThem()
        {
            var mesh = Sea().Mesh(0);
            double[] heights = Enumerable.Range(0, Cells * Cells).Select(cell =>
                (double)mesh.Vertices[cell / Cells * (Cells + 1) + cell % Cells].y).ToArray();
            Assert.That(Correlation(_gusts[0], heights), Is.Zero.Within(0.2));
        }

        // The default is the root of the integral of Kaimal's spectrum, over u*, by the midpoints of ln f.
        [Test]
        public void DefaultGustiness_IsKaimals()
        {
            double sum = Enumerable.Range(0, 4000).Select(i => Math.Exp(-14 + 0.006 * (i + 0.5)))
                .Sum(f => 0.006 * 105 * f / Math.Pow(1 + 33 * f, 5.0 / 3));
            Assert.That(Gusts.DefaultGustiness, Is.EqualTo(Math.Sqrt(sum)).Within(0.01));
        }

        // Growth between winds 10 % below and above, of the spectrum as written from the paper.
        [TestCase(7, 0)]
        [TestCase(7, 1)]
        [TestCase(10, 0.5)]
        [TestCase(15, 0)]
        public void WindExponent_IsTheSpectrumsGrowth(double wind, double cosine)
        {
            var waves = new ShortWaves(new SeaSurface(SeaClutterTests.Waves(wind, 64, 64)));
            foreach (double k in new[] { 100, 400.0 })
                Assert.That(waves.WindExponent(k, cosine), Is.EqualTo(Math.Log(
                    new ElfouhailyFromPaper(1.1 * wind).Density(k, cosine)
                    / new ElfouhailyFromPaper(0.9 * wind).Density(k, cosine)) / Math.Log(1.1 / 0.9)).Within(1e-3));
        }

        // A facet in a gust scatters as one of another wind, by up to 1.1 dB more, in VV. Its slopes are those of the mean
        // wind, and their Bragg waves are not quite those of the facet itself.
        [TestCase(7, 1.1)]
        [TestCase(10, 0.9)]
        [TestCase(15, 1.1)]
        public void Facet_InAGust_ScattersAsInItsWind(double wind, double gust)
        {
            var sea = new SeaClutter(new SeaSurface(SeaClutterTests.Waves(wind, 64, 128)), 0, new double3(0, 0, 1),
                SeaClutterSettings.On);
            var bed = new SeaTestBed(gust * wind);
            var table = new FacetTable(bed.Scattering, sea.LongWaves.FacetSlopeVariances().Variances,
                sea.TableAt(SeaTestBed.Frequency).Unresolved);
            foreach (double incidence in new[] { 50, 70, 80, 88.0 })
                foreach (double azimuth in new[] { 0, 40, 90.0 })
                {
                    var radar = SeaTestBed.Radar(incidence, azimuth);
                    double found = sea.TableAt(SeaTestBed.Frequency).Read(new double3(0, 1, 0), radar, sea.Wind,
                        Math.Log(gust)).VV;
                    Assert.That(Sigma0.Decibels(found / table.Read(new double3(0, 1, 0), radar, sea.Wind).VV),
                        Is.Zero.Within(0.08), $"{incidence} deg, azimuth {azimuth}");
                }
        }

        static SeaSurface Sea()
        {
            var settings = SeaClutterTests.Waves(Wind, Tile, Cells);
            (settings.WindDirectionDegrees, settings.Seed, settings.Choppiness) = (0, 1, 0);
            return new SeaSurface(settings);
        }

        static double[] LogWinds(double time, uint seed, double gustiness) =>
            new Gusts(Wind, gustiness).LogWinds(Sea(), seed, time);

        // Small ones, whose logarithm is linear, scaled to the default.
        static double[] At(double time, uint seed)
        {
            const double small = 1e-3;
            return LogWinds(time, seed, small).Select(log => Gusts.DefaultGustiness / small * log).ToArray();
        }

        // Coherence exp(-12 sqrt((n r / U)^2 + (0.12 r / L)^2)), L = 56.7 m: per metre across the wind.
        static double Decay(int mode) => 12 * Math.Sqrt(Math.Pow(mode / Tile, 2) + Math.Pow(0.12 / 56.7, 2));

        // Of a wave along the wind in a column; the sum of squares of both parts is its variance.
        static double2 Amplitude(double[] gust, int column, int mode)
        {
            double2 sum = 0;
            for (int row = 0; row < Cells; row++)
            {
                double angle = 2 * Math.PI * mode * row / Cells;
                sum += gust[row * Cells + column] * new double2(Math.Cos(angle), Math.Sin(angle));
            }
            return Math.Sqrt(2) / Cells * sum;
        }

        static double Power(double2 amplitude) => math.lengthsq(amplitude);

        static double Correlation(double[] a, double[] b)
        {
            double meanA = a.Average(), meanB = b.Average();
            double Sum(double[] x, double meanX, double[] y, double meanY) =>
                x.Zip(y, (one, other) => (one - meanX) * (other - meanY)).Sum();
            return Sum(a, meanA, b, meanB) / Math.Sqrt(Sum(a, meanA, a, meanA) * Sum(b, meanB, b, meanB));
        }
    }
}
