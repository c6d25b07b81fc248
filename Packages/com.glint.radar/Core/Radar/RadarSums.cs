using System;

namespace Glint.Core
{
    /// <summary>Sums over the rays of one pose; mutable until the result is made.</summary>
    public sealed class RadarSums
    {
        /// <summary>
        /// I and Q: the sum over received rays of cos(phase), and of sin(phase), phase as <see cref="RayData.Phase"/>.
        /// Each ray has amplitude 1, as in the published experiment (<see cref="Signal"/>).
        /// </summary>
        public double InPhase, Quadrature;

        /// <summary>Rays of the whole picture; those of the region are emitted.</summary>
        public long RaysOfPicture;

        /// <summary>Rays emitted, rays whose first segment hits anything, rays that reached the receiver.</summary>
        public long RaysEmitted, RaysHit, RaysReceived;

        /// <summary>Reflections over all rays.</summary>
        public long Bounces;

        /// <summary>Sum over all rays of the length up to the last hit, metres.</summary>
        public double PathLengthMeters;

        /// <summary>
        /// Area of wavefront that each ray represents, square metres; null in perspective, where it grows with the
        /// distance.
        /// </summary>
        public double? RayArea;

        /// <summary>Received rays by phase, <see cref="Signal.PhaseBins"/> equal bins from 0 to 2 pi.</summary>
        public long[] PhaseHistogram = new long[Signal.PhaseBins];

        /// <summary>Adds one received ray to the coherent sum and to the histogram.</summary>
        public void AddReceived(double phase, double inPhase, double quadrature)
        {
            InPhase += inPhase;
            Quadrature += quadrature;
            PhaseHistogram[Signal.PhaseBin(phase)]++;
            RaysReceived++;
        }
    }

    /// <summary>The channels of a pose, summed over its dispatches.</summary>
    public sealed class ChannelSums
    {
        // 2^32 rays with the largest parts take 62 bits.
        readonly long[] _totals = new long[Channel.All.Count];
        readonly long[] _histogram = new long[Signal.PhaseBins];
        readonly double _startDepth;

        /// <summary>Sums of 0.</summary>
        /// <param name="grid">Gives the maximum path length.</param>
        public ChannelSums(RayGrid grid)
        {
            LengthUnits = (float)(Channel.Length.Scale / Math.Max(grid.MaxRelativeLength, 1e-30));
            _startDepth = grid.OriginDepth;
        }

        /// <summary>Units of length per metre.</summary>
        public float LengthUnits { get; }

        /// <summary>Adds the sums of cos and sin of a slice's sub-rays, by number of the sub-ray.</summary>
        public static void AddSubRays(uint[] words, double[] inPhase, double[] quadrature)
        {
            for (int subRay = 0; subRay < Channel.SubRaySlots; subRay++)
            {
                int slot = Channel.Slots + subRay;
                inPhase[subRay] += (double)Channel.InPhase.SumOf(words, slot) / Channel.InPhase.Scale;
                quadrature[subRay] += (double)Channel.Quadrature.SumOf(words, slot) / Channel.Quadrature.Scale;
            }
        }

        /// <summary>Adds the sums of a slice.</summary>
        public void Add(uint[] words)
        {
            foreach (var channel in Channel.All)
                for (int slot = 0; slot < Channel.Slots; slot++)
                    _totals[channel.Number] += channel.SumOf(words, slot);
            for (int slot = 0; slot < Channel.Slots; slot++)
                for (int bin = 0; bin < Signal.PhaseBins; bin++)
                    _histogram[bin] += words[slot * Channel.WordsPerSlot + Channel.Histogram.Word + bin];
        }

        /// <summary>A channel's sum in units.</summary>
        public long Units(Channel channel) => _totals[channel.Number];

        /// <summary>The sums of a pose.</summary>
        public RadarSums ToSums(in RadarSettings settings, in RadarView view) => new RadarSums
        {
            RaysOfPicture = settings.RayCount,
            RaysEmitted = settings.RaysEmitted,
            RayArea = view.RayArea(settings),
            RaysHit = Units(Channel.Hits),
            Bounces = Units(Channel.Bounces),
            RaysReceived = Units(Channel.Received),
            PathLengthMeters = Units(Channel.Hits) * _startDepth + Units(Channel.Length) / (double)LengthUnits,
            InPhase = Units(Channel.InPhase) / Channel.InPhase.Scale,
            Quadrature = Units(Channel.Quadrature) / Channel.Quadrature.Scale,
            PhaseHistogram = _histogram
        };
    }
}
