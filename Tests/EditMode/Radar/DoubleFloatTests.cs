using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>The kernel's double-float numbers against double precision.</summary>
    public sealed class DoubleFloatTests
    {
        const int Cases = 64 * 64;

        // Relative to the larger operand, as stated in Shaders/DoubleFloat.hlsl.
        const double Rounding = 2.9e-14;

        double[][] _numbers;

        [OneTimeSetUp]
        public void MakeNumbers()
        {
            // Of all magnitudes, each exact in double-float.
            var random = new System.Random(5);
            _numbers = Enumerable.Range(0, Cases).Select(i => Enumerable.Range(0, 4).Select(j =>
            {
                double number = (2 * random.NextDouble() - 1) * Math.Pow(2, random.Next(-20, 20));
                return (float)number + (double)DoubleFloat.Lo(number);
            }).ToArray()).ToArray();
        }

        [Test]
        public void SumsAndProductsOfFloats_AreExact()
        {
            AssertExact("Sum", n => (double)(float)n[0] + (float)n[1]);
            AssertExact("Product", n => (double)(float)n[0] * (float)n[1]);
            AssertExact("DifferenceKernel", n => (double)(float)n[0] - (float)n[3]);
            // The second is smaller: half the first times the float32 remainder of a number.
            AssertExact("SumInOrder", n => (double)(float)n[0] + 0.5f * (float)n[0] * DoubleFloat.Lo(n[1]));
        }

        [Test]
        public void Operations_AreGoodToTheRoundingOfTheLargestOperand()
        {
            AssertNear("AddKernel", n => n[0] + n[1], n => max(abs(n[0]), abs(n[1])));
            AssertNear("SubKernel", n => n[0] - n[1], n => max(abs(n[0]), abs(n[1])));
            AssertNear("MulKernel", n => n[0] * n[1], n => abs(n[0] * n[1]));
            AssertNear("MulFloatKernel", n => n[0] * (float)n[1], n => abs(n[0] * n[1]));
            AssertNear("DivKernel", n => n[0] / n[1], n => abs(n[0] / n[1]));
            AssertNear("SqrtKernel", n => sqrt(abs(n[1])), n => sqrt(abs(n[1])));
            AssertNear("DotKernel", n => n[0] * n[1] + n[1] * n[2] + n[2] * n[3],
                n => abs(n[0] * n[1]) + abs(n[1] * n[2]) + abs(n[2] * n[3]));
        }

        void AssertExact(string kernel, Func<double[], double> expected)
        {
            var results = Run(kernel);
            for (int i = 0; i < Cases; i++)
            {
                double wanted = expected(_numbers[i]);
                // Sums of numbers 2^53 apart are not exact in double either.
                Assert.That(results[i], Is.EqualTo(wanted).Within(1e-16 * abs(wanted)),
                    $"{kernel} of {string.Join(", ", _numbers[i])}");
            }
        }

        void AssertNear(string kernel, Func<double[], double> expected, Func<double[], double> size)
        {
            var results = Run(kernel);
            double worst = Enumerable.Range(0, Cases)
                .Max(i => abs(results[i] - expected(_numbers[i])) / size(_numbers[i]));
            Assert.That(worst, Is.LessThan(Rounding), kernel);
        }

        double[] Run(string kernel)
        {
            var shader = TestKernels.DoubleFloat;
            var numbers = _numbers.SelectMany(some => some)
                .Select(n => new Vector2((float)n, DoubleFloat.Lo(n))).ToArray();
            var results = new Vector2[Cases];
            using (var input = new GraphicsBuffer(GraphicsBuffer.Target.Structured, numbers.Length, 8))
            using (var output = new GraphicsBuffer(GraphicsBuffer.Target.Structured, Cases, 8))
            {
                input.SetData(numbers);
                int index = shader.FindKernel(kernel);
                shader.SetBuffer(index, "_Numbers", input);
                shader.SetBuffer(index, "_Results", output);
                shader.Dispatch(index, Cases / 64, 1, 1);
                output.GetData(results);
            }
            return results.Select(result => (double)result.x + result.y).ToArray();
        }
    }
}
