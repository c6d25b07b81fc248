namespace Glint.Core
{
    /// <summary>One pose of a sweep and what the radar received in it.</summary>
    public readonly struct SweepRow
    {
        /// <summary>A row.</summary>
        /// <param name="pose">Where the sweep stood.</param>
        /// <param name="result">What was received.</param>
        public SweepRow(SweepPose pose, RadarResult result)
        {
            Pose = pose;
            Result = result;
        }

        /// <summary>Where the sweep stood.</summary>
        public SweepPose Pose { get; }

        /// <summary>What was received.</summary>
        public RadarResult Result { get; }
    }
}
