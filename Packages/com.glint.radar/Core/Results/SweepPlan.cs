using System.Collections.Generic;

namespace Glint.Core
{
    /// <summary>The poses of a sweep, in order: every angle for each snapshot.</summary>
    public sealed class SweepPlan
    {
        /// <summary>One pose that moves nothing.</summary>
        public static readonly SweepPlan Single = new SweepPlan(null);

        readonly SweepPose[] _poses;

        /// <param name="angles">Turns of the target in degrees; null when it is not turned.</param>
        /// <param name="snapshots">Snapshots of the sea, from 1; null when it is left as it is.</param>
        public SweepPlan(IReadOnlyList<double> angles, IReadOnlyList<int> snapshots = null)
        {
            Turns = angles != null;
            HasSnapshots = snapshots != null;
            int inner = angles?.Count ?? 1, outer = snapshots?.Count ?? 1;
            _poses = new SweepPose[inner * outer];
            for (int i = 0; i < _poses.Length; i++)
                _poses[i] = new SweepPose(angles?[i % inner], snapshots?[i / inner]);
        }

        /// <summary>Poses in all.</summary>
        public int Count => _poses.Length;

        /// <summary>Whether the target is turned.</summary>
        public bool Turns { get; }

        /// <summary>Whether the sea steps from snapshot to snapshot.</summary>
        public bool HasSnapshots { get; }

        public SweepPose this[int pose] => _poses[pose];
    }
}
