using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// A triangle as the kernel reads it, in the order of the tree's leaves. GLINT_TRIANGLE: the same struct stands in Shaders/Types.hlsl; a test compares them.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct TriangleRecord
    {
        /// <summary>First corner, metres.</summary>
        public float3 Corner;

        public uint Unused0; // 16 bytes

        /// <summary>From the first corner to the second, metres.</summary>
        public float3 Edge1;

        public uint Unused1; // 32 bytes

        /// <summary>From the first corner to the third, metres.</summary>
        public float3 Edge2;

        public uint Unused2; // 48 bytes
    }
}
