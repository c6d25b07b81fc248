using System;
using System.Linq;
using System.Numerics;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    public sealed class SeaSurfaceTests
    {
        const double Gravity = 9.81;

        [Test]
        public void WaveHeight_OfTheSpectrum_IsThatAskedForTimesTheFactor([Values] SeaSpectrumKind kind,
            [Values(0.02, 2.5, 14)] double height, [Values(0, 77)] double direction)
        {
            var settings = SeaFields.Settings();
            (settings.Kind, settings.SignificantWaveHeight, settings.WindDirectionDegrees) = (kind, height, direction);
            Assert.That(new SeaSurface(settings).SignificantWaveHeight, Is.EqualTo(height).Within(1e-9));
            settings.HeightFactor = 1.25;
            Assert.That(new SeaSurface(settings).SignificantWaveHeight, Is.EqualTo(1.25 * height).Within(1e-9));
        }

        // Each wave's variance has an exponential distribution. The mean over seeds of their sum has a spread of 1.1 %
        // here, and the mean of all waves' normalised variances one of 0.2 %.
        [Test]
        public void WaveHeight_OverTwoThousandSeeds_IsThatAskedForOnAverage()
        {
            const int seeds = 2000;
            var settings = SeaFields.Settings(16, 16, 9);
            var byWave = PrintedSpectra.Variances(settings);
            var variances = new double[seeds];
            double parts = 0;
            for (int seed = 0; seed < seeds; seed++)
            {
                settings.Seed = seed;
                var surface = new SeaSurface(settings);
                variances[seed] = math.square(surface.MeasuredWaveHeight(3)) / 16;
                parts += surface.Modes.Average(mode => 2 * (mode.Real * mode.Real + mode.Imaginary * mode.Imaginary)
                    / byWave[(mode.Column, mode.Row)]) / seeds;
            }
            double expected = math.square(settings.SignificantWaveHeight) / 16, mean = variances.Average();
            Assert.That(mean, Is.EqualTo(expected).Within(3).Percent);
            Assert.That(parts, Is.EqualTo(1).Within(0.01));

            double spread = Math.Sqrt(variances.Average(v => math.square(v - mean))),
                ofAll = Math.Sqrt(byWave.Values.Sum(math.square));
            Assert.That(spread, Is.EqualTo(ofAll).Within(10).Percent, "two normal numbers a wave");
        }

        [Test]
        public void WaveHeight_Measured_IsThatOfTheMesh_AndTheSameAtAllTimes([Values(0, 1.5, 1000)] double time)
        {
            var settings = SeaFields.Settings(16, 32);
            var surface = new SeaSurface(settings);
            double ofMesh = 4 * Math.Sqrt(SeaFields.Heights(surface.Mesh(time), 32).Average(y => y * y));
            // Heights are rounded to 2^-16 m.
            Assert.That(surface.MeasuredWaveHeight(time), Is.EqualTo(ofMesh).Within(2e-5));
            Assert.That(surface.MeasuredWaveHeight(time), Is.EqualTo(surface.MeasuredWaveHeight(0)).Within(1e-12));
        }

        [Test]
        public void FactorFor_SomeTimes_MakesTheirJointHeightThatAskedFor()
        {
            var settings = SeaFields.Settings(16, 32);
            double[] times = { 0, 2, 4 };
            settings.HeightFactor = 7;
            settings.HeightFactor = SeaSurface.FactorFor(settings, times);
            var surface = new SeaSurface(settings);
            double joint =
                4 * Math.Sqrt(times.Average(time => SeaFields.Heights(surface.Mesh(time), 32).Average(y => y * y)));
            Assert.That(joint, Is.EqualTo(settings.SignificantWaveHeight).Within(2e-5));
        }

        [TestCase(8, 3)]
        [TestCase(9, 3)]
        [TestCase(13, 3)]
        [TestCase(5, 3)]
        [TestCase(1, 1)]
        public void TrigonometricSum_OfAnyCells_EqualsTheSumTermByTerm(int cells, int reach)
        {
            var waves = RandomWaves(reach);
            AssertNear(new TrigonometricSum(cells, reach).Sum(waves), SeaFields.Sum(waves, cells));
        }

        [TestCase(4, 1)]
        [TestCase(8, 3)]
        [TestCase(32, 3)]
        [TestCase(16, 7)]
        public void FourierSum_OfAPowerOfTwo_EqualsTheSumTermByTerm(int cells, int reach)
        {
            var waves = RandomWaves(reach);
            AssertNear(new FourierSum(cells).Sum(waves), SeaFields.Sum(waves, cells));
        }

        [TestCase(64)]
        [TestCase(256)]
        public void Sums_OfALargeSea_AreTheSame(int cells)
        {
            var waves = RandomWaves(31);
            AssertNear(new FourierSum(cells).Sum(waves), new TrigonometricSum(cells, 31).Sum(waves));
        }

        // 24 and 48 cells use the trigonometric sum, 32 the Fourier transform: every third point of the first is a
        // point of the last.
        [Test]
        public void Mesh_OfAnyCells_SamplesTheSameSea()
        {
            var fast = Displaced(16, 32).Mesh(5);
            var slow = Displaced(16, 24).Mesh(5);
            for (int z = 0; z <= 8; z++)
                for (int x = 0; x <= 8; x++)
                    Assert.That(math.distance(slow.Vertices[3 * z * 25 + 3 * x], fast.Vertices[4 * z * 33 + 4 * x]),
                        Is.LessThan(3.0 / 65536), $"at {x}, {z} eighths");
        }

        // Gerstner's displacement, recalculated from the heights: -a k/|k| sin where the height is a cos.
        [Test]
        public void Mesh_Displaced_LeansTowardsItsCrests([Values(0.5, 1.6)] double choppiness)
        {
            const int cells = 16, reach = 7;
            SeaSettings level = SeaFields.Settings(16, cells), settings = level;
            (level.Choppiness, settings.Choppiness) = (0, choppiness);
            TriangleMesh flat = new SeaSurface(level).Mesh(2), displaced = new SeaSurface(settings).Mesh(2);
            var heights = SeaFields.Heights(flat, cells);
            double[] alongX = new double[cells * cells], alongZ = new double[cells * cells];
            for (int row = -reach; row <= reach; row++)
                for (int column = -reach; column <= reach; column++)
                {
                    if (row == 0 && column == 0)
                        continue;
                    var amplitude = SeaFields.Amplitude(heights, cells, column, row);
                    double length = Math.Sqrt(row * row + column * column);
                    for (int i = 0; i < cells * cells; i++)
                    {
                        double phase = 2 * Math.PI * (column * (i % cells) + row * (i / cells)) / cells
                            + amplitude.Phase, sine = amplitude.Magnitude * Math.Sin(phase);
                        alongX[i] -= choppiness * sine * column / length;
                        alongZ[i] -= choppiness * sine * row / length;
                    }
                }

            Assert.That(alongX.Max(), Is.GreaterThan(0.1), "metres: there is something to see");
            for (int i = 0; i < cells * cells; i++)
            {
                int vertex = i / cells * (cells + 1) + i % cells;
                var moved = displaced.Vertices[vertex] - flat.Vertices[vertex];
                // Rounding of the heights, spread over the waves, and of the positions.
                Assert.That(math.distance(moved, new double3(alongX[i], 0, alongZ[i])), Is.LessThan(1e-4), $"cell {i}");
            }
        }

        // A wave's phase changes by w t, w^2 = g k, so that its crests move with the wind; measured in the meshes of
        // two times.
        [Test]
        public void Waves_OfOneLength_RunByTheDispersionRelationWithTheWind([Values(0, 90, 210)] double direction,
            [Values(0.25, 12.75)] double time)
        {
            const int cells = 16, reach = 3;
            var settings = SeaFields.Settings(8, cells, 9);
            (settings.WindDirectionDegrees, settings.Choppiness) = (direction, 0);
            var surface = new SeaSurface(settings);
            double[] first = SeaFields.Heights(surface.Mesh(0), cells),
                later = SeaFields.Heights(surface.Mesh(time), cells);
            double windX = Math.Sin(math.radians(direction)), windZ = Math.Cos(math.radians(direction));
            int seen = 0;
            for (int row = -reach; row <= reach; row++)
                for (int column = -reach; column <= reach; column++)
                {
                    Complex before = SeaFields.Amplitude(first, cells, column, row),
                        after = SeaFields.Amplitude(later, cells, column, row);
                    // The wave of each pair that travels with the wind; amplitudes are accurate to 1e-5 m.
                    if (!(column * windX + row * windZ > 1e-9) || before.Magnitude < 0.003)
                        continue;
                    double k = 2 * Math.PI / settings.TileSize * Math.Sqrt(row * row + column * column);
                    var expected = before * Complex.FromPolarCoordinates(1, -Math.Sqrt(Gravity * k) * time);
                    Assert.That((after - expected).Magnitude, Is.LessThan(1e-5), $"wave {column}, {row}");
                    seen++;
                }
            Assert.That(seen, Is.GreaterThan(10));
        }

        // For Phillips, cut off at k: the share of the variance in waves longer than 2 pi / q is
        // exp(1/(kL)^2 - 1/(qL)^2); over directions, cos^2.
        [Test]
        public void Spectrum_OfALargeSea_MatchesTheFormula()
        {
            const int cells = 64, reach = 31, seeds = 40;
            var settings = SeaFields.Settings(cells, cells, 7);
            (settings.TileSize, settings.Choppiness, settings.ShortestWave) = (256, 0, 256.0 / 30);
            double step = 2 * Math.PI / settings.TileSize, longest = 49 / Gravity;
            double[] ends = { 1.5, 6.5, 10.5, 15.5, 30.5 }, bands = new double[4];
            for (int seed = 1; seed <= seeds; seed++)
            {
                settings.Seed = seed;
                var variances =
                    SeaFields.Variances(SeaFields.Heights(new SeaSurface(settings).Mesh(seed), cells), cells, reach);
                for (int row = -reach; row <= reach; row++)
                    for (int column = -reach; column <= reach; column++)
                        for (int band = 0; band < bands.Length; band++)
                            if (math.length(new double2(column, row)) is var n && n > ends[band] && n <= ends[band + 1])
                                bands[band] += variances[row + reach, column + reach] / seeds;
            }
            double Share(double n) =>
                Math.Exp(math.square(1 / (30 * step * longest)) - math.square(1 / (Math.Min(n, 30) * step * longest)));
            double whole = math.square(settings.SignificantWaveHeight) / 16;
            for (int band = 0; band < bands.Length; band++)
                Assert.That(bands[band] / whole,
                    Is.EqualTo(Share(ends[band + 1]) - Share(ends[band])).Within(10).Percent,
                    $"waves {ends[band]} to {ends[band + 1]} a tile");
        }

        // Phillips, cut off at k: the mean square slope is (Hs^2 / 16) E1(1/(kL)^2) e^(1/(kL)^2) / L^2,
        // three quarters of it along the wind.
        [Test]
        public void Slopes_OfALargeSea_MatchTheFormula()
        {
            const int cells = 512;
            var settings = SeaFields.Settings(128, cells, 7);
            (settings.TileSize, settings.Choppiness, settings.ShortestWave) = (256, 0, 8);
            double cell = settings.TileSize / cells, k = 2 * Math.PI / settings.ShortestWave, longest = 49 / Gravity,
                end = math.square(1 / (k * longest));
            double expected = math.square(settings.SignificantWaveHeight) / 16 * ExponentialIntegral(end)
                * Math.Exp(end) / math.square(longest);

            double alongWind = 0, across = 0;
            const int seeds = 4;
            for (int seed = 1; seed <= seeds; seed++)
            {
                settings.Seed = seed;
                var heights = SeaFields.Heights(new SeaSurface(settings).Mesh(0), cells);
                for (int i = 0; i < heights.Length; i++)
                {
                    int x = i % cells, z = i / cells;
                    across += math.square((heights[z * cells + (x + 1) % cells] - heights[i]) / cell)
                        / heights.Length / seeds;
                    alongWind += math.square((heights[(z + 1) % cells * cells + x] - heights[i]) / cell)
                        / heights.Length / seeds;
                }
            }
            // A cell's slope is below the steepest within it by (k cell)^2 / 12 = 1.3 % at the shortest wave.
            Assert.That(alongWind + across, Is.EqualTo(expected).Within(5).Percent);
            Assert.That(alongWind / (alongWind + across), Is.EqualTo(0.75).Within(0.02));
        }

        [Test]
        public void Seed_TheSame_IsTheSameSea_AnotherIsAnother()
        {
            SeaSettings settings = SeaFields.Settings(), other = settings;
            other.Seed = -1;
            var surface = new SeaSurface(settings);
            surface.Mesh(9);
            Assert.That(surface.Mesh(4).Vertices, Is.EqualTo(new SeaSurface(settings).Mesh(4).Vertices),
                "whatever was asked for before");
            Assert.That(new SeaSurface(other).Mesh(4).Vertices, Is.Not.EqualTo(surface.Mesh(4).Vertices));
        }

        // Phillips with little wind: waves that only the finer grid has add little, and the long ones are unchanged.
        [Test]
        public void Grid_Finer_HasTheSameLongWaves()
        {
            var coarse = new SeaSurface(SeaFields.Settings(16)).Modes;
            var fine = new SeaSurface(SeaFields.Settings(64)).Modes.ToDictionary(mode => (mode.Column, mode.Row));
            double ratio = fine[(0, 1)].Real / coarse.First(mode => mode.Column == 0 && mode.Row == 1).Real;
            Assert.That(ratio, Is.InRange(0.9, 1));
            foreach (var mode in coarse)
                Assert.That(fine[(mode.Column, mode.Row)].Imaginary, Is.EqualTo(ratio * mode.Imaginary).Within(1e-12));
        }

        static SeaSurface Displaced(int grid, int cells)
        {
            var settings = SeaFields.Settings(grid, cells);
            settings.Choppiness = 1;
            return new SeaSurface(settings);
        }

        static WaveCoefficients RandomWaves(int reach)
        {
            var random = new System.Random(reach);
            var waves = new WaveCoefficients(reach);
            for (int i = 0; i < waves.Real.Length; i++)
                (waves.Real[i], waves.Imaginary[i]) = (random.NextDouble() - 0.5, random.NextDouble() - 0.5);
            return waves;
        }

        static void AssertNear(double[] field, double[] expected)
        {
            Assert.That(field.Length, Is.EqualTo(expected.Length));
            Assert.That(expected.Max(value => Math.Abs(value)), Is.GreaterThan(0.1));
            for (int i = 0; i < field.Length; i++)
                Assert.That(field[i], Is.EqualTo(expected[i]).Within(1e-9), $"at {i}");
        }

        // E1 by its series, Abramowitz and Stegun 5.1.11.
        static double ExponentialIntegral(double x)
        {
            double sum = -0.5772156649015329 - Math.Log(x), term = -1;
            for (int n = 1; n < 40; n++)
            {
                term *= -x / n;
                sum += term / n;
            }
            return sum;
        }
    }
}
