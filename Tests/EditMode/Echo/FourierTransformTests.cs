using System;
using System.Linq;
using System.Numerics;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class FourierTransformTests
    {
        [Test]
        public void Transform_OfRandomValues_IsTheSumTermByTerm([Values(1, 2, 8, 64)] int size,
            [Values] bool isPositive)
        {
            var random = new Random(size);
            var values = Enumerable.Range(0, size)
                .Select(_ => new Complex(random.NextDouble() - 0.5, random.NextDouble() - 0.5)).ToArray();
            AssertTransform(size, values, isPositive);
        }

        [Test]
        public void Transform_OfFewerValues_TakesTheOthersAsZero() =>
            AssertTransform(16, new[] { new Complex(1, -2), new Complex(0.5, 3), new Complex(-1, 0.25) }, false);

        [TestCase(1, 1)]
        [TestCase(2, 2)]
        [TestCase(3, 4)]
        [TestCase(600, 1024)]
        [TestCase(1024, 1024)]
        public void SizeFor_ACount_IsTheNextPowerOfTwo(int count, int size) =>
            Assert.That(FourierTransform.SizeFor(count), Is.EqualTo(size));

        static void AssertTransform(int size, Complex[] values, bool isPositive)
        {
            var transform = new FourierTransform(size).Transform(values, isPositive);
            for (int k = 0; k < size; k++)
            {
                var expected = Complex.Zero;
                for (int n = 0; n < values.Length; n++)
                    expected += values[n]
                        * Complex.FromPolarCoordinates(1, (isPositive ? 2 : -2) * Math.PI * n * k / size);
                Assert.That(Complex.Abs(transform[k] - expected), Is.LessThan(1e-13 * size), $"value {k}");
            }
        }
    }
}
