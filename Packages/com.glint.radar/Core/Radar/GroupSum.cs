using System.Runtime.InteropServices;

namespace Glint.Core
{
    /// <summary>
    /// What one thread group adds to the totals. GLINT_GROUP_SUM: the same struct stands in Shaders/Types.hlsl; a test compares them.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct GroupSum
    {
        /// <summary>Rays whose first segment hits.</summary>
        public uint Hits;

        public uint Bounces;

        /// <summary>Sum of lengths up to the last hit, metres.</summary>
        public float PathLength;

        public uint Unused; // 16 bytes
    }
}
