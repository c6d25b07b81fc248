using System;
using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// One ray as the kernel writes it. GLINT_RAY_DATA:
    /// the same struct stands in Shaders/Types.hlsl; a test compares them.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct RayData
    {
        // RAY_RECEIVED in Shaders/Constants.hlsl.
        internal const uint Received = 0x80000000;

        /// <summary>Last point of reflection, metres; the camera for a ray that hit nothing.</summary>
        public float3 LastHit;

        /// <summary>
        /// Received: the whole path, radar to last hit to receiver plane. Otherwise: radar to last hit.
        /// Metres, as float32 has it: see <see cref="RefinedPathLength"/>.
        /// </summary>
        public float PathLength; // 16 bytes

        /// <summary>Unit direction of the last segment.</summary>
        public float3 Direction;

        /// <summary>
        /// What float32 leaves out of <see cref="PathLength"/>, metres; known for received rays, else 0.
        /// </summary>
        public float PathLengthLo; // 32 bytes

        /// <summary>In-phase part cos(phase), quadrature part sin(phase); both 0 if not received.</summary>
        public float InPhase, Quadrature;

        /// <summary>x + y * rays across; x from the left, y from the bottom of the picture.</summary>
        public uint Pixel;

        uint _bouncesAndReceived; // 48 bytes

        /// <summary>Reflections made.</summary>
        public uint Bounces
        {
            get => _bouncesAndReceived & ~Received;
            set => _bouncesAndReceived = value | _bouncesAndReceived & Received;
        }

        /// <summary>True for a ray that reached the receiver.</summary>
        public bool IsReceived
        {
            get => (_bouncesAndReceived & Received) != 0;
            set => _bouncesAndReceived = Bounces | (value ? Received : 0);
        }

        /// <summary>
        /// The path's length in metres: of a received ray to 1e-8 m, beside the float32 rounding of the corners and
        /// places that the scene is given in.
        /// </summary>
        public double RefinedPathLength => (double)PathLength + PathLengthLo;

        /// <summary>2 pi mod(R, lambda) / lambda, radians, 0 to 2 pi; 0 if not received.</summary>
        public double Phase => IsReceived ? Signal.Turned(Math.Atan2(Quadrature, InPhase)) : 0;
    }

    /// <summary>Which rays a result carries one by one.</summary>
    public enum RayReadback
    {
        /// <summary>Rays that reached the receiver.</summary>
        Received,

        /// <summary>Every ray emitted: 48 bytes each.</summary>
        All,

        /// <summary>None: only sums are read back.</summary>
        None,
    }
}
