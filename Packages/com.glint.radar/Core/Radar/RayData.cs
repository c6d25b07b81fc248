using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// One ray as the kernel writes it. GLINT_RAY_DATA: the same struct stands in Shaders/Types.hlsl; a test compares them.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct RayData
    {
        /// <summary>Last point of reflection, metres; the camera for a ray that hit nothing.</summary>
        public float3 LastHit;

        /// <summary>Received: the whole path, camera to last hit to receiver plane. Otherwise: camera to last hit. Metres.</summary>
        public float PathLength; // 16 bytes

        /// <summary>Unit direction of the last segment.</summary>
        public float3 Direction;

        /// <summary>2 pi mod(R, lambda) / lambda, radians, 0 to 2 pi; 0 if not received.</summary>
        public float Phase; // 32 bytes

        /// <summary>In-phase part cos(phase), quadrature part sin(phase); both 0 if not received.</summary>
        public float InPhase, Quadrature;

        /// <summary>x + y * rays across; x from the left, y from the bottom of the picture.</summary>
        public uint Pixel;

        /// <summary>Reflections made.</summary>
        public uint Bounces; // 48 bytes

        /// <summary>True for a ray that reached the receiver.</summary>
        public bool IsReceived => InPhase != 0 || Quadrature != 0;
    }
}
