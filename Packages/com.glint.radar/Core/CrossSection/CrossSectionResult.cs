namespace Glint.Core
{
    /// <summary>The cross section of a pose.</summary>
    public sealed class CrossSectionResult
    {
        /// <summary>Receivers times frequencies.</summary>
        public CrossSectionResult(int receivers, int frequencies)
        {
            S = new ScatteringMatrix[receivers, frequencies];
            Errors = new double[receivers, frequencies];
        }

        /// <summary>Scattering matrix of each receiver and frequency, metres.</summary>
        public ScatteringMatrix[,] S { get; }

        /// <summary>Standard error of the integration, of each complex amplitude, metres.</summary>
        public double[,] Errors { get; }

        /// <summary>The floor of the tolerance, dBsm.</summary>
        public double FloorDbsm { get; set; }

        /// <summary>Whether every amplitude has the error asked for.</summary>
        public bool IsMet { get; set; }

        /// <summary>Pieces of tubes summed: one for each bounce and receiver.</summary>
        public long Tubes { get; set; }

        /// <summary>Edges without fringe fields because a face is no perfect conductor; 0 without edges.</summary>
        public int WedgesLeftOut { get; set; }

        /// <summary>Rays traced, those that only look for borders included.</summary>
        public long Rays { get; set; }
    }
}
