using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class CfarTests
    {
        const int Cells = 1000000;

        [TestCase(16, 1e-2, 5.3363)]
        [TestCase(16, 1e-4, 12.4525)]
        [TestCase(16, 1e-6, 21.9420)]
        [TestCase(32, 1e-2, 4.9530)]
        [TestCase(32, 1e-4, 10.6727)]
        [TestCase(32, 1e-6, 17.2776)]
        public void Factor_OfTheMean_IsKnown(int cells, double rate, double factor) =>
            Assert.That(Cfar.Factor(CfarLevel.Mean, cells, rate), Is.EqualTo(factor).Within(5e-5));

        // Loss against a threshold over known noise, -ln of the rate.
        [TestCase(16, 1e-4, 1.31)]
        [TestCase(32, 1e-4, 0.64)]
        [TestCase(16, 1e-6, 2.01)]
        [TestCase(32, 1e-6, 0.97)]
        public void Loss_OfTheMean_IsKnown(int cells, double rate, double loss) =>
            Assert.That(10 * Math.Log10(Cfar.Factor(CfarLevel.Mean, cells, rate) / -Math.Log(rate)),
                Is.EqualTo(loss).Within(0.005));

        // Of N exponential powers the one of rank k is a sum of independent ones with means 1 / i, i from N - k + 1
        // to N. The mean of exp(-factor times it) is the rate.
        [TestCase(16, 1e-4)]
        [TestCase(32, 1e-6)]
        public void Factor_OfTheRank_GivesTheRate(int cells, double rate)
        {
            double factor = Cfar.Factor(CfarLevel.Rank, cells, rate), logarithm = 0;
            for (int i = cells / 4 + 1; i <= cells; i++)
                logarithm -= Math.Log(1 + factor / i);
            Assert.That(Math.Exp(logarithm), Is.EqualTo(rate).Within(1e-6).Percent);
        }

        // 1,000 false alarms in a million cells have a spread of 3.2 %.
        [Test]
        public void FalseAlarms_InNoise_AreAsManyAsAskedFor([Values] CfarLevel level)
        {
            double[] noise = Noise(Cells);
            Assert.That(new Cfar(level, 1e-3, 16, 2).Detect(noise, Cells).Count / (double)Cells,
                Is.EqualTo(1e-3).Within(10).Percent, "profile");
            Assert.That(new Cfar(level, 1e-2, 4, 1, 2, 1).Detect(noise.Take(200000).ToArray(), 500).Count / 2e5,
                Is.EqualTo(1e-2).Within(8).Percent, "map");
        }

        // Only the first and the last cells of rows, whose reference cells are fewer.
        [Test]
        public void FalseAlarms_AtTheEdges_AreAsManyAsInside([Values] CfarLevel level)
        {
            const int columns = 40;
            var cfar = new Cfar(level, 1e-2, 8, 2);
            double[] noise = Noise(400000);
            int alarms = Enumerable.Range(0, noise.Length / columns).Sum(row =>
                cfar.Detect(noise.Skip(row * columns).Take(columns).ToArray(), columns)
                    .Count(column => column < 8 || column >= columns - 8));
            Assert.That(alarms / (noise.Length / columns * 16.0), Is.EqualTo(1e-2).Within(8).Percent);
        }

        // K clutter: exponential speckle times a gamma-distributed texture of shape nu and mean 1. Rates of another
        // simulation; a texture that all cells share changes nothing.
        [TestCase(0.5, 2.7e-2)]
        [TestCase(1, 1.7e-2)]
        [TestCase(5, 4.2e-3)]
        public void FalseAlarms_InKClutter_RiseWithItsSpikes(double nu, double rate)
        {
            const int cells = 500000;
            var random = new Random(3);
            double[] speckle = Noise(cells),
                clutter = speckle.Select(power => power * Texture(random, nu)).ToArray();
            var cfar = new Cfar(CfarLevel.Mean, 1e-3, 16, 0);
            Assert.That(cfar.Detect(clutter, cells).Count / (double)cells, Is.EqualTo(rate).Within(5).Percent);
            var common = speckle.Select(power => power * 7.5).ToArray();
            Assert.That(cfar.Detect(common, cells), Is.EqualTo(cfar.Detect(speckle, cells)));
        }

        // Thresholds are about 17 times the noise.
        [Test]
        public void Target_AboveTheNoise_IsDetected([Values] CfarLevel level)
        {
            double[] power = Noise(200);
            power[100] = 60;
            var cfar = new Cfar(level, 1e-6, 16, 2);
            Assert.That(cfar.Detect(power, 200), Is.EqualTo(new[] { 100 }));
            power[100] = 2;
            Assert.That(cfar.Detect(power, 200), Is.Empty);
        }

        [Test]
        public void GuardCells_KeepATargetsWidthOutOfItsThreshold()
        {
            var power = Enumerable.Repeat(1.0, 101).ToArray();
            (power[49], power[50], power[51]) = (50, 85, 50);
            Assert.That(new Cfar(CfarLevel.Mean, 1e-4, 8, 0).Detect(power, 101), Is.Empty);
            Assert.That(new Cfar(CfarLevel.Mean, 1e-4, 8, 1).Detect(power, 101), Is.EqualTo(new[] { 50 }));
        }

        // Two equal targets among each other's reference cells: each raises the mean, but not the rank.
        [Test]
        public void Rank_OfTwoTargetsNearEachOther_DetectsBoth()
        {
            var power = Enumerable.Repeat(1.0, 101).ToArray();
            power[50] = power[56] = 100;
            Assert.That(new Cfar(CfarLevel.Mean, 1e-6, 8, 2).Detect(power, 101), Is.Empty);
            Assert.That(new Cfar(CfarLevel.Rank, 1e-6, 8, 2).Detect(power, 101), Is.EqualTo(new[] { 50, 56 }));
        }

        // Along the rows the neighbours are those of a map, not of a list: a row's end does not touch the next row.
        [Test]
        public void Map_TakesReferencesFromItsOwnRowsAlone()
        {
            var power = Enumerable.Repeat(1.0, 5 * 20).ToArray();
            power[2 * 20] = 100;
            power[20 + 19] = power[20 + 17] = 1000;
            Assert.That(new Cfar(CfarLevel.Mean, 1e-2, 8, 0).Detect(power, 20), Does.Contain(40));
            Assert.That(new Cfar(CfarLevel.Mean, 1e-2, 1, 0, 1, 0).Detect(power, 20), Does.Contain(40));
        }

        [Test]
        public void WrongNumbers_AreRefused()
        {
            Assert.That(() => new Cfar(CfarLevel.Mean, 0, 8, 1), Throws.TypeOf<GlintException>().With.Message
                .EqualTo("CFAR: the false-alarm rate is 0, it must be from 1e-12 to 0.5"));
            Assert.That(() => new Cfar(CfarLevel.Mean, 1e-3, 0, 1), Throws.TypeOf<GlintException>().With.Message
                .EqualTo("CFAR: the number of reference cells on a side is 0, it must be from 1 to 200"));
            Assert.That(() => new Cfar(CfarLevel.Mean, 1e-3, 8, 1).Detect(new double[10], 4),
                Throws.TypeOf<GlintException>().With.Message.EqualTo("CFAR: 10 cells do not fill rows of 4"));
        }

        // Exponential powers of mean 1.
        static double[] Noise(int count)
        {
            var noise = new ThermalNoise(11, 1, 0);
            return PowerLevel.Of(Enumerable.Range(0, count)
                .Select(i => noise.Sample(i / 1000, i % 1000) / Math.Sqrt(noise.Power))).ToArray();
        }

        // Gamma of shape 1/2 is the square of a normal number, of a whole shape the sum of exponential ones.
        static double Texture(Random random, double nu)
        {
            if (nu == 0.5)
                return -2 * Math.Log(1 - random.NextDouble())
                    * Math.Pow(Math.Cos(2 * Math.PI * random.NextDouble()), 2);
            return Enumerable.Range(0, (int)nu).Average(_ => -Math.Log(1 - random.NextDouble()));
        }
    }
}
