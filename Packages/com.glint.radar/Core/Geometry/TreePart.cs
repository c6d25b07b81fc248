using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>A tree of its own over some of a mesh's triangles, as the kernel reads it.</summary>
    public sealed class TreePart
    {
        /// <summary>Nodes and leaves in rows of 16 bytes; the root stands first. References count from the part's start.</summary>
        public uint4[] Words { get; internal set; }

        /// <summary>Lower corner of the part's triangles, metres.</summary>
        public float3 Low { get; internal set; }

        /// <summary>Upper corner of the part's triangles, metres.</summary>
        public float3 High { get; internal set; }
    }
}
