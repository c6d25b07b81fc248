using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Glint
{
    // GLINT_TUBE: Shaders/TubeBindings.hlsl, where the fields are explained.
    [StructLayout(LayoutKind.Sequential)]
    struct Tube
    {
        public float2 Gradient;
        public float Phase;
        public uint Tag;
        public float4 CoPolar, CrossPolar, Corners01, Corners23;
        public float2 Corner4;
        public float Error, Bent;
        public float3 Bends;
        public uint Slope;
    }

    // GLINT_CORNER: Shaders/TubeBindings.hlsl, where the fields are explained.
    [StructLayout(LayoutKind.Sequential)]
    struct TubeCorner
    {
        public uint Signature, Traits;
        public float Strength;
        public uint Changes;
        public float4 Position, AlongU, AlongV;
    }

    // GLINT_CELL: Shaders/TubeBindings.hlsl, where the fields are explained.
    [StructLayout(LayoutKind.Sequential)]
    struct TubeCell
    {
        public uint2 Position;
        public uint Level, FirstBounce;
        public uint4 Signatures;
        public float Strength, Thinned;
        public uint2 Crossings;
        public uint Pose, Number, Whole, Traits;
    }
}
