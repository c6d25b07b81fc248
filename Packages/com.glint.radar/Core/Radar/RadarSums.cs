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
        public int[] PhaseHistogram = new int[Signal.PhaseBins];

        /// <summary>Adds one received ray to the coherent sum and to the histogram.</summary>
        public void AddReceived(double phase, double inPhase, double quadrature)
        {
            InPhase += inPhase;
            Quadrature += quadrature;
            PhaseHistogram[Signal.PhaseBin(phase)]++;
            RaysReceived++;
        }
    }
}
