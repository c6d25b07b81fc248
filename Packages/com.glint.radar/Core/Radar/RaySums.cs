using System;

namespace Glint.Core
{
    /// <summary>
    /// The sums that the kernel makes, in whole numbers so that no order of the work changes them.
    /// The places of the words stand in Shaders/Sums.hlsl as well; a test compares them.
    /// </summary>
    public sealed class RaySums
    {
        /// <summary>Slots that the kernel spreads its sums over, and words of 32 bits in each.</summary>
        public const int Slots = 64, WordsPerSlot = 64;
        /// <summary>
        /// Places in a slot, in words. A sum that 32 bits may not hold takes two words, the lower one first;
        /// the histogram takes one a bin.
        /// </summary>
        public const int Hits = 0, Bounces = 1, Received = 2, Returning = 3, Length = 4, InPhase = 6, Quadrature = 8,
            Nodes = 10, Pairs = 12, Histogram = 16;

        /// <summary>Units of the sums of cos and sin.</summary>
        public const double PhasorUnits = 1 << 24;

        // Finer than the float32 that holds a length.
        const int LongestInUnits = 1 << 30;

        static readonly int[] s_single = { Hits, Bounces, Received },
            s_pairs = { Length, InPhase, Quadrature, Nodes, Pairs };

        readonly long[] _totals = new long[Histogram];
        readonly int[] _histogram = new int[Signal.PhaseBins];

        readonly double _startDepth;

        /// <summary>Sums of no dispatch yet.</summary>
        /// <param name="grid">How long paths may be.</param>
        public RaySums(RayGrid grid)
        {
            LengthUnits = (float)(LongestInUnits / Math.Max(grid.LongestBeyond, 1e-30));
            _startDepth = grid.StartDepth;
        }

        /// <summary>Units of lengths a metre.</summary>
        public float LengthUnits { get; }

        /// <summary>Rays of a dispatch that may be received: they are to be followed once more.</summary>
        public static int CountReturning(uint[] words) => (int)words[Returning];

        /// <summary>Adds the sums of cos and sin of a dispatch's first slots, slot by slot.</summary>
        public static void AddPhasors(uint[] words, double[] inPhase, double[] quadrature)
        {
            for (int slot = 0; slot < inPhase.Length; slot++)
            {
                inPhase[slot] += Pair(words, slot * WordsPerSlot + InPhase) / PhasorUnits;
                quadrature[slot] += Pair(words, slot * WordsPerSlot + Quadrature) / PhasorUnits;
            }
        }

        /// <summary>Adds what a dispatch summed.</summary>
        public void Add(uint[] words)
        {
            for (int slot = 0; slot < Slots * WordsPerSlot; slot += WordsPerSlot)
            {
                foreach (int single in s_single)
                    _totals[single] += words[slot + single];
                foreach (int pair in s_pairs)
                    _totals[pair] += Pair(words, slot + pair);
                for (int bin = 0; bin < Signal.PhaseBins; bin++)
                    _histogram[bin] += (int)words[slot + Histogram + bin];
            }
        }

        /// <summary>Puts the sums into a pose's result.</summary>
        public void WriteTo(RadarResult result)
        {
            result.RaysHit = _totals[Hits];
            result.Bounces = _totals[Bounces];
            result.RaysReceived = _totals[Received];
            result.PathLengthMeters = _totals[Hits] * _startDepth + _totals[Length] / (double)LengthUnits;
            result.InPhase = _totals[InPhase] / PhasorUnits;
            result.Quadrature = _totals[Quadrature] / PhasorUnits;
            result.PhaseHistogram = _histogram;
            result.Work.NodesVisited = _totals[Nodes];
            result.Work.PairsTested = _totals[Pairs];
        }

        static long Pair(uint[] words, int place) => (long)((ulong)words[place + 1] << 32 | words[place]);
    }
}
