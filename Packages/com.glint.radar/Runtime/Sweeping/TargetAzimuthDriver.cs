using Glint.Core;
using UnityEngine;

namespace Glint
{
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
