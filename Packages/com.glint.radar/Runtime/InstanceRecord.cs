using System.Runtime.InteropServices;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>
    /// A tree at its place in the world. GLINT_INSTANCE: the same struct stands in Shaders/Types.hlsl; a test compares them.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    struct InstanceRecord
    {
        /// <summary>Rows of the matrix from the world to the mesh's frame.</summary>
        public float4 ToLocalX, ToLocalY, ToLocalZ; // 48 bytes

        /// <summary>Where the tree starts in its bank, in rows of 16 bytes.</summary>
        public uint FirstRow;

        public uint Bank;

        public uint Unused0, Unused1; // 64 bytes

        public static InstanceRecord Of(in Affine toLocal, int bank, int firstRow) => new InstanceRecord
        {
            ToLocalX = (float4)new double4(toLocal.X.x, toLocal.Y.x, toLocal.Z.x, toLocal.Origin.x),
            ToLocalY = (float4)new double4(toLocal.X.y, toLocal.Y.y, toLocal.Z.y, toLocal.Origin.y),
            ToLocalZ = (float4)new double4(toLocal.X.z, toLocal.Y.z, toLocal.Z.z, toLocal.Origin.z),
            FirstRow = (uint)firstRow,
            Bank = (uint)bank,
        };
    }
}
