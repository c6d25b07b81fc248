using System;
using System.Collections.Generic;

namespace Glint.Core
{
    /// <summary>The result of one pose.</summary>
    public sealed class RadarResult
    {
        /// <summary>
        /// Rays of the published experiment, 1920 x 1080, to which <see cref="NormalisedAmplitude"/> refers.
        /// </summary>
        public const double NormalRays = 2073600;

        /// <summary>A result.</summary>
        /// <param name="sums">Complete; the result takes a copy.</param>
        /// <param name="sampling">Null: not estimated.</param>
        /// <param name="rays">In order of their pixel; null: none.</param>
        /// <param name="statistics">Complete; null: not counted.</param>
        public RadarResult(RadarSums sums, SamplingReport? sampling = null, RayData[] rays = null,
            TraceStatistics statistics = null)
        {
            (InPhase, Quadrature) = (sums.InPhase, sums.Quadrature);
            (RaysOfPicture, RaysEmitted) = (sums.RaysOfPicture, sums.RaysEmitted);
            (RaysHit, RaysReceived, Bounces) = (sums.RaysHit, sums.RaysReceived, sums.Bounces);
            (PathLengthMeters, RayArea) = (sums.PathLengthMeters, sums.RayArea);
            PhaseHistogram = (long[])sums.PhaseHistogram?.Clone();
            Sampling = sampling;
            Rays = rays ?? Array.Empty<RayData>();
            Statistics = statistics ?? new TraceStatistics();
        }

        /// <inheritdoc cref="RadarSums.InPhase"/>
        public double InPhase { get; }

        /// <inheritdoc cref="RadarSums.InPhase"/>
        public double Quadrature { get; }

        /// <inheritdoc cref="RadarSums.RaysOfPicture"/>
        public long RaysOfPicture { get; }

        /// <summary>Rays emitted.</summary>
        public long RaysEmitted { get; }

        /// <summary>Rays whose first segment hits anything.</summary>
        public long RaysHit { get; }

        /// <summary>Rays that reached the receiver.</summary>
        public long RaysReceived { get; }

        /// <inheritdoc cref="RadarSums.Bounces"/>
        public long Bounces { get; }

        /// <inheritdoc cref="RadarSums.PathLengthMeters"/>
        public double PathLengthMeters { get; }

        /// <inheritdoc cref="RadarSums.RayArea"/>
        public double? RayArea { get; }

        /// <inheritdoc cref="RadarSums.PhaseHistogram"/>
        public IReadOnlyList<long> PhaseHistogram { get; }

        /// <summary>
        /// The sampling error and its signs; null when it was not estimated
        /// (<see cref="RadarSettings.SkipSamplingError"/>).
        /// </summary>
        public SamplingReport? Sampling { get; }

        /// <summary>The rays read back (<see cref="RayReadback"/>), in order of their pixel.</summary>
        public RayData[] Rays { get; }

        /// <summary>Work counts and wall times of the pose.</summary>
        public TraceStatistics Statistics { get; }

        /// <summary>The echo in square metres, of a scene with a sea that has clutter; null of others.</summary>
        public PoseEcho Echo { get; private set; }

        /// <summary>The same result with an echo.</summary>
        public RadarResult With(PoseEcho echo)
        {
            var result = (RadarResult)MemberwiseClone();
            result.Echo = echo;
            return result;
        }

        /// <inheritdoc cref="SamplingReport.Error"/>
        public double? SamplingError => Sampling?.Error;

        /// <inheritdoc cref="SamplingReport.LargestPathStep"/>
        public double? LargestPathStep => Sampling?.LargestPathStep;

        /// <summary>
        /// True when the rays are too far apart, or too few return, for the amplitude and its error to be trusted.
        /// False also when it was not estimated.
        /// </summary>
        public bool Undersampled => Sampling?.Undersampled ?? false;

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
        /// Rays emitted plus bounces: the last segment counts, whether it hits, is received or leaves the scene.
        /// </summary>
        public long Segments => RaysEmitted + Bounces;
    }
}
