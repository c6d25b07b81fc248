using Unity.Mathematics;

namespace Glint
{
    /// <summary>
    /// Doubles as the kernel takes them: a float32, and a second one for what it leaves out (Shaders/TwoFloat.hlsl).
    /// </summary>
    static class TwoFloat
    {
        /// <summary>What float32 leaves out of a number.</summary>
        public static float Rest(double value) => (float)(value - (float)value);

        public static float4 Rest(double4 value) => (float4)(value - (double4)(float4)value);
    }
}
