namespace Glint.Core
{
    /// <summary>What one pose made the computer do, in counts that no machine's speed changes.</summary>
    public struct WorkDone
    {
        /// <summary>Trees built because a mesh was new or had changed, and the triangles in them.</summary>
        public long TreesBuilt, TrianglesBuilt;

        /// <summary>Bytes written to the device, and read back from it.</summary>
        public long BytesUploaded, BytesReadBack;

        /// <summary>Bytes of all the radar's buffers on the device.</summary>
        public long BytesOnDevice;

        /// <summary>Kernel launches.</summary>
        public int Dispatches;

        /// <summary>
        /// Tiles of 8 x 8 rays traced, and those left out because nothing of the scene can be in them.
        /// </summary>
        public long TilesTraced, TilesSkipped;

        /// <summary>
        /// Rays followed once more in two-float arithmetic because they may be received,
        /// and smaller ones around them for the sampling error.
        /// </summary>
        public long RaysFollowedExactly, SubRays;

        /// <summary>Boxes' nodes read and pairs of triangles tested; 0 unless the tracer was asked to count.</summary>
        public long NodesVisited, PairsTested;
    }
}
