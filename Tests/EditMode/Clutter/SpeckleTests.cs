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

        // Over all phases of the time the correlation is near exp(-t^2).
        [TestCase(0.1, 0.03)]
        [TestCase(0.5, 0.05)]
        [TestCase(1, 0.07)]
        [TestCase(2.5, 0.02)]
        public void Between_FallsLikeAGaussian(double lag, double tolerance)
        {
            const int phases = 16;
            double sum = 0;
            for (int i = 0; i < phases; i++)
            {
                double time = (i + 0.5) / phases;
                sum += Correlation(cell => Speckle.Between(cell, 3, time).Approaching,
                    cell => Speckle.Between(cell, 3, time + lag).Approaching).Real / phases;
            }
            Assert.That(sum, Is.EqualTo(Math.Exp(-lag * lag)).Within(tolerance));
        }

        [Test]
        public void Between_AtWholeTimes_IsAt()
        {
            Assert.That(Speckle.Between(new int2(3, -4), 9, -2), Is.EqualTo(Speckle.At(new int2(3, -4), 9, -2)));
            Assert.That(Complex.Abs(Speckle.Between(new int2(3, -4), 9, 1.999999999).Receding
                - Speckle.At(new int2(3, -4), 9, 2).Receding), Is.LessThan(1e-8));
        }

        static IEnumerable<int2> Cells() => Enumerable.Range(0, Side * Side)
            .Select(i => new int2(i % Side - Side / 2, i / Side - 17));

        static double Power(Complex value) => value.Real * value.Real + value.Imaginary * value.Imaginary;

        static Complex Correlation(Func<int2, Complex> first, Func<int2, Complex> second) => Cells()
            .Aggregate(Complex.Zero, (sum, cell) => sum + first(cell) * Complex.Conjugate(second(cell)))
            / (Side * Side);

        // Kolmogorov and Smirnov at 1 %.
        static void AssertExponential(IEnumerable<double> intensities)
        {
            var sorted = intensities.OrderBy(it => it).ToArray();
            double distance = sorted.Select((z, i) => Math.Max(Math.Abs(1 - Math.Exp(-z) - (double)i / sorted.Length),
                Math.Abs(1 - Math.Exp(-z) - (i + 1.0) / sorted.Length))).Max();
            Assert.That(distance, Is.LessThan(1.628 / Math.Sqrt(sorted.Length)));
        }
    }
}
