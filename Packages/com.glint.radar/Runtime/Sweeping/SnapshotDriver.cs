using System.Collections.Generic;
using Glint.Core;

namespace Glint
{
    /// <summary>Shows a snapshot of a sea.</summary>
    sealed class SnapshotDriver : AxisDriver
    {
        readonly Sea _sea;
        readonly int _snapshot;

        /// <exception cref="GlintException">The sea has no such snapshot.</exception>
        public SnapshotDriver(Sea sea, IEnumerable<double> snapshots)
        {
            _sea = sea;
            _snapshot = sea.Snapshot;
            foreach (double snapshot in snapshots)
                sea.CheckSnapshot((int)snapshot);
        }

        internal override void Show(SweepPose pose)
        {
            if (_sea == null)
                throw new GlintException($"the Sea of the sweep was destroyed before {pose}: "
                    + "it must stay until the last pose");
            _sea.Snapshot = pose.Snapshot.Value;
        }

        internal override void PutBack()
        {
            if (_sea != null)
                _sea.Snapshot = _snapshot;
        }
    }
}
