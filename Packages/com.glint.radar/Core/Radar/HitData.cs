using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// A reflection of one ray as the kernel writes it. GLINT_HIT_DATA:
    /// the same struct stands in Shaders/Types.hlsl; a test compares them.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    struct HitData
    {
        /// <summary>Where, metres, about the middle of the scene.</summary>
        public float3 Position;

        /// <summary>Number of the tree of an instance that was hit.</summary>
        public uint Instance; // 16 bytes

        /// <summary>Unit direction after the reflection.</summary>
        public float3 Direction;

        /// <summary>Row of the pair of triangles in the tree, and in the lowest bit which of the two.</summary>
        public uint Triangle; // 32 bytes
    }
}
