using System;
using System.Linq;
using System.Numerics;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class ThermalNoiseTests
    {
        const int Pulses = 200, Samples = 500;

        [Test]
        public void Density_AtTheStandardTemperature_IsKnown() =>
            Assert.That(PowerLevel.ToDecibels(ThermalNoise.Density), Is.EqualTo(-203.98).Within(0.005));

        // 100,000 samples: the mean power has a relative spread of 0.32 %, the correlations one of 0.32 %.
        [Test]
        public void Samples_OfManyPulses_AreComplexNormalAndIndependent()
        {
            var noise = new ThermalNoise(5, 1e6, 3);
            var all = Enumerable.Range(0, Pulses).Select(pulse => Enumerable.Range(0, Samples)
                .Select(sample => noise.Sample(pulse, sample) / Math.Sqrt(noise.Power)).ToArray()).ToArray();
            var flat = all.SelectMany(pulse => pulse).ToArray();
            Assert.That(noise.Power, Is.EqualTo(1.380649e-23 * 290 * 1e6 * Math.Pow(10, 0.3)).Within(1e-9).Percent);
            Assert.That(flat.Average(z => z.Real * z.Real), Is.EqualTo(0.5).Within(2).Percent);
            Assert.That(flat.Average(z => z.Imaginary * z.Imaginary), Is.EqualTo(0.5).Within(2).Percent);
            Assert.That(flat.Average(z => z.Real * z.Imaginary), Is.EqualTo(0).Within(0.01));
            foreach (double power in new[] { 0.1, 1, 3 })
                Assert.That(PowerLevel.Of(flat).Count(p => p > power) / (double)flat.Length,
                    Is.EqualTo(Math.Exp(-power)).Within(0.006), "exponential power");
            Assert.That(Correlation(flat, flat.Skip(1).ToArray()), Is.LessThan(0.012), "next sample");
            Assert.That(Correlation(flat, all.Skip(1).SelectMany(pulse => pulse).ToArray()), Is.LessThan(0.012),
                "next pulse");
            var other = new ThermalNoise(6, 1e6, 3);
            var others = Enumerable.Range(0, Samples).SelectMany(pulse => Enumerable.Range(0, Pulses)
                .Select(sample => other.Sample(pulse, sample) / Math.Sqrt(noise.Power))).ToArray();
            Assert.That(Correlation(flat, others), Is.LessThan(0.012), "next seed");
        }

        // The same integers and the same elementary functions on every machine.
        [Test]
        public void Sample_OfASeed_IsTheSameInAnyOrder()
        {
            var noise = new ThermalNoise(5, 1e6, 3);
            var pulse = noise.AddTo(new Complex[8], 3);
            for (int sample = 7; sample >= 0; sample--)
                Assert.That(new ThermalNoise(5, 1e6, 3).Sample(3, sample), Is.EqualTo(pulse[sample]));
            Assert.That(noise.AddTo(new Complex[] { 1 }, 3)[0], Is.EqualTo(1 + pulse[0]));
            Assert.That(noise.Sample(4, 0), Is.Not.EqualTo(pulse[0]));
        }

        // N samples of noise power P: a target of N coherent samples keeps its power, noise has P / N times the
        // window's noise bandwidth.
        [Test]
        public void Profile_OfNoise_HasItsPowerInTheWindowsBandwidth()
        {
            var band = PointEchoes.Band();
            var noise = new ThermalNoise(1, 150e6, 5);
            foreach (var window in new[] { Window.None, Window.Hann, Window.Taylor(4, -35) })
            {
                var transform = new RangeTransform(band, window, 1);
                double mean = Enumerable.Range(0, 200).Average(pulse =>
                    PowerLevel.Of(transform.Profile(noise.AddTo(new Complex[256], pulse))).Average());
                Assert.That(mean, Is.EqualTo(noise.Power / 256 * window.NoiseBandwidth).Within(2).Percent);
            }
        }

        static double Correlation(Complex[] a, Complex[] b) =>
            Complex.Abs(a.Zip(b, (x, y) => x * Complex.Conjugate(y)).Aggregate(Complex.Add))
                / Math.Min(a.Length, b.Length);
    }
}
