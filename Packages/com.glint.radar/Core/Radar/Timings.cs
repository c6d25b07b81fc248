namespace Glint.Core
{
    /// <summary>Wall time of the phases of one pose, milliseconds.</summary>
    public struct Timings
    {
        /// <summary>Collecting the scene's triangles.</summary>
        public double GatherMs;

        /// <summary>Building the tree over them.</summary>
        public double BuildMs;

        /// <summary>Filling the GPU's buffers.</summary>
        public double UploadMs;

        /// <summary>From the dispatch to the sums read back; includes <see cref="ReadBackMs"/>.</summary>
        public double TraceMs;

        /// <summary>Reading back counts and rays, and summing them.</summary>
        public double ReadBackMs;
    }
}
