using System;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Glint.Core;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Tests
{
    public sealed class PortableMathTests
    {
        const int Steps = 50001;

        // System.Math is itself off by up to one unit in the last place, 1.1e-16 to 2.2e-16 of the value.
        const double OfSystem = 2.3e-16;

        [TestCase(-700, 700)]
        [TestCase(-1, 1)]
        [TestCase(-1e-9, 1e-9)]
        public void Exp_EqualsSystems(double from, double to) =>
            AssertNear(from, to, PortableMath.Exp, Math.Exp,
                x => (PortableMath.RelativeError + OfSystem) * Math.Exp(x));

        [TestCase(1e-300, 1e-290)]
        [TestCase(1e-9, 0.5)]
        [TestCase(0.5, 2)]
        [TestCase(2, 1e9)]
        [TestCase(1e290, 1e300)]
        public void Log_EqualsSystems(double from, double to) =>
            AssertNear(from, to, PortableMath.Log, Math.Log,
                x => (PortableMath.RelativeError + OfSystem) * Math.Abs(Math.Log(x)));

        [TestCase(-1, 1)]
        [TestCase(0.1249, 0.1251)]
        public void SinCos_EqualsSystems(double from, double to)
        {
            // The turn in radians is rounded before System.Math sees it.
            Func<double, double> bound = turns =>
                PortableMath.SinCosError + OfSystem / 2 + 2 * Math.PI * Math.Abs(turns) * OfSystem;
            AssertNear(from, to, turns => PortableMath.SinCos(turns).Sine,
                turns => Math.Sin(2 * Math.PI * turns), bound);
            AssertNear(from, to, turns => PortableMath.SinCos(turns).Cosine,
                turns => Math.Cos(2 * Math.PI * turns), bound);
        }

        // Whole turns do not matter, however many: 2^40 + 1/32 is exact.
        [Test]
        public void SinCos_AfterManyTurns_IsTheSame()
        {
            Assert.That(PortableMath.SinCos((1L << 40) + 1 / 32.0), Is.EqualTo(PortableMath.SinCos(1 / 32.0)));
            Assert.That(PortableMath.SinCos(-(1L << 40) + 1 / 32.0), Is.EqualTo(PortableMath.SinCos(1 / 32.0)));
        }

        [TestCase(0, 0, 1)]
        [TestCase(0.25, 1, 0)]
        [TestCase(0.5, 0, -1)]
        [TestCase(0.75, -1, 0)]
        [TestCase(-0.25, -1, 0)]
        [TestCase(-1e-30, 0, 1)]
        public void SinCos_OfQuarters_IsExact(double turns, double sine, double cosine) =>
            Assert.That(PortableMath.SinCos(turns), Is.EqualTo((sine, cosine)));

        [Test]
        public void Exp_OfWhatIsTooSmall_IsZero() =>
            Assert.That(new[] { PortableMath.Exp(PortableMath.MinExponent - 1), PortableMath.Exp(-1e300),
                PortableMath.Exp(double.NegativeInfinity) }, Is.All.EqualTo(0));

        [Test]
        public void Pow_OfARoot_EqualsSystems() =>
            Assert.That(PortableMath.Pow(2, 0.5), Is.EqualTo(Math.Sqrt(2)).Within(1e-15));

        // The first five outputs for these seeds, as published with implementations in several languages.
        [TestCase(1234567UL, 6457827717110365317UL, 3203168211198807973UL, 9817491932198370423UL,
            4593380528125082431UL, 16408922859458223821UL)]
        [TestCase(0UL, 0xE220A8397B1DCDAFUL, 0x6E789E6AA1B965F4UL, 0x06C45D188009454FUL,
            0xF88BB8A8724C81ECUL, 0x1B39896A51A8749BUL)]
        public void SplitMix64_OfAKnownSeed_GivesThePublishedNumbers(ulong seed, ulong a, ulong b,
            ulong c, ulong d, ulong e)
        {
            var random = new SplitMix64(seed);
            Assert.That(new[] { random.Next(), random.Next(), random.Next(), random.Next(), random.Next() },
                Is.EqualTo(new[] { a, b, c, d, e }));
        }

        [Test]
        public void SplitMix64_Uniform_IsAboveZeroAndUpToOne()
        {
            var random = new SplitMix64(1);
            var drawn = Enumerable.Range(0, 100000).Select(i => random.NextAboveZero()).ToArray();
            Assert.That(drawn.Min(), Is.GreaterThan(0).And.LessThan(1e-3));
            Assert.That(drawn.Max(), Is.LessThanOrEqualTo(1).And.GreaterThan(0.999));
            // Standard deviation of the mean: 1 / sqrt(12 x 100,000) = 0.0009.
            Assert.That(drawn.Average(), Is.EqualTo(0.5).Within(0.004));
        }

        // Other functions of System.Math differ between platforms, those of Unity.Mathematics call System.Math, and
        // threads may add in any order.
        [Test]
        public void Sources_OfTheSea_UseOnlyWhatIsTheSameEverywhere()
        {
            string folder = Path.Combine(Application.dataPath, "../Packages/com.glint.radar/Core/Sea");
            var allowed = new[] { "Math.Sqrt", "Math.Floor", "Math.Abs", "Math.PI" };
            foreach (string file in Directory.GetFiles(folder, "*.cs"))
            {
                string text = File.ReadAllText(file);
                var used = Regex.Matches(text, @"(?<!Portable)\b(Math|MathF|Mathf|math)\.\w+").Cast<Match>()
                    .Select(match => match.Value).Where(name => !allowed.Contains(name));
                Assert.That(used, Is.Empty, Path.GetFileName(file));
                Assert.That(text, Does.Not.Match(@"\b(Parallel|AsParallel|Vector<|FusedMultiplyAdd|System\.Random)\b"),
                    Path.GetFileName(file));
            }
        }

        static void AssertNear(double from, double to, Func<double, double> own, Func<double, double> systems,
            Func<double, double> bound)
        {
            for (int i = 0; i < Steps; i++)
            {
                double x = from + (to - from) * i / (Steps - 1), off = own(x) - systems(x);
                if (!(Math.Abs(off) <= bound(x)))
                    Assert.Fail($"at {x:R}: {own(x):R}, and System.Math has {systems(x):R}: off by {off:R}, "
                        + $"and the bound is {bound(x):R}");
            }
        }
    }
}
