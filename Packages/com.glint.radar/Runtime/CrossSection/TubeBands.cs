using System;
using System.Collections.Generic;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>
    /// Blocks of neighbouring frequencies at equal steps, whose sums share what they need of each tube:
    /// Shaders/TubeBands.hlsl.
    /// </summary>
    static class TubeBands
    {
        /// <summary>Rows of a block: BAND_ROWS.</summary>
        public const int Rows = 3;

        /// <summary>Frequencies of a block at most: BAND_FREQUENCIES.</summary>
        public const int MaxFrequencies = 64;

        // Of fewer each costs less by itself.
        const int MinFrequencies = 8;

        // Of frequencies, as a fraction of them.
        const double MaxUnevenness = 1e-12;

        /// <summary>Whether the frequencies of a pose are a band: many, at equal steps.</summary>
        public static bool IsBand(CrossSectionPose pose)
        {
            var frequencies = pose.Frequencies;
            if (frequencies.Length < MinFrequencies)
                return false;
            for (int i = 0; i < frequencies.Length; i++)
                if (Math.Abs(frequencies[i] - frequencies[0] - i * StepOf(frequencies)) > MaxUnevenness * frequencies[i])
                    return false;
            return true;
        }

        /// <summary>The blocks of a pose: as many for each time, about as long as each other.</summary>
        public static float4[] Of(CrossSectionPose pose)
        {
            int count = pose.Frequencies.Length, blocks = (count + MaxFrequencies - 1) / MaxFrequencies;
            var rows = new List<float4>();
            for (int time = 0; time < pose.Times.Length; time++)
                for (int block = 0; block < blocks; block++)
                {
                    int first = (int)((long)block * count / blocks), end = (int)((block + 1L) * count / blocks);
                    int sample = pose.SampleOf(time, first);
                    double ratio = pose.PhaseFrequencyOf(sample) / pose.FrequencyOf(sample),
                        step = ratio * StepOf(pose.Frequencies), half = 0.5 * (end - 1 - first);
                    rows.Add(new float4(sample, end - first, (float)half, 0));
                    rows.Add(TubeLists.WaveNumber(pose.PhaseFrequencyOf(sample) + half * step, pose.TimeOf(sample)));
                    rows.Add(TubeLists.WaveNumber(step));
                }
            return rows.ToArray();
        }

        static double StepOf(double[] frequencies) =>
            (frequencies[frequencies.Length - 1] - frequencies[0]) / (frequencies.Length - 1);
    }
}
