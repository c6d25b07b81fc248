using System;
using System.Collections.Generic;
using Glint.Core;

namespace Glint
{
    /// <summary>Applies the poses of a sweep by a driver for each axis. Disposing restores the scene.</summary>
    sealed class AxisDrivers : IDisposable
    {
        readonly List<AxisDriver> _motions = new List<AxisDriver>();

        /// <exception cref="GlintException">An axis has no object to move, or cannot move it.</exception>
        public AxisDrivers(SweepSetup setup)
        {
            var plan = setup.Plan;
            if (setup.Target != null && !setup.Target.gameObject.scene.IsValid())
                throw new GlintException($"the target '{setup.Target.name}' of the sweep is a prefab: "
                    + "choose the object in the scene");
            if (setup.Target != null)
                FiniteCheck.RefuseNotFinite(setup.Target, $"the target '{setup.Target.name}' of the sweep");
            try
            {
                if (plan.Has(SweepAxis.Snapshot))
                    _motions.Add(new SnapshotDriver(setup.Sea, plan.Values(SweepAxis.Snapshot)));
                if (plan.Has(SweepAxis.Frequency))
                    _motions.Add(new FrequencyDriver(setup.Radar));
                if (plan.Has(SweepAxis.Range) || plan.Has(SweepAxis.Grazing))
                    _motions.Add(setup.Orbit
                        ?? RadarOrbit.About(setup.Radar, setup.Target, plan.Has(SweepAxis.Grazing)));
                if (plan.Has(SweepAxis.Angle))
                    _motions.Add(new TargetAzimuthDriver(setup.Target, setup.Radar));
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        /// <summary>Applies a pose.</summary>
        /// <exception cref="GlintException">An object to move was destroyed.</exception>
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
