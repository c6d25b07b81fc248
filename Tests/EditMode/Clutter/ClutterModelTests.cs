using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>The formulas of mean sea reflectivity against tables computed by another program.</summary>
    public sealed class ClutterModelTests
    {
        static readonly double[] s_belowTen = { 0.1, 0.3, 1, 3, 10 };

        [TestCase("hh", 0, -78.88, -71.63, -66.01, -61.05, -52.99, -40.34, -21.13)]
        [TestCase("hh", 3, -55.01, -48.02, -43.27, -40.48, -37.60, -31.43, -15.68)]
        [TestCase("hh", 6, -42.57, -35.74, -31.50, -30.00, -30.07, -27.34, -13.29)]
        [TestCase("vv", 0, -75.55, -66.79, -60.33, -54.72, -45.42, -33.46, -22.03)]
        [TestCase("vv", 3, -55.47, -46.93, -41.20, -37.41, -32.47, -25.97, -17.44)]
        [TestCase("vv", 6, -45.00, -36.59, -31.30, -28.59, -26.14, -22.53, -15.43)]
        public void Nrl_AtTenGigahertz_IsTheTable(string polarisation, double state, params double[] expected) =>
            AssertRow("nrl", polarisation, state, s_belowTen.Concat(new[] { 30, 60.0 }).ToArray(), expected);

        [TestCase("hh", 9.4, 0.5, 4, -41.45)]
        [TestCase("vv", 3, 2, 5, -37.32)]
        [TestCase("hh", 16, 20, 2, -35.68)]
        // 2.1555e-4, published with MathWorks' function seareflectivity.
        [TestCase("hh", 30, 10, 2, -36.6645)]
        public void Nrl_AtOtherFrequencies_HasThePublishedValues(string polarisation, double gigahertz, double grazing,
            double state, double expected) => Assert.That(Decibels("nrl", polarisation, gigahertz, grazing, state),
                Is.EqualTo(expected).Within(0.0051));

        [TestCase("hh", 3, -70.30, -49.72, -37.39, -35.42, -34.35)]
        [TestCase("hh", 5, -42.55, -33.66, -31.45, -29.83, -28.77)]
        [TestCase("vv", 3, -71.79, -49.86, -36.02, -32.65, -30.06)]
        public void Git_Upwind_IsTheTable(string polarisation, double state, params double[] expected) =>
            AssertRow("git", polarisation, state, s_belowTen, expected);

        [TestCase("hh", 1, -64.79, -55.77, -47.69, -43.32, -40.86)]
        [TestCase("hh", 3, -48.10, -40.84, -36.07, -33.75, -32.35)]
        [TestCase("hh", 5, -38.91, -33.79, -30.62, -28.82, -27.79)]
        [TestCase("vv", 3, -49.94, -41.32, -35.05, -31.33, -28.42)]
        public void Tsc_Upwind_IsTheTable(string polarisation, double state, params double[] expected) =>
            AssertRow("tsc", polarisation, state, s_belowTen, expected);

        [TestCase("vv", 1, -60.80, -51.26, -40.80, -31.26, -25.35)]
        [TestCase("vv", 3, -50.80, -41.26, -34.90, -30.13, -24.90)]
        [TestCase("vv", 5, -40.80, -34.56, -29.33, -24.56, -19.33)]
        [TestCase("hh", 3, -48.80, -40.64, -35.82, -32.47, -28.81)]
        public void Hybrid_Upwind_IsTheTable(string polarisation, double state, params double[] expected) =>
            AssertRow("hybrid", polarisation, state, s_belowTen, expected);

        // The mean of the hybrid model's directions lies 3.85 dB below upwind at X band, as NRL's report says of
        // crosswind.
        [Test]
        public void Hybrid_Crosswind_IsLowerAsPublished() => Assert.That(
            Decibels("hybrid", "vv", 9.3, 1, 3) - Decibels("hybrid", "vv", 9.3, 1, 3, 90),
            Is.EqualTo(3.85).Within(0.2));

        [TestCase("git")]
        [TestCase("tsc")]
        [TestCase("hybrid")]
        public void Models_WithAWind_AreHighestUpwind(string name)
        {
            double Level(double angle) => Decibels(name, "vv", 10, 1, 3, angle);
            Assert.That(Level(0), Is.GreaterThan(Level(90)));
            Assert.That(Level(90), Is.GreaterThan(Level(180)));
            Assert.That(Level(-70), Is.EqualTo(Level(70)).Within(1e-9));
        }

        // Between its branches the steps of the published formulas are small against their deviation from measurements.
        [TestCase("hybrid", "hh", 10, 10.0001, 1.5)]
        [TestCase("hybrid", "vv", 12.5, 12.5001, 0.5)]
        [TestCase("git", "vv", 2.9999, 3, 2)]
        [TestCase("tsc", "vv", 1.9999, 2, 3)]
        public void Branches_MeetWithinDecibels(string name, string polarisation, double before, double after,
            double step) => Assert.That(Decibels(name, polarisation, before, 1, 3),
                Is.EqualTo(Decibels(name, polarisation, after, 1, 3)).Within(step));

        [TestCase("nrl", 0.4, 1, 3, "frequency 0.4 GHz must be from 0.5 to 35 GHz")]
        [TestCase("nrl", 10, 61, 3, "grazing angle 61 deg must be from 0.1 to 60 deg")]
        [TestCase("nrl", 10, 1, 7, "sea state 7 must be from 0 to 6,")]
        [TestCase("git", 10, 12, 3, "grazing angle 12 deg")]
        [TestCase("git", 10, 1, 0.5, "sea state 0.5")]
        [TestCase("tsc", 36, 1, 3, "frequency 36 GHz")]
        [TestCase("hybrid", 2, 1, 3, "frequency 2 GHz")]
        [TestCase("hybrid", 10, double.NaN, 3, "grazing angle NaN deg")]
        public void Conditions_OutOfRange_AreRefused(string name, double gigahertz, double grazing, double state,
            string says) => Assert.That(() => Decibels(name, "vv", gigahertz, grazing, state), Throws
                .TypeOf<GlintException>().With.Message.Contains(says).And.Message.StartsWith("clutter model " + name));

        [Test]
        public void Polarisation_ThatIsCrossed_IsRefused() => Assert.That(() => Decibels("nrl", "hv", 10, 1, 3),
            Throws.TypeOf<GlintException>().With.Message.Contains("no hv"));

        [TestCase(0, 0.04)]
        [TestCase(1, 0.14)]
        [TestCase(2, 0.47)]
        [TestCase(3, 1.04)]
        [TestCase(4, 1.88)]
        [TestCase(5, 2.98)]
        [TestCase(6, 4.35)]
        public void SeaState_HasNathansonsWaveHeight(double state, double height)
        {
            Assert.That(SeaStateFits.WaveHeight(state), Is.EqualTo(height).Within(0.0051));
            Assert.That(SeaStateFits.OfWaveHeight(SeaStateFits.WaveHeight(state)), Is.EqualTo(state).Within(1e-9));
        }

        [TestCase(1, 3.3)]
        [TestCase(2, 5.3)]
        [TestCase(3, 7.3)]
        [TestCase(4, 9.2)]
        [TestCase(5, 11.1)]
        [TestCase(6, 12.9)]
        public void SeaState_HasThePublishedWind(double state, double wind)
        {
            double height = SeaStateFits.WaveHeight(state);
            Assert.That(SeaStateFits.Wind(height), Is.EqualTo(wind).Within(0.051));
            Assert.That(SeaStateFits.WaveHeightOfWind(SeaStateFits.Wind(height)), Is.EqualTo(height).Within(1e-9));
        }

        // Hs = 0.00724 v^2.5, as the report rounds it.
        [Test]
        public void WaveHeightOfWind_IsTheReports() =>
            Assert.That(SeaStateFits.WaveHeightOfWind(10), Is.EqualTo(0.00724 * Math.Pow(10, 2.5)).Within(0.1).Percent);

        // JONSWAP without a peak, alpha / 2 k^-3 exp(-1.25 (peak / k)^2), has the variance alpha / (5 peak^2).
        [TestCase(1e4)]
        [TestCase(1e5)]
        public void SeaState_OfALimitedFetch_IsThatOfTheSpectrumsHeight(double fetch)
        {
            const double wind = 10, gravity = 9.81;
            double alpha = 0.076 * Math.Pow(wind * wind / (fetch * gravity), 0.22),
                frequency = 22 * Math.Pow(gravity * gravity / (wind * fetch), 1.0 / 3),
                peak = frequency * frequency / gravity, height = 4 * Math.Sqrt(alpha / 5) / peak;
            var waves = SeaSettings.Default;
            (waves.Kind, waves.WindSpeed, waves.Fetch, waves.PeakEnhancement, waves.SignificantWaveHeight) =
                (SeaSpectrumKind.Jonswap, wind, fetch, 1, 0);
            var clutter = new SeaClutter(new SeaSurface(waves), 0, new double3(0, 0, 1), SeaClutterSettings.On);
            Assert.That(clutter.SeaState, Is.EqualTo(SeaStateFits.OfWaveHeight(height)).Within(0.1).Percent);
        }

        [Test]
        public void SeaState_OutOfRange_IsRefused()
        {
            Assert.That(() => SeaStateFits.WaveHeight(7), Throws.TypeOf<GlintException>().With.Message.Contains("7"));
            Assert.That(() => SeaStateFits.Wind(-1), Throws.TypeOf<GlintException>().With.Message.Contains("-1 m"));
            Assert.That(() => SeaStateFits.WaveHeightOfWind(25), Throws.TypeOf<GlintException>().With.Message
                .Contains("25 m/s"));
            Assert.That(() => SeaStateFits.OfWaveHeight(5), Throws.TypeOf<GlintException>());
        }

        // The tables were computed with 3e8 m/s: up to 0.012 dB.
        static void AssertRow(string name, string polarisation, double state, double[] grazing, double[] expected)
        {
            for (int i = 0; i < grazing.Length; i++)
                Assert.That(Decibels(name, polarisation, 10, grazing[i], state), Is.EqualTo(expected[i]).Within(0.012),
                    $"{grazing[i]} deg");
        }

        static double Decibels(string name, string polarisation, double gigahertz, double grazing, double state,
            double windAngle = 0) => ClutterModel.All.Single(model => model.Name == name).Decibels(
                Polarisation.All.Single(it => it.Name == polarisation),
                new ClutterConditions(gigahertz * 1e9, grazing, state, windAngle));
    }
}
