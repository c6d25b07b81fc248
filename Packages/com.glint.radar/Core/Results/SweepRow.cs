namespace Glint.Core
{
    /// <summary>One pose of a sweep and what the radar received in it.</summary>
    public readonly struct SweepRow
    {
        /// <param name="angleDegrees">Turn of the target about the world vertical, positive as Unity's Y rotation; 0 for a single run.</param>
        public SweepRow(double angleDegrees, RadarResult result)
        {
            AngleDegrees = angleDegrees;
            Result = result;
        }

        /// <summary>Turn of the target in degrees.</summary>
        public double AngleDegrees { get; }

        public RadarResult Result { get; }
    }
}
