namespace Glint.Core
{
    /// <summary>
    /// The counts of a slice's work lists: words behind the slots of the sums, and behind them the received rays, two
    /// words each (<see cref="ReceivedRay"/>). COUNT_ in Shaders/Constants.hlsl.
    /// </summary>
    public readonly struct WorkCounts
    {
        /// <summary>First word of the counts, in the order of the properties.</summary>
        public const int First = (Channel.Slots + Channel.SubRaySlots) * Channel.WordsPerSlot;

        /// <summary>Word of <see cref="Chosen"/>.</summary>
        public const int ChosenWord = First + 5;

        /// <summary>First word of the received rays.</summary>
        public const int ReceivedRays = First + 6;

        /// <summary>The counts in the words of a slice.</summary>
        public WorkCounts(uint[] words)
        {
            (Known, Searched) = ((int)words[First], (int)words[First + 1]);
            (SubKnown, SubSearched) = ((int)words[First + 2], (int)words[First + 3]);
            (Received, Chosen) = ((int)words[First + 4], (int)words[ChosenWord]);
        }

        /// <summary>
        /// Candidates of which float32 knows every triangle. Those that the list does not hold are also among
        /// <see cref="Searched"/>.
        /// </summary>
        public int Known { get; }

        /// <summary>Candidates that are searched again.</summary>
        public int Searched { get; }

        /// <summary>The same of sub-rays.</summary>
        public int SubKnown { get; }

        /// <inheritdoc cref="SubKnown"/>
        public int SubSearched { get; }

        /// <summary>Received rays.</summary>
        public int Received { get; }

        /// <summary>Pixels that get sub-rays.</summary>
        public int Chosen { get; }
    }
}
