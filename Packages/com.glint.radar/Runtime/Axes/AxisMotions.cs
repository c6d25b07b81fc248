using System;
using System.Collections.Generic;
using Glint.Core;
using UnityEngine;

namespace Glint
{
    /// <summary>Shows the poses of a sweep, each axis by its own motion. Disposing puts everything back.</summary>
    sealed class AxisMotions : IDisposable
    {
        readonly List<AxisMotion> _motions = new List<AxisMotion>();

        /// <param name="mount">Moves the radar; null: one about the target.</param>
        /// <exception cref="GlintException">An axis has nothing that it could move, or not so.</exception>
        public AxisMotions(SweepPlan plan, RadarController radar, Transform target, Sea sea, RadarMount mount)
        {
            if (target != null)
                StandCheck.RefuseNowhere(target, $"the target '{target.name}' of the sweep");
            try
            {
                if (plan.Has(SweepAxis.Snapshot))
                    _motions.Add(new ShownSnapshot(sea, plan.Values(SweepAxis.Snapshot)));
                if (plan.Has(SweepAxis.Frequency))
                    _motions.Add(new Carrier(radar));
                if (plan.Has(SweepAxis.Range) || plan.Has(SweepAxis.Grazing))
                    _motions.Add(mount ?? RadarMount.About(radar, target, plan.Has(SweepAxis.Grazing)));
                if (plan.Has(SweepAxis.Angle))
                    _motions.Add(new TargetTurn(target, radar));
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        /// <summary>Shows a pose.</summary>
        /// <exception cref="GlintException">What was to be moved is gone.</exception>
        public void Show(SweepPose pose)
        {
            foreach (var motion in _motions)
                motion.Show(pose);
        }

        public void Dispose()
        {
            for (int i = _motions.Count - 1; i >= 0; i--)
                _motions[i].PutBack();
            _motions.Clear();
        }
    }
}
