using System.Runtime.InteropServices;

namespace Glint.Core
{
    /// <summary>A received ray for the estimate of the sampling error: two 32-bit words.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct ReceivedRay
    {
        // NO_PIXEL in Shaders/Constants.hlsl.
        internal const uint NoPixel = uint.MaxValue;

        /// <summary>x + y * rays across; x from the left, y from the bottom of the whole picture.</summary>
        public uint Pixel;

        /// <summary>
        /// Path length in metres less a length common to all rays of the pose, for which float32 has micrometres.
        /// </summary>
        public float Length;
    }
}
