namespace Glint.Core
{
    /// <summary>Where a sweep stands: a value for each thing that it moves, null for what it leaves alone.</summary>
    public readonly struct SweepPose
    {
        /// <param name="angleDegrees">Turn of the target about the world's vertical, positive as Unity's Y rotation.</param>
        /// <param name="snapshot">Which snapshot of the sea, from 1.</param>
        public SweepPose(double? angleDegrees, int? snapshot = null)
        {
            AngleDegrees = angleDegrees;
            Snapshot = snapshot;
        }

        /// <summary>Turn of the target in degrees.</summary>
        public double? AngleDegrees { get; }

        /// <summary>Which snapshot of the sea, from 1.</summary>
        public int? Snapshot { get; }

        /// <summary>The pose in a few words: "15 deg", "snapshot 3", "snapshot 3, 15 deg"; empty for a pose that moves nothing.</summary>
        public override string ToString()
        {
            string snapshot = Snapshot.HasValue ? $"snapshot {Numbers.Format(Snapshot.Value)}" : "", angle = AngleDegrees.HasValue ? $"{Numbers.Format(AngleDegrees.Value)} deg" : "";
            return snapshot.Length > 0 && angle.Length > 0 ? $"{snapshot}, {angle}" : snapshot + angle;
        }
    }
}
