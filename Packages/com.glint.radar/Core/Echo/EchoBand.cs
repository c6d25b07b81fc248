using System;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>Frequencies of a band that tell all echoes of a target apart.</summary>
    public static class EchoBand
    {
        // Bins on either side for the main lobe of a window.
        const int Margin = 4;

        /// <summary>
        /// The largest range, metres, of an echo of at most two bounces in a box around the target, from any direction.
        /// With bounces at a and b from the phase centre it is half of |a + b| + |a - b| far from a radar that
        /// receives, and else no more than half of |a| + |b| + |a - b|. Both are convex, and largest at corners.
        /// </summary>
        /// <param name="phaseCentre">Where ranges are 0, in the frame of the box.</param>
        /// <param name="isFarMonostatic">Whether the radar receives, infinitely far away.</param>
        public static double Reach(double3 boxMin, double3 boxMax, double3 phaseCentre, bool isFarMonostatic)
        {
            double reach = 0;
            for (int first = 0; first < 8; first++)
                for (int second = 0; second < 8; second++)
                {
                    double3 a = Box.CornerOf(boxMin, boxMax, first) - phaseCentre,
                        b = Box.CornerOf(boxMin, boxMax, second) - phaseCentre;
                    double outside = isFarMonostatic ? math.length(a + b) : math.length(a) + math.length(b);
                    reach = math.max(reach, (outside + math.distance(a, b)) / 2);
                }
            return reach;
        }

        /// <summary>Number of frequencies whose unambiguous range holds echoes up to a reach on both sides.</summary>
        public static double CountFor(double reach, double bandwidthHz) =>
            2 * (Math.Ceiling(reach * 2 * bandwidthHz / Signal.SpeedOfLight) + Margin);

        /// <summary>The frequencies of a band, each in the middle of its step.</summary>
        public static double[] Frequencies(double centreHz, double bandwidthHz, int count)
        {
            var frequencies = new double[count];
            for (int n = 0; n < count; n++)
                frequencies[n] = centreHz + (n - 0.5 * (count - 1)) * (bandwidthHz / count);
            return frequencies;
        }
    }
}
