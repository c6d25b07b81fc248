using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Glint
{
    // GLINT_RETURN: Return of Shaders/AmplitudePath.hlsl, where the fields are explained.
    [StructLayout(LayoutKind.Sequential)]
    struct BorderRay
    {
        public uint Signature;
        public float Length;
        public float2 Gradient;
        public float3 Bend;
        public float BendError;
    }
}
