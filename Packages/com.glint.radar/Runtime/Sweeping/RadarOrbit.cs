using System;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint
{
    /// <summary>
    /// Places a radar at a grazing angle and a distance from the point it looks at.
    /// Angle and distance are in single precision; the point does not move.
    /// </summary>
    public sealed class RadarOrbit : AxisDriver
    {
        // Cosine of the angle to the vertical, 0.8 degrees, below which the view axis has no compass direction.
        const double SteepestForward = 0.9999;
        const float ScaleTolerance = 1e-5f;

        readonly Transform _aim, _radar;
        readonly double _azimuthDegrees, _rollDegrees;
        readonly Sea[] _followers;
        Quaternion _rotation;
        float _distance;
        Action _restore;

        RadarOrbit(Transform aim, Transform radar, double azimuthDegrees, double rollDegrees)
        {
            _aim = aim;
            _radar = radar;
            _azimuthDegrees = azimuthDegrees;
            _rollDegrees = rollDegrees;
            _followers = SceneSearch.FindEnabled<Sea>()
                .Where(sea => sea.Centre != null && sea.Centre.IsChildOf(radar)).ToArray();
        }

        /// <summary>An orbit of a radar that looks at a mesh file; the radar is a child of the aim.</summary>
        internal static RadarOrbit Of(Transform aim, Transform radar, in RadarPlacement placement)
        {
            var orbit = new RadarOrbit(aim, radar, placement.AzimuthDegrees, 0);
            orbit.SetGrazing(placement.GrazingDegrees);
            orbit.SetDistance(placement.Distance);
            orbit.Remember();
            return orbit;
        }

        /// <summary>
        /// An orbit of a scene's radar about the point of its view axis nearest to the target.
        /// The radar keeps its pose at first, and is restored at the end.
        /// </summary>
        /// <param name="changesGrazing">Whether the grazing angle changes.</param>
        /// <exception cref="GlintException">
        /// There is no such point, the view axis has no compass direction, or the receiver is not below the radar.
        /// </exception>
        internal static RadarOrbit About(RadarController controller, Transform target, bool changesGrazing)
        {
            var radar = controller.transform;
            string subject = $"RadarController of '{controller.name}'";
            if (controller.Receiver != null && !controller.Receiver.IsChildOf(radar))
                throw new GlintException($"{subject} cannot be moved by a sweep: its receiver "
                    + $"'{controller.Receiver.name}' would stay behind: put it below the radar in the hierarchy");
            if (target.IsChildOf(radar) || radar.IsChildOf(target))
                throw new GlintException($"{subject} cannot be moved about '{target.name}': "
                    + "one is below the other in the hierarchy: separate them");
            if (radar.parent != null && math.any(math.abs((float3)radar.parent.lossyScale - 1) > ScaleTolerance))
                throw new GlintException($"{subject} cannot be moved by a sweep: '{radar.parent.name}', above it, "
                    + "is scaled: give it and all above it the scale 1");
            double3 forward = (float3)radar.forward, position = (float3)radar.position;
            double distance = math.dot((float3)target.position - position, forward);
            if (!(distance > 0))
                throw new GlintException($"{subject} cannot be moved about '{target.name}', which is not before it: "
                    + "turn the radar to look at it");
            if (changesGrazing && math.abs(forward.y) > SteepestForward)
                throw new GlintException($"{subject} looks straight {(forward.y < 0 ? "down" : "up")}, "
                    + "so that its grazing angle does not give its position: tilt it a degree or more");
            return OrbitAbout(radar, position + distance * forward, (float)distance);
        }

        static RadarOrbit OrbitAbout(Transform radar, double3 point, float distance)
        {
            var (parent, position, rotation, order) =
                (radar.parent, radar.localPosition, radar.localRotation, radar.GetSiblingIndex());
            var aim = new GameObject("Radar Aim").transform;
            // Below the radar first: it takes the aim into its scene, where that stays if the radar has no parent.
            aim.SetParent(radar, false);
            aim.SetParent(parent, false);
            aim.rotation = radar.rotation;
            aim.position = new Vector3((float)point.x, (float)point.y, (float)point.z);
            var angles = radar.rotation.eulerAngles;
            radar.SetParent(aim, false);
            if (radar.parent != aim)
            {
                // In edit mode Unity does not move parts of a prefab instance, and only logs that.
                Object.DestroyImmediate(aim.gameObject);
                throw new GlintException($"RadarController of '{radar.name}' cannot be moved by a sweep: "
                    + "it is part of a prefab instance: unpack the prefab");
            }
            radar.localRotation = Quaternion.identity;
            var orbit = new RadarOrbit(aim, radar, angles.y, angles.z);
            orbit.SetDistance(distance);
            orbit.Remember();
            orbit._restore = () =>
            {
                radar.SetParent(parent, false);
                if (radar.parent == aim)
                {
                    // It has its pose again, below the aim, which must not be destroyed with it.
                    Debug.LogWarning($"RadarController of '{radar.name}' stays below '{aim.name}', where the sweep "
                        + "put it: Unity moves no object while the one above it is deactivated", radar);
                    return;
                }
                radar.SetSiblingIndex(order);
                (radar.localPosition, radar.localRotation) = (position, rotation);
                Object.DestroyImmediate(aim.gameObject);
            };
            return orbit;
        }

        internal override void Show(SweepPose pose)
        {
            if (_radar == null || _aim == null)
                throw new GlintException($"the radar of the sweep was destroyed before {pose}: "
                    + "it must stay until the last pose");
            if (pose[SweepAxis.Grazing] is double grazing)
                SetGrazing(grazing);
            if (pose[SweepAxis.Range] is double range)
                SetDistance(range);
            RebuildFollowers();
        }

        internal override void PutBack()
        {
            if (_radar == null && _restore != null && _aim != null)
                Object.DestroyImmediate(_aim.gameObject);
            if (_radar == null || _aim == null)
                return;
            _aim.localRotation = _rotation;
            SetDistance(_distance);
            _restore?.Invoke();
            RebuildFollowers();
        }

        void Remember() => (_rotation, _distance) = (_aim.localRotation, -_radar.localPosition.z);

        void SetGrazing(double grazingDegrees) =>
            _aim.rotation = Quaternion.Euler((float)grazingDegrees, (float)_azimuthDegrees, (float)_rollDegrees);

        void SetDistance(double distance) => _radar.localPosition = new Vector3(0, 0, -(float)distance);

        // Seas centred on the radar.
        void RebuildFollowers()
        {
            foreach (var sea in _followers.Where(sea => sea != null))
                sea.Rebuild();
        }
    }
}
