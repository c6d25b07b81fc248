using System;

namespace Glint.Core
{
    /// <summary>
    /// The sums that the kernel makes, in whole numbers so that no order of the work changes them. The places of the words stand in Shaders/Sums.hlsl as well; a test compares them.
    /// </summary>
    public sealed class RaySums
    {
        public const int Slots = 64, WordsPerSlot = 64;
        public const int Hits = 0, Bounces = 1, Received = 2, Kept = 3, Length = 4, InPhase = 6, Quadrature = 8, Nodes = 10, Pairs = 12, Histogram = 16;

        /// <summary>Units of the sums of cos and sin.</summary>
        public const double PhasorUnits = 1 << 24;

        // Finer than the float32 that holds a length.
        const int LongestInUnits = 1 << 30;

        static readonly int[] s_single = { Hits, Bounces, Received }, s_pairs = { Length, InPhase, Quadrature, Nodes, Pairs };

        readonly long[] _totals = new long[Histogram];
        readonly int[] _histogram = new int[Signal.PhaseBins];

        /// <param name="longest">No path up to a last hit is longer, metres.</param>
        public RaySums(double longest) => LengthUnits = (float)(LongestInUnits / Math.Max(longest, 1e-30));

        /// <summary>Units of lengths a metre.</summary>
        public float LengthUnits { get; }

        /// <summary>Rays that a dispatch wrote one by one, or wanted to.</summary>
        public static long CountKept(uint[] words) => words[Kept];

        /// <summary>Adds what a dispatch summed.</summary>
        public void Add(uint[] words)
        {
            for (int slot = 0; slot < Slots * WordsPerSlot; slot += WordsPerSlot)
            {
                foreach (int single in s_single)
                    _totals[single] += words[slot + single];
                foreach (int pair in s_pairs)
                    _totals[pair] += (long)((ulong)words[slot + pair + 1] << 32 | words[slot + pair]);
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
            result.PathLengthMeters = _totals[Length] / (double)LengthUnits;
            result.InPhase = _totals[InPhase] / PhasorUnits;
            result.Quadrature = _totals[Quadrature] / PhasorUnits;
            result.PhaseHistogram = _histogram;
            result.Work.NodesVisited = _totals[Nodes];
            result.Work.PairsTested = _totals[Pairs];
        }
    }
}
