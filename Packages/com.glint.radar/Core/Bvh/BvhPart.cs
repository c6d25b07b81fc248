using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>A BVH over some of a mesh's triangles, in the kernel's layout.</summary>
    public sealed class BvhPart
    {
        /// <summary>
        /// Nodes, leaves and identities in rows of 16 bytes; the root comes first.
        /// References count from the part's start.
        /// </summary>
        public uint4[] Rows { get; internal set; }

        /// <summary>Lower corner of the part's triangles, metres.</summary>
        public float3 Min { get; internal set; }

        /// <summary>Upper corner of the part's triangles, metres.</summary>
        public float3 Max { get; internal set; }

        /// <summary>Row of the record that leaves are numbered from, three rows each.</summary>
        public int FirstRecordRow { get; set; }

        /// <summary>
        /// First of the rows behind the leaves that hold the numbers of their triangles in the mesh:
        /// two for each record.
        /// </summary>
        public int FirstIdentityRow { get; set; }
    }
}
