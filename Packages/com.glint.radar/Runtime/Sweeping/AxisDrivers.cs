using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// Applies the poses of a sweep by a driver for each axis. Disposing restores the scene; what cannot be restored is
    /// said in the log, and does not keep the rest from it.
    /// </summary>
    sealed class AxisDrivers : IDisposable
    {
        // Drivers of one axis, or of several together, in the order in which they are applied.
        static readonly (SweepAxis[] axes, Func<SweepSetup, AxisDriver> make)[] s_makers =
        {
            (new[] { SweepAxis.Snapshot }, setup => new SnapshotDriver(setup)),
            (new[] { SweepAxis.Frequency }, setup => new FrequencyDriver(setup.Radar)),
            (new[] { SweepAxis.Range, SweepAxis.Grazing }, setup => setup.Orbit
                ?? RadarOrbit.About(setup.Radar, setup.Target, setup.Plan.Has(SweepAxis.Grazing))),
            (new[] { SweepAxis.Angle }, setup => new TargetAzimuthDriver(setup.Target, setup.Radar))
        };

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
                foreach (var (axes, make) in s_makers)
                    if (axes.Any(plan.Has))
                        _motions.Add(make(setup));
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
                try
                {
                    _motions[i].PutBack();
                }
                catch (GlintException problem)
                {
                    Debug.LogError($"the scene is not as it was before the sweep: {problem.Message}");
                }
            _motions.Clear();
        }
    }

    /// <summary>Applies the values of a sweep axis to the scene.</summary>
    public abstract class AxisDriver
    {
        private protected AxisDriver()
        {
        }

        /// <summary>Applies a pose's value on the axis.</summary>
        /// <exception cref="GlintException">The object to move was destroyed.</exception>
        internal abstract void Show(SweepPose pose);

        /// <summary>Restores the state before the first pose.</summary>
        internal abstract void PutBack();
    }

    /// <summary>Shows a snapshot of a sea.</summary>
    sealed class SnapshotDriver : AxisDriver
    {
        readonly Sea _sea;
        readonly int _snapshot;

        /// <exception cref="GlintException">The sea lacks a snapshot.</exception>
        public SnapshotDriver(SweepSetup setup)
        {
            _sea = setup.Sea;
            _snapshot = _sea.Snapshot;
            foreach (double snapshot in setup.Plan.Values(SweepAxis.Snapshot))
                _sea.CheckSnapshot((int)snapshot);
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

    /// <summary>Sets the radar's carrier frequency.</summary>
    sealed class FrequencyDriver : AxisDriver
    {
        readonly RadarController _radar;
        readonly double _frequencyHz;

        public FrequencyDriver(RadarController radar)
        {
            _radar = radar;
            _frequencyHz = radar.Settings.FrequencyHz;
        }

        internal override void Show(SweepPose pose) => Set(pose[SweepAxis.Frequency].Value);

        internal override void PutBack()
        {
            if (_radar != null)
                Set(_frequencyHz);
        }

        void Set(double frequencyHz)
        {
            var settings = _radar.Settings;
            settings.FrequencyHz = frequencyHz;
            _radar.Settings = settings;
        }
    }

    /// <summary>
    /// Turns the target about the world's vertical through its own position, relative to its initial rotation.
    /// </summary>
    sealed class TargetAzimuthDriver : AxisDriver
    {
        readonly Transform _target;
        readonly Quaternion _rotation, _localRotation;
        readonly RadarController _radar;
        readonly bool _isAnnounced;

        public TargetAzimuthDriver(Transform target, RadarController radar)
        {
            _target = target;
            (_rotation, _localRotation) = (target.rotation, target.localRotation);
            _radar = radar;
            _isAnnounced = radar.Gatherer.ExpectMotion(target);
        }

        internal override void Show(SweepPose pose)
        {
            if (_target == null)
                throw new GlintException($"the target of the sweep was destroyed before {pose}: "
                    + "it must stay until the last pose");
            _target.rotation = Quaternion.AngleAxis((float)pose.AngleDegrees.Value, Vector3.up) * _rotation;
        }

        internal override void PutBack()
        {
            if (_target != null)
                _target.localRotation = _localRotation;
            // The target of this sweep must not affect the rigid groups of the next one.
            if (_isAnnounced && _radar != null)
                _radar.Gatherer.ExpectNoMotion(_target);
        }
    }
}
