using Unity.Mathematics;

namespace Glint
{
    /// <summary>
    /// Doubles as the kernel takes them: a float32, and a second one for what it leaves out (Shaders/DoubleFloat.hlsl).
    /// </summary>
    static class DoubleFloat
    {
        /// <summary>What float32 leaves out of a number.</summary>
        public static float Lo(double value) => (float)(value - (float)value);

        public static float4 Lo(double4 value) => (float4)(value - (double4)(float4)value);
    }
}
