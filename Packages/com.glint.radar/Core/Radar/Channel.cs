using System;
using System.Collections.Generic;

namespace Glint.Core
{
    /// <summary>
    /// One sum over the rays of a pose, made on the device in whole units so that no order of the work changes it.
    /// <see cref="All"/> is the table from which constants of the kernels, reset, read-back and tests follow.
    /// </summary>
    public sealed class Channel
    {
        /// <summary>A channel holds the sum over this number of rays that add its largest part each.</summary>
        public const long MaxRays = 1L << 26;

        /// <summary>Slots that the kernels spread their sums over, and 32-bit words in each slot.</summary>
        public const int Slots = 64, WordsPerSlot = 64;

        // Of a cosine, whose polynomial may round to a little above 1.
        const double MaxPhasorPart = 1 + 1.0 / (1 << 20);

        static readonly List<Channel> s_all = new List<Channel>();

        /// <summary>Rays whose first segment hits anything.</summary>
        public static readonly Channel Hits = new Channel("hits", 1);

        /// <summary>Reflections.</summary>
        public static readonly Channel Bounces = new Channel("bounces", 1, maxPart: RadarSettings.BounceLimit);

        /// <summary>Rays received.</summary>
        public static readonly Channel Received = new Channel("received", 1);

        /// <summary>Rays that may be received and are followed once more; in the first slot only.</summary>
        public static readonly Channel Candidates = new Channel("candidates", 1);

        /// <summary>
        /// Path lengths from the ray's origin to its last hit, as a share of the longest that the scene allows.
        /// </summary>
        public static readonly Channel Length = new Channel("length", 2, scale: 1 << 30);

        /// <summary>cos(phase) of received rays.</summary>
        public static readonly Channel InPhase = new Channel("in_phase", 2, 1 << 24, MaxPhasorPart);

        /// <summary>sin(phase) of received rays.</summary>
        public static readonly Channel Quadrature = new Channel("quadrature", 2, 1 << 24, MaxPhasorPart);

        /// <summary>BVH nodes read.</summary>
        public static readonly Channel Nodes = new Channel("nodes", 2, maxPart: 1 << 24);

        /// <summary>Pairs of triangles tested.</summary>
        public static readonly Channel Pairs = new Channel("pairs", 2, maxPart: 1 << 24);

        /// <summary>A bit for each channel, by its number, that a ray's part was too large for.</summary>
        public static readonly Channel Overflow = new Channel("overflow", 1);

        /// <summary>Received rays by phase: the first of <see cref="Signal.PhaseBins"/> words, one a bin.</summary>
        public static readonly Channel Histogram = new Channel("histogram", 1);

        Channel(string name, int words, double scale = 1, double maxPart = 1)
        {
            Number = s_all.Count;
            Word = Number == 0 ? 0 : s_all[Number - 1].Word + s_all[Number - 1].Words;
            (Name, Words, Scale, MaxPart) = (name, words, scale, maxPart);
            s_all.Add(this);
        }

        /// <summary>Every channel, in the order of the words.</summary>
        public static IReadOnlyList<Channel> All => s_all;

        /// <summary>What is summed, for messages; in upper case after SUM_ the constant of the kernels.</summary>
        public string Name { get; }

        /// <summary>Place in <see cref="All"/>.</summary>
        public int Number { get; }

        /// <summary>First word of the sum in a slot.</summary>
        public int Word { get; }

        /// <summary>
        /// 32-bit words of the sum, the lowest first: one without sign, or two or three in two's complement.
        /// </summary>
        public int Words { get; }

        /// <summary>Units of the sum for 1 of what is summed.</summary>
        public double Scale { get; }

        /// <summary>Largest part of one ray, of either sign; a larger one is refused.</summary>
        public double MaxPart { get; }

        /// <summary>The sum of a slot in units.</summary>
        internal decimal SumOf(uint[] words, int slot)
        {
            int first = slot * WordsPerSlot + Word;
            if (Words == 1)
                return words[first];
            decimal sum = (int)words[first + Words - 1]; // the highest word has the sign
            for (int word = Words - 2; word >= 0; word--)
                sum = sum * (1L << 32) + words[first + word];
            return sum;
        }

        /// <summary>Refuses sums with a part that was too large for its channel.</summary>
        /// <param name="owner">Who traced, for the message.</param>
        /// <exception cref="GlintException">There is one.</exception>
        internal static void CheckOverflow(uint[] words, string owner)
        {
            for (int slot = 0; slot < Slots; slot++)
                foreach (var channel in s_all)
                    if ((words[slot * WordsPerSlot + Overflow.Word] & 1u << channel.Number) != 0)
                        throw new GlintException(FormattableString.Invariant($"{owner}: a ray adds more than ")
                            + FormattableString.Invariant($"{channel.MaxPart} to the sum '{channel.Name}': ")
                            + "check the scene for huge or tiny coordinates, and report it if there are none");
        }
    }
}
