namespace Glint.Core
{
    /// <summary>Pulses at equal intervals. The speed of an approaching object is positive.</summary>
    public sealed class PulseTrain
    {
        const int MaxCount = 1 << 16;

        /// <param name="repetitionHz">Pulse repetition frequency.</param>
        /// <param name="count">Pulses, at most 2^16.</param>
        /// <exception cref="GlintException">A number is out of its range.</exception>
        public PulseTrain(double repetitionHz, int count)
        {
            Require.Positive("pulses", "repetition frequency", repetitionHz, "Hz");
            Require.Count("pulses", "number", count, MaxCount);
            (RepetitionFrequency, Count) = (repetitionHz, count);
        }

        /// <summary>Pulses a second.</summary>
        public double RepetitionFrequency { get; }

        /// <summary>Number of pulses.</summary>
        public int Count { get; }

        /// <summary>c / (2 PRF), metres: an echo from further away arrives after the next pulse.</summary>
        public double UnambiguousRange => Signal.SpeedOfLight / (2 * RepetitionFrequency);

        /// <summary>Time of a pulse after the first, seconds.</summary>
        public double TimeOf(int pulse) => pulse / RepetitionFrequency;

        /// <summary>
        /// lambda PRF / 2, m/s: an object of this speed appears to stand still. Speeds of less than half of it are
        /// unambiguous.
        /// </summary>
        public double BlindSpeed(double frequencyHz) => Signal.Wavelength(frequencyHz) * RepetitionFrequency / 2;

        /// <summary>lambda PRF / (2 count), m/s: a bin of speed without zero padding.</summary>
        public double SpeedResolution(double frequencyHz) => BlindSpeed(frequencyHz) / Count;
    }
}
