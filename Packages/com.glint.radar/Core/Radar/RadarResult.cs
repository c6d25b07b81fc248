using System;

namespace Glint.Core
{
    /// <summary>What the radar received in one pose.</summary>
    public sealed class RadarResult
    {
        /// <summary>Sum over received rays of cos(phase), and of sin(phase). Each ray has amplitude 1.</summary>
        public double InPhase, Quadrature;

        /// <summary>Rays sent out, rays whose first segment hits anything, rays that reached the receiver.</summary>
        public long RaysEmitted, RaysHit, RaysReceived;

        /// <summary>Reflections over all rays.</summary>
        public long Bounces;

        /// <summary>Sum over all rays of the length up to the last hit, metres.</summary>
        public double PathLengthMeters;

        /// <summary>Received rays by phase, <see cref="Signal.PhaseBins"/> equal bins from 0 to 2 pi.</summary>
        public int[] PhaseHistogram = new int[Signal.PhaseBins];

        /// <summary>Received rays, or all rays when the radar keeps all, in order of their pixel.</summary>
        public RayData[] Rays = Array.Empty<RayData>();

        /// <summary>Objects with a mesh, and triangles, that were traced.</summary>
        public long Objects, Triangles;

        /// <summary>What the pose made the computer do.</summary>
        public WorkDone Work;

        /// <summary>Milliseconds of each phase of the work.</summary>
        public Timings Timings;

        /// <summary>Length of the summed phasor: 1 for one ray. Linear, not decibels.</summary>
        public double Amplitude => Math.Sqrt(InPhase * InPhase + Quadrature * Quadrature);

        /// <summary>20 log10 of the amplitude; null when the amplitude is 0.</summary>
        public double? AmplitudeDb => Signal.Decibels(Amplitude);

        /// <summary>Rays received over rays hit; 0 when nothing is hit.</summary>
        public double Ratio => RaysHit > 0 ? (double)RaysReceived / RaysHit : 0;

        /// <summary>Rays emitted plus bounces: the last segment counts, whether it hits, is received or leaves.</summary>
        public long Segments => RaysEmitted + Bounces;

        /// <summary>Adds one received ray to the coherent sum and to the histogram.</summary>
        internal void AddReceived(double phase, double inPhase, double quadrature)
        {
            InPhase += inPhase;
            Quadrature += quadrature;
            PhaseHistogram[Signal.PhaseBin(phase)]++;
            RaysReceived++;
        }
    }
}
