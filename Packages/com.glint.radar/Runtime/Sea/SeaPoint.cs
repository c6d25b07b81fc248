using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Glint
{
    // GLINT_SEA_POINT: Shaders/SeaField.hlsl, where the fields are explained.
    [StructLayout(LayoutKind.Sequential)]
    struct SeaPoint
    {
        public float Height;
        public float Acceleration;
    }

    // GLINT_SEA_WAVE: Shaders/SeaTransform.hlsl
    [StructLayout(LayoutKind.Sequential)]
    struct SeaWave
    {
        public float2 Amplitude;
        public float Frequency;
        public uint Turns;
    }
}
