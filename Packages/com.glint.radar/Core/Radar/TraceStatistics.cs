namespace Glint.Core
{
    /// <summary>
    /// Work counts of one pose, which do not depend on the machine, and wall times. Gathering and tracing add to it.
    /// </summary>
    public sealed class TraceStatistics
    {
        /// <summary>Traced objects with a mesh, and triangles.</summary>
        public long Objects { get; set; }

        /// <inheritdoc cref="Objects"/>
        public long Triangles { get; set; }

        /// <summary>
        /// Bytes of vertices and indices hashed while the scene was gathered: those of new meshes, and of meshes that may
        /// have changed.
        /// </summary>
        public long BytesHashed { get; set; }

        /// <summary>Bytes hashed beside the trace, of watched meshes.</summary>
        public long BytesHashedBeside { get; set; }

        /// <summary>BVHs built because a mesh was new or had changed.</summary>
        public long BvhsBuilt { get; set; }

        /// <summary>Triangles in the BVHs built.</summary>
        public long TrianglesBuilt { get; set; }

        /// <summary>Bytes written to the device.</summary>
        public long BytesUploaded { get; set; }

        /// <summary>Bytes read back from the device.</summary>
        public long BytesReadBack { get; set; }

        /// <summary>Bytes of all the radar's buffers on the device.</summary>
        public long BytesOnDevice { get; set; }

        /// <summary>Times that the computer waits for the device: read-backs of a slice, or of its rays.</summary>
        public int RoundTrips { get; set; }

        /// <summary>Kernel launches.</summary>
        public int Dispatches { get; set; }

        /// <summary>Tiles of 8 x 8 rays traced.</summary>
        public long TilesTraced { get; set; }

        /// <summary>Tiles skipped because they cannot see the scene.</summary>
        public long TilesSkipped { get; set; }

        /// <summary>Candidates traced again in double-float arithmetic.</summary>
        public long RaysRefined { get; set; }

        /// <summary>Sub-rays around received rays, for the sampling error.</summary>
        public long SubRays { get; set; }

        /// <summary>
        /// Facets of seas, groups of which count once; each has a shadow ray if it is in the picture and faces the radar.
        /// </summary>
        public long SeaFacets { get; set; }

        /// <summary>BVH nodes read; 0 unless the tracer was asked to count.</summary>
        public long NodesVisited { get; set; }

        /// <summary>Pairs of triangles tested; 0 unless the tracer was asked to count.</summary>
        public long PairsTested { get; set; }

        /// <summary>Wall times.</summary>
        public Timings Timings { get; set; }
    }

    /// <summary>Wall time of the phases of one pose, milliseconds.</summary>
    public struct Timings
    {
        /// <summary>Gathering the scene's objects and reading new or changed meshes.</summary>
        public double GatherMs;

        /// <summary>Building BVHs over new or changed meshes.</summary>
        public double BuildMs;

        /// <summary>Uploading buffers to the device.</summary>
        public double UploadMs;

        /// <summary>Time from the dispatch to the end of the read-back; includes <see cref="ReadBackMs"/>.</summary>
        public double TraceMs;

        /// <summary>Reading back single rays.</summary>
        public double ReadBackMs;

        /// <summary>Listing tiles, and recording and submitting the device's work.</summary>
        public double DispatchMs;

        /// <summary>Blocked until the device's sums arrive.</summary>
        public double WaitMs;

        /// <summary>Sums and sampling error from what was read back; dispatches and waits not included.</summary>
        public double FinishMs;
    }
}
