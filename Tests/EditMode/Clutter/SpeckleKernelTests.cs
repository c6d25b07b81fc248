using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Glint.Tests
{
    /// <summary>The device's speckle is that of C#.</summary>
    public sealed class SpeckleKernelTests
    {
        const int Cases = 64 * 256;

        [Test]
        public void Kernel_ForAnyCellSeedAndTime_GivesTheNumbersOfCSharp()
        {
            var random = new System.Random(11);
            var inputs = Enumerable.Range(0, Cases).Select(i => i < Cases / 2
                ? new int4(i % 64, i / 64 - 50, 1, 0)
                : new int4(Any(random), Any(random), Any(random), random.Next(-100000, 100000))).ToArray();
            // In steps that float32 holds.
            var fractions = inputs.Select((_, i) => i % 3 == 0 ? 0 : random.Next(1 << 20) / (float)(1 << 20)).ToArray();
            var results = Run(inputs, fractions);
            double worst = 0;
            for (int i = 0; i < Cases; i++)
            {
                var expected = Speckle.Between(inputs[i].xy, (uint)inputs[i].z, inputs[i].w + (double)fractions[i]);
                worst = Math.Max(worst, Math.Max(Difference(results[i].x, expected.Approaching.Real),
                    Math.Max(Difference(results[i].y, expected.Approaching.Imaginary),
                        Math.Max(Difference(results[i].z, expected.Receding.Real),
                            Difference(results[i].w, expected.Receding.Imaginary)))));
            }
            // The largest number is sqrt(24 ln 2) = 4.08; sine and cosine are good to 1e-7, the root to one digit more.
            Assert.That(worst, Is.LessThan(3e-6));
        }

        static int Any(System.Random random) => random.Next(int.MinValue, int.MaxValue);

        static double Difference(float a, double b) => Math.Abs(a - b);

        static Vector4[] Run(int4[] inputs, float[] fractions)
        {
            var shader = TestKernels.Speckle;
            int kernel = shader.FindKernel("SpeckleKernel");
            var results = new Vector4[Cases];
            using (var input = new GraphicsBuffer(GraphicsBuffer.Target.Structured, Cases, 16))
            using (var fraction = new GraphicsBuffer(GraphicsBuffer.Target.Structured, Cases, 4))
            using (var output = new GraphicsBuffer(GraphicsBuffer.Target.Structured, Cases, 16))
            {
                input.SetData(inputs);
                fraction.SetData(fractions);
                shader.SetBuffer(kernel, "_Inputs", input);
                shader.SetBuffer(kernel, "_Fractions", fraction);
                shader.SetBuffer(kernel, "_Results", output);
                shader.Dispatch(kernel, Cases / 64, 1, 1);
                output.GetData(results);
            }
            return results;
        }
    }
}
