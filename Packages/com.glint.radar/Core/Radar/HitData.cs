using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// A reflection of one ray as the kernel writes it. GLINT_HIT_DATA: Shaders/Types.hlsl has the same struct;
    /// a test compares them.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct HitData
    {
        /// <summary>Point of reflection, metres, about the scene's centre.</summary>
        public float3 Position;

        /// <summary>Index of the instance in the scene.</summary>
        public uint Instance; // 16 bytes

        /// <summary>Unit direction after the reflection.</summary>
        public float3 Direction;

        /// <summary>Number of the triangle in the instance's mesh.</summary>
        public uint Triangle; // 32 bytes

        /// <summary>Number of the object; -1 if it is not known.</summary>
        public int Object;

        /// <summary>Place of the surface in the scene.</summary>
        public uint Surface;

        readonly uint2 _unused; // 48 bytes
    }
}
