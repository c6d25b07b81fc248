using System.Linq;

namespace Glint.Core
{
    /// <summary>
    /// A pose of a sweep: a value for each axis that is swept, null for the others.
    /// </summary>
    public readonly struct SweepPose
    {
        readonly double?[] _values;

        /// <summary>A pose of a sweep over angles, snapshots, or both.</summary>
        /// <param name="angleDegrees">
        /// Turn of the target about the world's vertical, positive as Unity's Y rotation.
        /// </param>
        /// <param name="snapshot">Snapshot of the sea, from 1.</param>
        public SweepPose(double? angleDegrees, int? snapshot = null) : this(new double?[SweepAxis.All.Count])
        {
            _values[SweepAxis.Angle.Index] = angleDegrees;
            _values[SweepAxis.Snapshot.Index] = snapshot;
        }

        /// <param name="values">In the order of <see cref="SweepAxis.All"/>; kept, not copied.</param>
        internal SweepPose(double?[] values) => _values = values;

        /// <summary>The value on an axis, in its unit.</summary>
        public double? this[SweepAxis axis] => _values?[axis.Index];

        /// <summary>Turn of the target in degrees.</summary>
        public double? AngleDegrees => this[SweepAxis.Angle];

        /// <summary>Snapshot of the sea, from 1.</summary>
        public int? Snapshot => (int?)this[SweepAxis.Snapshot];

        /// <summary>
        /// The pose in a few words: "15 deg", "snapshot 3", "snapshot 3, 15 deg"; empty for a pose that moves nothing.
        /// </summary>
        public override string ToString()
        {
            var pose = this;
            return string.Join(", ",
                SweepAxis.All.Where(axis => pose[axis].HasValue).Select(axis => axis.Describe(pose[axis].Value)));
        }
    }

    /// <summary>A pose of a sweep and its result.</summary>
    public readonly struct SweepRow
    {
        /// <summary>A row.</summary>
        /// <param name="pose">The pose.</param>
        /// <param name="result">Its result.</param>
        public SweepRow(SweepPose pose, RadarResult result) =>
            (Pose, Result) = (pose, result);

        /// <summary>Where the sweep stood.</summary>
        public SweepPose Pose { get; }

        /// <summary>What was received.</summary>
        public RadarResult Result { get; }
    }
}
