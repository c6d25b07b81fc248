using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class WindowTests
    {
        // Widths in bins at a half and a quarter of the power, highest sidelobe and noise loss in decibels, of 1,024
        // weights, summed term by term by another program. Taylor's windows are those of his formula over N samples;
        // periodic ones, which leave out the last of N + 1, differ by 0.001 bins and 0.16 dB.
        static IEnumerable<TestCaseData> Figures()
        {
            yield return Case("none", Window.None, 0.886, 1.207, -13.26, 0);
            yield return Case("Taylor 4, -30", Window.Taylor(4, -30), 1.1247, 1.5564, -30.307, 0.6885);
            yield return Case("Taylor 4, -35", Window.Taylor(4, -35), 1.1842, 1.6429, -35.167, 0.9141);
            yield return Case("Taylor 5, -40", Window.Taylor(5, -40), 1.2460, 1.7323, -40.131, 1.1412);
            yield return Case("Hamming", Window.Hamming, 1.303, 1.815, -42.67, 1.344);
            yield return Case("Hann", Window.Hann, 1.441, 2.000, -31.47, 1.761);
            yield return Case("Blackman", Window.Blackman, 1.644, 2.299, -58.11, 2.372);
        }

        [TestCaseSource(nameof(Figures))]
        public void Figures_OfEachWindow_AreThePublishedOnes(Window window, double width, double quarterWidth,
            double sidelobe, double loss)
        {
            Assert.That(window.Width(0.5), Is.EqualTo(width).Within(6e-4));
            Assert.That(window.Width(0.25), Is.EqualTo(quarterWidth).Within(6e-4));
            Assert.That(window.SidelobeDb, Is.EqualTo(sidelobe).Within(6e-3));
            Assert.That(10 * Math.Log10(window.NoiseBandwidth), Is.EqualTo(loss).Within(6e-4));
        }

        // The figures are computed from coefficients; here they are measured on the weights themselves.
        [TestCaseSource(nameof(Figures))]
        public void Weights_OfEachWindow_HaveItsFigures(Window window, double width, double quarterWidth,
            double sidelobe, double loss)
        {
            double[] weights = window.Weights(256);
            double sum = weights.Sum();
            Assert.That(sum / 256, Is.EqualTo(window.CoherentGain).Within(1e-12));
            Assert.That(256 * weights.Sum(weight => weight * weight) / (sum * sum),
                Is.EqualTo(window.NoiseBandwidth).Within(1e-12));
            Assert.That(Level(weights, width / 2), Is.EqualTo(10 * Math.Log10(0.5)).Within(0.01));
            Assert.That(Level(weights, quarterWidth / 2), Is.EqualTo(10 * Math.Log10(0.25)).Within(0.01));
            double firstNull = Enumerable.Range(0, 1000).Select(i => 0.01 * i)
                .First(bins => Level(weights, bins) < -59 && Level(weights, bins) < Level(weights, bins + 0.01)
                    || Level(weights, bins) < -90);
            Assert.That(Enumerable.Range(0, 1500).Max(i => Level(weights, firstNull + 0.01 * i)),
                Is.EqualTo(sidelobe).Within(0.02));
        }

        [Test]
        public void Weights_OfAnyCount_AreSymmetricAndAtMostOne([Values(1, 2, 7, 64)] int count)
        {
            foreach (var window in new[] { Window.None, Window.Hann, Window.Blackman, Window.Taylor(4, -35) })
            {
                double[] weights = window.Weights(count);
                Assert.That(weights, Is.EqualTo(Enumerable.Reverse(weights)).Within(1e-15));
                Assert.That(weights.Max(), Is.LessThanOrEqualTo(1 + 1e-15));
                if (count % 2 == 1)
                    Assert.That(weights[count / 2], Is.EqualTo(1).Within(1e-15));
            }
        }

        [Test]
        public void Gain_OfTheCosineWindows_IsThatOfTheirFirstCoefficient()
        {
            Assert.That(Window.None.CoherentGain, Is.EqualTo(1));
            Assert.That(Window.Hann.CoherentGain, Is.EqualTo(0.5));
            Assert.That(Window.Hamming.CoherentGain, Is.EqualTo(0.54).Within(1e-15));
            Assert.That(Window.Blackman.CoherentGain, Is.EqualTo(0.42).Within(1e-15));
            Assert.That(Window.Hann.NoiseBandwidth, Is.EqualTo(1.5));
        }

        [Test]
        public void Taylor_OutOfRange_IsRefusedWithItsRange()
        {
            Assert.That(() => Window.Taylor(1, -30), Throws.TypeOf<GlintException>().With.Message
                .EqualTo("window: the Taylor number of near sidelobes is 1, it must be from 2 to 20"));
            Assert.That(() => Window.Taylor(4, 30), Throws.TypeOf<GlintException>().With.Message
                .EqualTo("window: the Taylor sidelobe level is 30 dB, it must be from -100 to -15"));
            Assert.That(() => Window.Taylor(4, double.NaN), Throws.TypeOf<GlintException>());
        }

        static TestCaseData Case(string name, Window window, double width, double quarterWidth, double sidelobe,
            double loss) => new TestCaseData(window, width, quarterWidth, sidelobe, loss).SetName("{m}(" + name + ")");

        // Decibels of the weights' transform at a distance from its peak.
        static double Level(double[] weights, double bins)
        {
            var sum = Complex.Zero;
            for (int n = 0; n < weights.Length; n++)
                sum += weights[n] * Complex.FromPolarCoordinates(1, 2 * Math.PI * bins * n / weights.Length);
            return 20 * Math.Log10(Complex.Abs(sum) / weights.Sum());
        }
    }
}
