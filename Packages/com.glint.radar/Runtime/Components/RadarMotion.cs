using System;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// Velocity and turn rate of an object and of all objects below it without one of their own, for the pulses of a
    /// radar: it moves nothing. Without it an object has the velocities of the nearest Rigidbody at or above it.
    /// </summary>
    [AddComponentMenu("Glint/Radar Motion")]
    [DisallowMultipleComponent]
    [HelpPage("echo.md")]
    public sealed class RadarMotion : MonoBehaviour
    {
        [SerializeField, Tooltip("Velocity in m/s, along the world's axes.")]
        Vector3 _velocity;

        [SerializeField, Tooltip("Turn rates about the world's axes through this object's position, degrees a second.")]
        Vector3 _turnRates;

        /// <summary>Velocity, metres a second, along the world's axes.</summary>
        public Vector3 Velocity { get => _velocity; set => _velocity = value; }

        /// <summary>
        /// Turn rates about the world's axes through the object's position, degrees a second; about +Y from +Z towards
        /// +X.
        /// </summary>
        public Vector3 TurnRates { get => _turnRates; set => _turnRates = value; }

        /// <summary>
        /// Sets both from the pose that the object had, and the one that it has now: those at which it comes from one to
        /// the other in one turn.
        /// </summary>
        /// <param name="position">That it had in the world, metres.</param>
        /// <param name="rotation">That it had in the world.</param>
        /// <param name="seconds">Since then.</param>
        /// <exception cref="GlintException">The time is not above 0.</exception>
        public void SetFromPose(Vector3 position, Quaternion rotation, double seconds)
        {
            if (!(seconds > 0 && seconds < double.PositiveInfinity))
                throw new GlintException(FormattableString.Invariant(
                    $"RadarMotion of '{name}': poses {seconds} s apart have no velocity: give a time above 0"));
            double3 way = (double3)(float3)transform.position - (double3)(float3)position;
            _velocity = (float3)(way / seconds);
            var turn = transform.rotation * Quaternion.Inverse(rotation);
            double3 axis = new double3(turn.x, turn.y, turn.z) * (turn.w < 0 ? -1 : 1);
            double sine = math.length(axis), angle = 2 * Math.Atan2(sine, Math.Abs(turn.w));
            // Of small turns angle / sine is 2.
            _turnRates = (float3)(axis * ((sine > 0 ? angle / sine : 2) * 180 / Math.PI / seconds));
        }
    }
}
