using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>Speckle is Gaussian, of mean square 1, and independent between cells, seeds and times.</summary>
    public sealed class SpeckleTests
    {
        const int Side = 256;

        // Five standard deviations of the mean of so many samples.
        const double Five = 5.0 / Side;

        [Test]
        public void Intensities_AreExponential()
        {
            AssertExponential(Cells().Select(cell => Power(Speckle.At(cell, 7, 0).Approaching)));
            AssertExponential(Cells().Select(cell => Power(Speckle.At(cell, 7, -3).Receding)));
            AssertExponential(Cells().Select(cell => Power(Speckle.Between(cell, 7, 12.3).Receding)));
        }

        // Parts are Gaussian: no mean, variance 1/2 each, uncorrelated.
        [Test]
        public void Parts_AreCircular()
        {
            var numbers = Cells().Select(cell => Speckle.At(cell, 1, 5).Approaching).ToArray();
            Assert.That(Complex.Abs(numbers.Aggregate(Complex.Zero, (sum, g) => sum + g) / numbers.Length),
                Is.LessThan(Five));
            Assert.That(Complex.Abs(numbers.Aggregate(Complex.Zero, (sum, g) => sum + g * g) / numbers.Length),
                Is.LessThan(1.5 * Five));
        }

        [Test]
        public void Numbers_OfOtherCellsSeedsTimesAndWaves_AreIndependent()
        {
            Complex Here(int2 cell) => Speckle.At(cell, 7, 0).Approaching;
            var others = new Func<int2, Complex>[]
            {
                cell => Speckle.At(cell + new int2(1, 0), 7, 0).Approaching,
                cell => Speckle.At(cell + new int2(0, 1), 7, 0).Approaching,
                cell => Speckle.At(cell.yx, 7, 0).Approaching,
                cell => Speckle.At(cell, 8, 0).Approaching,
                cell => Speckle.At(cell, 7, 1).Approaching,
                cell => Speckle.At(cell, 7, -1).Approaching,
                cell => Speckle.At(cell, 7, 0).Receding
            };
            foreach (var other in others)
                Assert.That(Complex.Abs(Correlation(Here, other)), Is.LessThan(Five), Array.IndexOf(others, other)
                    .ToString());
        }

        // Two cells with the same number would be a pattern on the sea.
        [Test]
        public void Numbers_OfAllCells_AreDistinct() => Assert.That(
            Cells().Select(cell => Speckle.At(cell, 0, 0)).Distinct().Count(), Is.EqualTo(Side * Side));

        // At any time, as the cells begin at fractions of their own, the correlation is near exp(-t^2).
        [Test]
        public void Between_FallsLikeAGaussian([Values(0, 0.3, 7.5)] double time)
        {
            Func<int2, Complex> At(double when) => cell => Speckle.Between(cell, 3, when).Approaching;
            foreach (var (lag, tolerance) in new[] { (0.1, 0.03), (0.5, 0.05), (1, 0.07), (2.5, 0.02) })
                Assert.That(Correlation(At(time), At(time + lag)).Real / Correlation(At(time), At(time)).Real,
                    Is.EqualTo(Math.Exp(-lag * lag)).Within(tolerance), $"lag {lag}");
        }

        // It is continuous where a cell takes the next number.
        [Test]
        public void Between_OverACoherenceTime_HasNoStep()
        {
            for (double time = -2; time < 0; time += 1e-3)
                Assert.That(Complex.Abs(Speckle.Between(new int2(3, -4), 9, time + 1e-3).Receding
                    - Speckle.Between(new int2(3, -4), 9, time).Receding), Is.LessThan(0.02));
        }

        static IEnumerable<int2> Cells() => Enumerable.Range(0, Side * Side)
            .Select(i => new int2(i % Side - Side / 2, i / Side - 17));

        static double Power(Complex value) => value.Real * value.Real + value.Imaginary * value.Imaginary;

        static Complex Correlation(Func<int2, Complex> first, Func<int2, Complex> second) => Cells()
            .Aggregate(Complex.Zero, (sum, cell) => sum + first(cell) * Complex.Conjugate(second(cell)))
            / (Side * Side);

        /// <summary>Kolmogorov and Smirnov at 1 %.</summary>
        internal static void AssertExponential(IEnumerable<double> intensities)
        {
            var sorted = intensities.OrderBy(it => it).ToArray();
            double distance = sorted.Select((z, i) => Math.Max(Math.Abs(1 - Math.Exp(-z) - (double)i / sorted.Length),
                Math.Abs(1 - Math.Exp(-z) - (i + 1.0) / sorted.Length))).Max();
            Assert.That(distance, Is.LessThan(1.628 / Math.Sqrt(sorted.Length)));
        }
    }
}
