namespace Glint.Core
{
    /// <summary>What one pose made the computer do: counts that no machine's speed changes, and wall times.</summary>
    public sealed class TraceStatistics
    {
        /// <summary>Objects with a mesh, and triangles, that were traced.</summary>
        public long Objects { get; internal set; }

        /// <inheritdoc cref="Objects"/>
        public long Triangles { get; internal set; }

        /// <summary>BVHs built because a mesh was new or had changed.</summary>
        public long BvhsBuilt { get; internal set; }

        /// <summary>Triangles in them.</summary>
        public long TrianglesBuilt { get; internal set; }

        /// <summary>Bytes written to the device.</summary>
        public long BytesUploaded { get; internal set; }

        /// <summary>Bytes read back from the device.</summary>
        public long BytesReadBack { get; internal set; }

        /// <summary>Bytes of all the radar's buffers on the device.</summary>
        public long BytesOnDevice { get; internal set; }

        /// <summary>Kernel launches.</summary>
        public int Dispatches { get; internal set; }

        /// <summary>Tiles of 8 x 8 rays traced.</summary>
        public long TilesTraced { get; internal set; }

        /// <summary>Tiles left out because nothing of the scene can be in them.</summary>
        public long TilesSkipped { get; internal set; }

        /// <summary>Rays followed once more in double-float arithmetic because they may be received.</summary>
        public long RaysRefined { get; internal set; }

        /// <summary>Smaller rays around received ones, for the sampling error.</summary>
        public long SubRays { get; internal set; }

        /// <summary>BVH nodes read; 0 unless the tracer was asked to count.</summary>
        public long NodesVisited { get; internal set; }

        /// <summary>Pairs of triangles tested; 0 unless the tracer was asked to count.</summary>
        public long PairsTested { get; internal set; }

        /// <summary>Wall times.</summary>
        public Timings Timings { get; internal set; }

        /// <summary>Adds what was found before the pose was traced.</summary>
        internal void SetGathered(long objects, double milliseconds)
        {
            Objects = objects;
            var timings = Timings;
            timings.GatherMs = milliseconds;
            Timings = timings;
        }
    }

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
