using System.Runtime.InteropServices;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>
    /// An instance of a mesh BVH. GLINT_INSTANCE:
    /// the same struct is in Shaders/Types.hlsl; a test compares them.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    struct InstanceRecord
    {
        // Relative rounding of a position's coordinates: 4 float32 steps.
        const float PositionRounding = 2.4e-7f;

        /// <summary>Rows of the matrix from the scene's centre to the mesh's frame.</summary>
        public float4 ToLocalX, ToLocalY, ToLocalZ; // 48 bytes

        /// <summary>Their Lo parts.</summary>
        public float4 ToLocalXLo, ToLocalYLo, ToLocalZLo; // 96 bytes

        /// <summary>First row of the BVH in its page, in rows of 16 bytes.</summary>
        public uint FirstRow;

        public uint Page;

        /// <summary>Maximum scale of lengths into the mesh's frame.</summary>
        public float Stretch;

        /// <summary>Rounding of positions transformed into that frame, m.</summary>
        public float Rounding; // 112 bytes

        /// <summary>Row of the record that the BVH's leaves are numbered from, after FirstRow.</summary>
        public uint FirstRecordRow;

        /// <summary>First row with numbers of triangles, after FirstRow.</summary>
        public uint FirstIdentityRow;

        /// <summary>The instance's objects and surfaces: the first of them in _Ranges, and their number.</summary>
        public uint FirstRange;

        public uint RangeCount; // 128 bytes

        /// <summary>Index of the instance in the scene.</summary>
        public uint Instance;

        readonly uint3 _unused; // 144 bytes

        /// <param name="toLocal">From the scene's centre to the mesh's frame.</param>
        public static InstanceRecord Of(in Affine toLocal, int page, int firstRow)
        {
            var x = new double4(toLocal.X.x, toLocal.Y.x, toLocal.Z.x, toLocal.Origin.x);
            var y = new double4(toLocal.X.y, toLocal.Y.y, toLocal.Z.y, toLocal.Origin.y);
            var z = new double4(toLocal.X.z, toLocal.Y.z, toLocal.Z.z, toLocal.Origin.z);
            return new InstanceRecord
            {
                ToLocalX = (float4)x, ToLocalY = (float4)y, ToLocalZ = (float4)z,
                ToLocalXLo = DoubleFloat.Lo(x), ToLocalYLo = DoubleFloat.Lo(y), ToLocalZLo = DoubleFloat.Lo(z),
                FirstRow = (uint)firstRow,
                Page = (uint)page,
                Stretch =
                    (float)math.sqrt(math.lengthsq(toLocal.X) + math.lengthsq(toLocal.Y) + math.lengthsq(toLocal.Z)),
                Rounding = PositionRounding * (float)math.csum(math.abs(toLocal.Origin)),
            };
        }
    }
}
