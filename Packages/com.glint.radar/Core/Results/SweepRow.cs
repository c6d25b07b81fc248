namespace Glint.Core
{
    /// <summary>One pose of a sweep and what the radar received in it.</summary>
    public readonly struct SweepRow
    {
        /// <param name="pose">Where the sweep stood.</param>
        /// <param name="result">What was received.</param>
        public SweepRow(SweepPose pose, RadarResult result)
        {
            Pose = pose;
            Result = result;
        }

        public SweepPose Pose { get; }

        public RadarResult Result { get; }
    }
}
