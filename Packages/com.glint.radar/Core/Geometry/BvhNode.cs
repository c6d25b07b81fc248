using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// A box of the tree. GLINT_BVH_NODE: the same struct stands in Shaders/Types.hlsl; a test compares them.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct BvhNode
    {
        /// <summary>Lower corner, metres.</summary>
        public float3 Min;

        /// <summary>Leaf: its first triangle. Inner node: its left child; the right one follows it.</summary>
        public uint First; // 16 bytes

        /// <summary>Upper corner, metres.</summary>
        public float3 Max;

        /// <summary>Leaf: number of triangles, at least 1. Inner node: 0.</summary>
        public uint Count; // 32 bytes

        public bool IsLeaf => Count > 0;
    }
}
