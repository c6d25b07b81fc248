namespace Glint.Core
{
    /// <summary>Wall time of the phases of one pose, milliseconds.</summary>
    public struct Timings
    {
        /// <summary>Gathering the scene's objects and reading new or changed meshes.</summary>
        public double GatherMs;

        /// <summary>Building BVHs over new or changed meshes.</summary>
        public double BuildMs;

        /// <summary>Uploading buffers to the device.</summary>
        public double UploadMs;

        /// <summary>From the dispatch to the sums read back; includes <see cref="ReadBackMs"/>.</summary>
        public double TraceMs;

        /// <summary>Reading back single rays.</summary>
        public double ReadBackMs;
    }
}
