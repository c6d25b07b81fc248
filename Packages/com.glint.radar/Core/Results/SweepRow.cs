namespace Glint.Core
{
    /// <summary>A pose of a sweep and its result.</summary>
    public readonly struct SweepRow
    {
        /// <summary>A row.</summary>
        /// <param name="pose">The pose.</param>
        /// <param name="result">Its result.</param>
        public SweepRow(SweepPose pose, RadarResult result)
        {
            Pose = pose;
            Result = result;
        }

        /// <summary>The pose.</summary>
        public SweepPose Pose { get; }

        /// <summary>Its result.</summary>
        public RadarResult Result { get; }
    }
}
