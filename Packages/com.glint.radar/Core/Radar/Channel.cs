using System;
using System.Collections.Generic;

namespace Glint.Core
{
    /// <summary>
    /// A sum over the rays of a pose, computed on the device in whole units, so that it does not depend on the order of
    /// the rays. The kernels' constants, reset, read-back and tests follow the table <see cref="All"/>.
    /// </summary>
    public sealed class Channel
    {
        /// <summary>Maximum number of rays: a channel holds their sum if each adds <see cref="MaxPart"/>.</summary>
        public const long MaxRays = 1L << 26;

        /// <summary>Slots that the kernels spread their sums over, and 32-bit words in each slot.</summary>
        public const int Slots = 64, WordsPerSlot = 64;

        /// <summary>Further slots behind them, one for each number of a sub-ray in its pixel.</summary>
        public const int SubRaySlots = SamplingEstimate.SubGrids;

        // The polynomial of the cosine may round to slightly above 1.
        const double MaxPhasorPart = 1 + 1.0 / (1 << 20);

        static readonly List<Channel> s_all = new List<Channel>();

        /// <summary>Rays whose first segment hits anything.</summary>
        public static readonly Channel Hits = new Channel("hits", 1);

        /// <summary>Reflections.</summary>
        public static readonly Channel Bounces = new Channel("bounces", 1, maxPart: RadarSettings.BounceLimit);

        /// <summary>Rays received.</summary>
        public static readonly Channel Received = new Channel("received", 1);

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

        /// <summary>Bit n is set if a ray's part exceeded <see cref="MaxPart"/> of channel n.</summary>
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

        /// <summary>The quantity, for messages; the kernels' constant is SUM_ with this name in upper case.</summary>
        public string Name { get; }

        /// <summary>Index in <see cref="All"/>.</summary>
        public int Number { get; }

        /// <summary>First word of the sum in a slot.</summary>
        public int Word { get; }

        /// <summary>
        /// 32-bit words of the sum, the lowest first: one word is unsigned, two or three are in two's complement.
        /// </summary>
        public int Words { get; }

        /// <summary>Units of the sum per unit of the quantity.</summary>
        public double Scale { get; }

        /// <summary>Maximum magnitude of one ray's part; a larger one is refused.</summary>
        public double MaxPart { get; }

        /// <summary>The sum of a slot in units.</summary>
        /// <exception cref="OverflowException">A sum of three words exceeds 64 bits.</exception>
        internal long SumOf(uint[] words, int slot)
        {
            int first = slot * WordsPerSlot + Word;
            return Words == 1 ? words[first]
                : Words == 2 ? (long)((ulong)words[first + 1] << 32 | words[first])
                : (long)SumOf(words, first, Words);
        }

        /// <summary>The number of several words, the lowest first, in two's complement.</summary>
        internal static decimal SumOf(uint[] words, int first, int count)
        {
            decimal sum = (int)words[first + count - 1]; // the highest word is signed
            for (int word = count - 2; word >= 0; word--)
                sum = sum * (1L << 32) + words[first + word];
            return sum;
        }

        /// <summary>Refuses sums with a part above its channel's maximum.</summary>
        /// <param name="owner">Who traced, for the message.</param>
        /// <exception cref="GlintException">A part exceeds the maximum.</exception>
        public static void CheckOverflow(uint[] words, string owner)
        {
            uint bits = 0;
            for (int slot = 0; slot < Slots + SubRaySlots; slot++)
                bits |= words[slot * WordsPerSlot + Overflow.Word];
            if (bits == 0)
                return;
            foreach (var channel in s_all)
                if ((bits & 1u << channel.Number) != 0)
                    throw new GlintException(FormattableString.Invariant($"{owner}: a ray adds more than ")
                        + FormattableString.Invariant($"{channel.MaxPart} to the sum '{channel.Name}': ")
                        + "check the scene for huge or tiny coordinates, and report it if there are none");
        }
    }
}
