namespace Glint.Editor
{
    /// <summary>A row of a published table.</summary>
    sealed class PublishedRow
    {
        public PublishedRow(double step, double amplitude, long raysReceived, long raysHit)
        {
            Step = step;
            Amplitude = amplitude;
            RaysReceived = raysReceived;
            RaysHit = raysHit;
        }

        /// <summary>Turn of the target in degrees, or number of the snapshot.</summary>
        public double Step { get; }

        /// <summary>Linear, of 2,073,600 rays.</summary>
        public double Amplitude { get; }

        public long RaysReceived { get; }

        public long RaysHit { get; }

        public double Ratio => RaysHit > 0 ? (double)RaysReceived / RaysHit : 0;
    }
}
