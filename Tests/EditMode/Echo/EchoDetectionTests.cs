using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class EchoDetectionTests
    {
        const double Rate = 1e-6;

        /// <summary>
        /// The exact rate in white noise over the band, of a cell in the middle of a profile and of one at its end.
        /// With neighbouring cells for reference cells it would be 3 (256 frequencies) to 24 times (130) the asked rate
        /// with the default window.
        /// </summary>
        [Test]
        public void FalseAlarms_OfAProfile_AreAsManyAsAskedFor(
            [Values("taylor", "hann", "hamming", "blackman", "none")] string window,
            [Values(256, 204, 172, 130, 66, 33)] int frequencies)
        {
            int cells = FourierTransform.SizeFor(frequencies);
            var cfar = Detector("ca", Rate).DetectorOf(Window.Named(window), frequencies, cells, 1, 1).cfar;
            var correlation = Correlation(Window.Named(window), frequencies, cells);
            foreach (int cell in new[] { cells / 2, 0 })
                Assert.That(FalseAlarmRate(cfar, cells, cells, cell, correlation, _ => 1) / Rate,
                    Is.InRange(0.85, 1.25), $"cell {cell}");
        }

        /// <summary>
        /// The same of a map, whose first and last rows are neighbours, also where there are few rows.
        /// </summary>
        [TestCase("taylor", 40, 32)]
        [TestCase("taylor", 66, 20)]
        [TestCase("blackman", 40, 17)]
        [TestCase("none", 40, 24)]
        [TestCase("taylor", 66, 5)]
        [TestCase("hann", 66, 2)]
        public void FalseAlarms_OfAMap_AreAsManyAsAskedFor(string window, int frequencies, int pulses)
        {
            int cells = FourierTransform.SizeFor(frequencies), rows = FourierTransform.SizeFor(pulses);
            var (cfar, reach) = Detector("ca", Rate)
                .DetectorOf(Window.Named(window), frequencies, cells, pulses, rows);
            int cell = reach * cells + cells / 2;
            Assert.That(FalseAlarmRate(cfar, cells, cells * (rows + 2 * reach), cell,
                Correlation(Window.Named(window), frequencies, cells), Correlation(Window.Named(window), pulses, rows))
                / Rate, Is.InRange(0.85, 1.25));
        }

        /// <summary>
        /// White noise through the transform, with the default window: about 1,300 false alarms a level, which come in
        /// pairs.
        /// </summary>
        [Test]
        public void FalseAlarms_InNoise_AreAsManyAsAskedFor([Values("ca", "os")] string level)
        {
            const int profiles = 250;
            const double rate = 0.02;
            var window = Window.Named(Window.Names[0]);
            var band = new FrequencyBand(10e9, 1e6, 204);
            var range = new RangeTransform(band, window, 1);
            var cfar = Detector(level, rate).DetectorOf(window, band.Count, range.Cells, 1, 1).cfar;
            var noise = new ThermalNoise(7, 1, 0);
            int alarms = Enumerable.Range(0, profiles).Sum(profile => cfar.Detect(PowerLevel.Of(range.Profile(
                Enumerable.Range(0, band.Count).Select(n => noise.Sample(profile, n)).ToArray())), range.Cells).Count);
            Assert.That(alarms / (double)(profiles * range.Cells), Is.EqualTo(rate).Within(12).Percent);
        }

        static EchoDetection Detector(string level, double rate) =>
            new EchoDetection { Level = level, FalseAlarmRate = rate };

        // Of noise in two cells of a transform of white noise, by their distance.
        static Func<int, double> Correlation(Window window, int samples, int cells)
        {
            double[] powers = window.Weights(samples).Select(weight => weight * weight).ToArray();
            return lag => powers.Select((power, n) =>
                power * Math.Cos(2 * Math.PI * lag * (n - (samples - 1) / 2.0) / cells)).Sum() / powers.Sum();
        }

        // A cell x is a false alarm if |x|^2 > sum w |y|^2 over its reference cells y, of complex normal noise with the
        // covariance C. The form is z* A z with A = diag(1, -w), a sum of exponential numbers with the eigenvalues of
        // A C for their means, of which one is positive (Sylvester). The probability is the mean of exp(-b / positive)
        // over the sum b of the others: the product of 1 / (1 - each / positive).
        static double FalseAlarmRate(Cfar cfar, int columns, int size, int cell, Func<int, double> alongRow,
            Func<int, double> acrossRows)
        {
            var power = new double[size];
            double WeightOf(int other)
            {
                power[other] = 1;
                double weight = cfar.Threshold(power, columns, cell);
                power[other] = 0;
                return weight;
            }

            var weights = Enumerable.Range(0, size).Select(other => (cell: other, weight: -WeightOf(other)))
                .Where(other => other.weight < 0).Prepend((cell, weight: 1)).ToArray();
            Assert.That(weights.Length, Is.GreaterThan(8));
            double[] row = Enumerable.Range(0, columns).Select(alongRow).ToArray(),
                column = Enumerable.Range(0, size / columns).Select(acrossRows).ToArray();
            double[] eigenvalues = Eigenvalues(FormOf(weights.Select(each => each.weight).ToArray(), (i, j) =>
                row[Math.Abs(weights[i].cell % columns - weights[j].cell % columns)]
                    * column[Math.Abs(weights[i].cell / columns - weights[j].cell / columns)]));
            Assert.That(eigenvalues.Count(value => value > 1e-9), Is.EqualTo(1));
            double positive = eigenvalues.Max();
            return 1 / eigenvalues.Where(value => value < positive).Aggregate(1.0,
                (product, value) => product * (1 - value / positive));
        }

        // L' A L of the covariance L L': symmetric, with the eigenvalues of A C.
        static double[,] FormOf(IReadOnlyList<double> weights, Func<int, int, double> covariance)
        {
            int count = weights.Count;
            double[,] root = new double[count, count], form = new double[count, count];
            for (int i = 0; i < count; i++)
                for (int j = 0; j <= i; j++)
                {
                    double rest = covariance(i, j);
                    for (int k = 0; k < j; k++)
                        rest -= root[i, k] * root[j, k];
                    root[i, j] = i == j ? Math.Sqrt(Math.Max(rest, 1e-14)) : rest / root[j, j];
                }
            for (int i = 0; i < count; i++)
                for (int j = 0; j <= i; j++)
                {
                    for (int k = i; k < count; k++)
                        form[i, j] += root[k, i] * weights[k] * root[k, j];
                    form[j, i] = form[i, j];
                }
            return form;
        }

        // Jacobi's rotations.
        static double[] Eigenvalues(double[,] matrix)
        {
            int count = matrix.GetLength(0);
            for (int sweep = 0; sweep < 12; sweep++)
                for (int p = 0; p < count; p++)
                    for (int q = p + 1; q < count; q++)
                    {
                        if (Math.Abs(matrix[p, q]) < 1e-13)
                            continue;
                        double angle = 0.5 * Math.Atan2(2 * matrix[p, q], matrix[p, p] - matrix[q, q]),
                            cosine = Math.Cos(angle), sine = Math.Sin(angle);
                        for (int k = 0; k < count; k++)
                            (matrix[k, p], matrix[k, q]) = (cosine * matrix[k, p] + sine * matrix[k, q],
                                cosine * matrix[k, q] - sine * matrix[k, p]);
                        for (int k = 0; k < count; k++)
                            (matrix[p, k], matrix[q, k]) = (cosine * matrix[p, k] + sine * matrix[q, k],
                                cosine * matrix[q, k] - sine * matrix[p, k]);
                    }
            return Enumerable.Range(0, count).Select(i => matrix[i, i]).ToArray();
        }
    }
}
