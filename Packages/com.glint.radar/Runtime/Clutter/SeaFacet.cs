using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Glint
{
    // GLINT_SEA_FACET: Shaders/SeaFacets.hlsl, where the fields are explained.
    [StructLayout(LayoutKind.Sequential)]
    struct SeaFacet
    {
        public float3 Centre;
        public uint IsBreaking;
        public float3 Section;
        public float LogWind;
    }

    // GLINT_SEA_TILE
    [StructLayout(LayoutKind.Sequential)]
    struct SeaTileRecord
    {
        public float4 X, Y, Z;
        public float3 SectionX;
        public int Number;
        public float3 SectionY;
        public uint Unused;
        public float3 SectionZ;
        public uint Unused2;
    }
}
