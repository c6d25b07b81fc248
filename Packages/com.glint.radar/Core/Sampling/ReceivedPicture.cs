using System;
using System.Runtime.InteropServices;

namespace Glint.Core
{
    /// <summary>
    /// The received rays in the order of their pixels: a sparse picture.
    /// </summary>
    sealed class ReceivedPicture
    {
        const int DigitBits = 11, Digits = 1 << DigitBits;

        readonly ReceivedRay[] _rays;

        /// <param name="received">Each pixel at most once, in any order; sorted in place.</param>
        public ReceivedPicture(in RadarSettings settings, ReceivedRay[] received, int count)
        {
            Across = (uint)settings.RaysAcross;
            var region = settings.TracedRegion;
            (Left, Right) = (region.Left, region.Left + region.Width - 1);
            (Bottom, Top) = (region.Bottom, region.Bottom + region.Height - 1);
            Count = count;
            _rays = Ordered(received, count);
        }

        public int Count { get; }

        /// <summary>Rays across the whole picture.</summary>
        public uint Across { get; }

        /// <summary>Bounds of the emitted rays: first and last column and row.</summary>
        public long Left { get; }
        public long Right { get; }
        public long Bottom { get; }
        public long Top { get; }

        public ReceivedRay this[int ray] => _rays[ray];

        /// <summary>Row of a ray.</summary>
        public long RowOf(int ray) => _rays[ray].Pixel / Across;

        /// <summary>First ray at or after a pixel; <see cref="Count"/> if there is none.</summary>
        public int FirstFrom(long pixel)
        {
            int first = 0, end = Count;
            while (first < end)
            {
                int mid = first + (end - first) / 2;
                if (_rays[mid].Pixel < pixel)
                    first = mid + 1;
                else
                    end = mid;
            }
            return first;
        }

        // Radix sort: several times faster than comparisons.
        static ReceivedRay[] Ordered(ReceivedRay[] rays, int count)
        {
            if (IsOrdered(rays, count))
                return rays;
            uint max = 0;
            for (int i = 0; i < count; i++)
                max = Math.Max(max, rays[i].Pixel);
            var (from, to) = (rays, new ReceivedRay[count]);
            var starts = new int[Digits + 1];
            for (int shift = 0; shift < 32 && max >> shift != 0; shift += DigitBits)
            {
                Array.Clear(starts, 0, starts.Length);
                for (int i = 0; i < count; i++)
                    starts[(from[i].Pixel >> shift & (Digits - 1)) + 1]++;
                for (int digit = 0; digit < Digits; digit++)
                    starts[digit + 1] += starts[digit];
                for (int i = 0; i < count; i++)
                    to[starts[from[i].Pixel >> shift & (Digits - 1)]++] = from[i];
                (from, to) = (to, from);
            }
            return from;
        }

        static bool IsOrdered(ReceivedRay[] rays, int count)
        {
            for (int i = 1; i < count; i++)
                if (rays[i].Pixel < rays[i - 1].Pixel)
                    return false;
            return true;
        }
    }

    /// <summary>A received ray for the estimate of the sampling error: two 32-bit words.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct ReceivedRay
    {
        /// <summary>Pixel of a row without a ray: NO_PIXEL in Shaders/Constants.hlsl.</summary>
        public const uint NoPixel = uint.MaxValue;

        /// <summary>Length of a pixel without a received ray, in bits: NO_LENGTH in Shaders/Constants.hlsl.</summary>
        public const uint NoLength = uint.MaxValue;

        /// <summary>x + y * rays across; x from the left, y from the bottom of the whole picture.</summary>
        public uint Pixel;

        /// <summary>
        /// Path length in metres less a length common to all rays of the pose, for which float32 has micrometres.
        /// </summary>
        public float Length;
    }
}
