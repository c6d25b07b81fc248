using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Glint
{
    // GLINT_EDGE_PIECE: Shaders/TubeFringes.hlsl, where the fields are explained.
    [StructLayout(LayoutKind.Sequential)]
    struct EdgePiece
    {
        public float3 Centre;
        public float Length;
        public float3 Along;
        public float OuterAngle;
        public float3 Into;
        public uint Part, Instance;
        public uint3 Unused;
    }
}
