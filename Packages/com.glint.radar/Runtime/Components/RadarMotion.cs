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
    }
}
