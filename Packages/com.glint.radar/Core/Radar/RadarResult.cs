using System;

namespace Glint.Core
{
    /// <summary>What the radar received in one pose.</summary>
    public sealed class RadarResult
    {
        /// <summary>
        /// Rays of the published experiment, 1920 x 1080: the number that <see cref="NormalisedAmplitude"/> is for.
        /// </summary>
        public const double NormalRays = 2073600;

        /// <summary>
        /// I and Q: the sum over received rays of cos(phase), and of sin(phase), phase as <see cref="RayData.Phase"/>.
        /// Each ray has amplitude 1, as in the published experiment (<see cref="Signal"/>).
        /// </summary>
        public double InPhase, Quadrature;

        /// <summary>Rays of the whole picture, of which those of the region are emitted.</summary>
        public long RaysOfPicture;

        /// <summary>Rays sent out, rays whose first segment hits anything, rays that reached the receiver.</summary>
        public long RaysEmitted, RaysHit, RaysReceived;

        /// <summary>
        /// Area of the wavefront that each ray stands for, square metres; null in perspective,
        /// where it grows with the distance.
        /// </summary>
        public double? RayArea;

        /// <summary>
        /// About how far <see cref="NormalisedAmplitude"/> is from that of endlessly many rays, in its unit:
        /// Documentation~/accuracy.md.
        /// </summary>
        public double SamplingError;

        /// <summary>
        /// Largest difference of path length between received rays that are neighbours in the picture, wavelengths.
        /// </summary>
        public double LargestPathStep;

        /// <summary>
        /// True when the rays are too far apart, or too few return, for the amplitude and its error to be trusted.
        /// </summary>
        public bool Undersampled;

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

        /// <summary>Length of the summed phasor, sqrt(I^2 + Q^2): 1 for one ray. Linear, not decibels.</summary>
        public double Amplitude => Math.Sqrt(InPhase * InPhase + Quadrature * Quadrature);

        /// <summary>
        /// The amplitude as if the same field of view had <see cref="NormalRays"/> rays,
        /// amplitude x 2,073,600 / rays of the picture: the one to compare when the number of rays differs.
        /// </summary>
        public double NormalisedAmplitude => RaysOfPicture > 0 ? Amplitude * NormalRays / RaysOfPicture : 0;

        /// <summary>20 log10 of the amplitude; null when the amplitude is 0.</summary>
        public double? AmplitudeDb => Signal.Decibels(Amplitude);

        /// <summary>Rays received over rays hit; 0 when nothing is hit.</summary>
        public double Ratio => RaysHit > 0 ? (double)RaysReceived / RaysHit : 0;

        /// <summary>
        /// Rays emitted plus bounces: the last segment counts, whether it hits, is received or leaves.
        /// </summary>
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
