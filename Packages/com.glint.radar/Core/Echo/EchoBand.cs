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
        /// The largest range, metres, of an echo of at most two bounces: the farthest corner of the box around the
        /// target, and for the way between the bounces half of the box's diagonal.
        /// </summary>
        /// <param name="phaseCentre">Where ranges are 0, in the frame of the box.</param>
        public static double Reach(double3 boxMin, double3 boxMax, double3 phaseCentre) =>
            math.length(math.max(math.abs(boxMin - phaseCentre), math.abs(boxMax - phaseCentre)))
            + math.distance(boxMin, boxMax) / 2;

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
