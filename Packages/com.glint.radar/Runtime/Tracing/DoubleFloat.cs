using Unity.Mathematics;

namespace Glint
{
    /// <summary>
    /// Conversion of doubles to the kernels' double-floats (Shaders/DoubleFloat.hlsl).
    /// </summary>
    static class DoubleFloat
    {
        /// <summary>The Lo part of a number: what float32 leaves out.</summary>
        public static float Lo(double value) => (float)(value - (float)value);

        public static float4 Lo(double4 value) => (float4)(value - (double4)(float4)value);
    }
}
