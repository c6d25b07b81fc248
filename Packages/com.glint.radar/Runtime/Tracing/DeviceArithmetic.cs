using System;
using System.Linq;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// Self-test of a device and its shader compiler: compares the double-float arithmetic of Shaders/Arithmetic.hlsl
    /// with double precision. A compiler with fast math takes b for (a + b) - a, which makes path lengths wrong by
    /// wavelengths without a message.
    /// </summary>
    static class DeviceArithmetic
    {
        const int Cases = 64;

        // Of Div and Sqrt: 2^-44.
        const double Rounding = 5.7e-14;

        // Once for each shader: the device of a process stays the same.
        static readonly ConditionalWeakTable<ComputeShader, object> s_passed =
            new ConditionalWeakTable<ComputeShader, object>();

        static readonly ConditionalWeakTable<ComputeShader, StrongBox<bool>> s_fused =
            new ConditionalWeakTable<ComputeShader, StrongBox<bool>>();

        static readonly int s_operands = Shader.PropertyToID("_Operands"), s_results = Shader.PropertyToID("_Results");

        /// <summary>Refuses a device that rounds otherwise; a shader that has passed is not tested again.</summary>
        /// <param name="shader">Has the kernel Arithmetic.</param>
        /// <exception cref="GlintException">The device rounds otherwise.</exception>
        public static void Check(ComputeShader shader)
        {
            if (s_passed.TryGetValue(shader, out _))
                return;
            if (FirstWrong(shader, "Arithmetic") is string wrong)
                throw new GlintException($"{SystemInfo.graphicsDeviceName} ({SystemInfo.graphicsDeviceType}) rounds "
                    + $"otherwise than path lengths need: {wrong}. Its shader compiler changes double-float "
                    + "arithmetic: use Vulkan or Direct3D 11 or 12, or another version of the driver");
            s_passed.Add(shader, s_passed);
        }

        /// <summary>
        /// Whether the device rounds a multiply-add once, so that the kernels with GLINT_FUSED compute the same as those
        /// without, in less time. Shader model 5 leaves that to the device.
        /// </summary>
        /// <param name="shader">Has the kernel ArithmeticFused.</param>
        public static bool IsFused(ComputeShader shader)
        {
            if (!s_fused.TryGetValue(shader, out var isFused))
                s_fused.Add(shader, isFused = new StrongBox<bool>(FirstWrong(shader, "ArithmeticFused") == null));
            return isFused.Value;
        }

        /// <summary>The first operation with another result than double precision, or null.</summary>
        internal static string FirstWrong(ComputeShader shader, string kernel)
        {
            var operands = MakeOperands();
            return operands.Zip(Run(shader, kernel, operands), Wrong).FirstOrDefault(wrong => wrong != null);
        }

        // Two numbers of the order of 1, each with a part some 10 bits smaller.
        static float4[] MakeOperands()
        {
            var random = new System.Random(1);
            float Number(double size) => (float)(size * (1 + random.NextDouble()) * (random.Next(2) == 0 ? -1 : 1));
            return Enumerable.Range(0, Cases).Select(_ =>
                new float4(Math.Abs(Number(2)), Number(1e-3), Number(2), Number(1e-3))).ToArray();
        }

        static Result[] Run(ComputeShader shader, string name, float4[] operands)
        {
            var results = new Result[Cases];
            using (var input = new DeviceBuffer<float4>("operands"))
            using (var output = new DeviceBuffer<Result>("results"))
            {
                input.Upload(operands);
                output.Upload(results);
                int kernel = shader.FindKernel(name);
                shader.SetBuffer(kernel, s_operands, input.Buffer);
                shader.SetBuffer(kernel, s_results, output.Buffer);
                shader.Dispatch(kernel, 1, 1, 1);
                output.ReadBack(results, Cases);
            }
            return results;
        }

        // Sums and products of two float32 are exact in double precision.
        static string Wrong(float4 n, Result r)
        {
            double x = n.x, y = n.y, a = x + y, b = (double)n.z + n.w;
            float side = (float)((float)(x * n.w) - (double)(float)(y * n.z));
            return Differs("TwoSum", r.Sum, a, 0)
                ?? Differs("QuickTwoSum", r.SumInOrder, a, 0)
                ?? Differs("TwoProd", r.Product, x * y, 0)
                ?? Differs("RoundedSum", r.RoundedSum, (float)a, 0)
                ?? Differs("SideOf", r.Side, side, 0)
                ?? Differs("Div", r.Quotient, a / b, Rounding)
                ?? Differs("Sqrt", r.Root, Math.Sqrt(a), Rounding);
        }

        static string Differs(string operation, float2 computed, double expected, double rounding)
        {
            double number = (double)computed.x + computed.y;
            return Math.Abs(number - expected) <= rounding * Math.Abs(expected)
                ? null
                : FormattableString.Invariant($"{operation} gives {number:R} instead of {expected:R}");
        }

        static string Differs(string operation, float computed, float expected, double rounding) =>
            Differs(operation, new float2(computed, 0), expected, rounding);

        // ArithmeticResult in Shaders/Arithmetic.hlsl.
        [StructLayout(LayoutKind.Sequential)]
        struct Result
        {
            public float2 Sum, SumInOrder, Product, Quotient, Root;
            public float RoundedSum, Side;
        }
    }
}
