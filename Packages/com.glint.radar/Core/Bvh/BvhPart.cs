using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>A BVH of its own over some of a mesh's triangles, as the kernel reads it.</summary>
    public sealed class BvhPart
    {
        /// <summary>
        /// Nodes and leaves in rows of 16 bytes; the root stands first. References count from the part's start.
        /// </summary>
        public uint4[] Rows { get; internal set; }

        /// <summary>Lower corner of the part's triangles, metres.</summary>
        public float3 Min { get; internal set; }

        /// <summary>Upper corner of the part's triangles, metres.</summary>
        public float3 Max { get; internal set; }

        /// <summary>Corners of a triangle, metres; a pair is written by <see cref="PairWriter"/>.</summary>
        /// <param name="row">Of the pair that it belongs to.</param>
        /// <param name="second">Which of the two.</param>
        internal void GetTriangle(int row, bool second, out float3 a, out float3 b, out float3 c)
        {
            float4 first = math.asfloat(Rows[row]), next = math.asfloat(Rows[row + 1]),
                last = math.asfloat(Rows[row + 2]);
            float3 corner2 = new float3(next.z, next.w, last.x);
            a = first.xyz;
            (b, c) = second ? (corner2, last.yzw) : (new float3(first.w, next.x, next.y), corner2);
        }
    }
}
