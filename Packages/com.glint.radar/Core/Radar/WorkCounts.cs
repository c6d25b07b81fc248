using System;

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
        /// <param name="words">Of the sums, the counts and the received rays.</param>
        /// <param name="knownCapacity">Of the slice's list, for <see cref="Known"/>.</param>
        public WorkCounts(uint[] words, int knownCapacity)
        {
            (Known, Searched) = (Math.Min((int)words[First], knownCapacity), (int)words[First + 1]);
            (SubKnown, SubSearched) = ((int)words[First + 2], (int)words[First + 3]);
            (Received, Chosen) = ((int)words[First + 4], (int)words[ChosenWord]);
        }

        /// <summary>
        /// Candidates in the list of which float32 knows every triangle. Those that it does not hold are among
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
