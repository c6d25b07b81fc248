namespace Glint.Core
{
    /// <summary>
    /// Equally spaced frequencies at which the response of a scene is known: those of a stepped radar, or the spectrum
    /// of a pulse after its matched filter.
    /// </summary>
    public sealed class FrequencyBand
    {
        const int MaxCount = 1 << 20;

        /// <summary>The frequencies start, start + step and so on.</summary>
        /// <param name="count">At most 2^20.</param>
        /// <exception cref="GlintException">A number is not positive, or the count is too large.</exception>
        public FrequencyBand(double startHz, double stepHz, int count)
        {
            Require.Positive("frequency band", "start", startHz, "Hz");
            Require.Positive("frequency band", "step", stepHz, "Hz");
            Require.Count("frequency band", "number of frequencies", count, MaxCount);
            (Start, Step, Count) = (startHz, stepHz, count);
        }

        /// <summary>First frequency, hertz.</summary>
        public double Start { get; }

        /// <summary>Spacing, hertz.</summary>
        public double Step { get; }

        /// <summary>Number of frequencies.</summary>
        public int Count { get; }

        /// <summary>Count times step, hertz: a frequency stands for the step around it.</summary>
        public double Bandwidth => Count * Step;

        /// <summary>Mean of the first and the last frequency, hertz.</summary>
        public double Centre => Start + 0.5 * (Count - 1) * Step;

        /// <summary>c / (2 B), metres: a bin of the range profile without zero padding.</summary>
        public double RangeResolution => Signal.SpeedOfLight / (2 * Bandwidth);

        /// <summary>c / (2 step), metres: echoes whose ranges differ by it are the same in all responses.</summary>
        public double UnambiguousRange => Signal.SpeedOfLight / (2 * Step);

        /// <summary>The frequency of an index from 0, hertz.</summary>
        public double Frequency(int index) => Start + index * Step;
    }
}
