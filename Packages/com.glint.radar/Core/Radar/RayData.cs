using System;
using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>
    /// One ray as the kernel writes it. GLINT_RAY_DATA:
    /// the same struct is in Shaders/Types.hlsl; a test compares them.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct RayData
    {
        /// <summary>Flag of a received ray: RAY_RECEIVED in Shaders/Constants.hlsl.</summary>
        public const uint Received = 0x80000000;

        /// <summary>Last point of reflection, metres; the camera for a ray that hit nothing.</summary>
        public float3 LastHit;

        /// <summary>
        /// Received: the whole path, radar to last hit to receiver plane. Otherwise: radar to last hit.
        /// Metres, rounded to float32: see <see cref="RefinedPathLength"/>.
        /// </summary>
        public float PathLength; // 16 bytes

        /// <summary>Unit direction of the last segment.</summary>
        public float3 Direction;

        /// <summary>
        /// Low part of <see cref="PathLength"/> in double-float, metres; 0 if not received.
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
        /// Path length in metres; of a received ray accurate to 1e-8 m, except for the float32 rounding of the scene's
        /// corners and transforms.
        /// </summary>
        public double RefinedPathLength => (double)PathLength + PathLengthLo;

        /// <summary>2 pi mod(R, lambda) / lambda, radians, 0 to 2 pi; 0 if not received.</summary>
        public double Phase => IsReceived ? Signal.Turned(Math.Atan2(Quadrature, InPhase)) : 0;
    }

    /// <summary>Rays that a result carries.</summary>
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
