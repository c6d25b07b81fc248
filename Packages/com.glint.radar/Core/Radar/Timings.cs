namespace Glint.Core
{
    /// <summary>Wall time of the phases of one pose, milliseconds.</summary>
    public struct Timings
    {
        /// <summary>Looking at the scene's objects, and reading the meshes that are new or changed.</summary>
        public double GatherMs;

        /// <summary>Building the trees over meshes that are new or changed.</summary>
        public double BuildMs;

        /// <summary>Filling the GPU's buffers.</summary>
        public double UploadMs;

        /// <summary>From the dispatch to the sums read back; includes <see cref="ReadBackMs"/>.</summary>
        public double TraceMs;

        /// <summary>Reading back the rays that are kept one by one.</summary>
        public double ReadBackMs;
    }
}
