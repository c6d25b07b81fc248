using System;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// Moves an object at a steady speed along its forward axis while the scene plays, and turns it at a steady rate:
    /// ships for a <see cref="RadarScreen"/>.
    /// </summary>
    [AddComponentMenu("Glint/Underway")]
    [HelpPage("screen.md")]
    [DisallowMultipleComponent]
    public sealed class Underway : MonoBehaviour
    {
        const double KnotsAMetrePerSecond = 3600 / ScreenRadar.NauticalMile;

        [SerializeField, Tooltip("Speed along the forward axis in knots: a knot is 0.514 m/s.")]
        float _speedKnots = 10;

        [SerializeField, Tooltip("Rate of turn to starboard in degrees a minute.")]
        float _turnDegreesAMinute;

        /// <summary>Speed along the forward axis, knots.</summary>
        public float SpeedKnots { get => _speedKnots; set => _speedKnots = value; }

        /// <summary>Rate of turn to starboard, degrees a minute.</summary>
        public float TurnDegreesAMinute { get => _turnDegreesAMinute; set => _turnDegreesAMinute = value; }

        /// <summary>Moves the object for some seconds; Unity's Update calls it.</summary>
        public void Advance(double seconds)
        {
            double degrees = _turnDegreesAMinute / 60 * seconds / 2, angle = math.radians(degrees);
            // The chord of the arc, for a step of any length.
            double way = _speedKnots / KnotsAMetrePerSecond * seconds * (angle == 0 ? 1 : Math.Sin(angle) / angle);
            var half = Quaternion.Euler(0, (float)degrees, 0);
            transform.rotation = half * transform.rotation;
            transform.position += (float)way * transform.forward;
            transform.rotation = half * transform.rotation;
        }

        void Update() => Advance(Time.deltaTime);
    }
}
