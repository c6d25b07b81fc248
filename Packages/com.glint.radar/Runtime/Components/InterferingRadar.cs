using System;
using System.Collections.Generic;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// Another radar, whose pulses every <see cref="RadarScreen"/> of the scene receives: dots that lie on curves from
    /// spoke to spoke. It has the antenna and the pulse length of the screen.
    /// </summary>
    [AddComponentMenu("Glint/Interfering Radar")]
    [HelpPage("screen.md")]
    [ExecuteAlways]
    public sealed class InterferingRadar : MonoBehaviour
    {
        static readonly List<InterferingRadar> s_enabled = new List<InterferingRadar>();

        [SerializeField, Range(1e-6f, 1e6f), Tooltip("Peak power of a pulse in watts, as far as it is in the bandwidth of "
            + "the receiver.")]
        float _power = 25000;

        [SerializeField, Range(1, 1e6f), Tooltip("Pulses a second.")]
        float _pulseRate = 2100;

        [SerializeField, Range(0, 240), Tooltip("Turns of its antenna a minute, clockwise.")]
        float _turnsAMinute = 26;

        [SerializeField, Tooltip("True bearing of its antenna in degrees when the screen's antenna first passes north.")]
        float _startBearing;

        /// <summary>All enabled ones of the loaded scenes, in no order.</summary>
        internal static IReadOnlyList<InterferingRadar> Enabled => s_enabled;

        /// <summary>Peak power in the receiver's bandwidth, watts.</summary>
        /// <exception cref="GlintException">It is not above 0, or not finite.</exception>
        public float Power { get => _power; set => _power = Positive("power", value, "W"); }

        /// <summary>Pulses a second.</summary>
        /// <exception cref="GlintException">It is not above 0, or not finite.</exception>
        public float PulseRate { get => _pulseRate; set => _pulseRate = Positive("pulse rate", value, "Hz"); }

        /// <summary>Turns of its antenna a minute; 0: it stands still.</summary>
        /// <exception cref="GlintException">It is not finite.</exception>
        public float TurnsAMinute
        {
            get => _turnsAMinute;
            set => _turnsAMinute = Finite("turn rate", value, "a minute");
        }

        /// <summary>True bearing of its antenna when the screen's own first passes north, degrees.</summary>
        /// <exception cref="GlintException">It is not finite.</exception>
        public float StartBearing
        {
            get => _startBearing;
            set => _startBearing = Finite("start bearing", value, "deg");
        }

        /// <summary>It as a screen sees it.</summary>
        /// <param name="offset">From the screen's antenna, metres: x to the east, y up, z to the north.</param>
        /// <param name="antennaHeight">Of the screen's antenna above the sea.</param>
        internal OtherRadar Seen(double3 offset, double antennaHeight) => new OtherRadar
        {
            Offset = offset, AntennaHeight = antennaHeight, Power = _power, PulseRate = _pulseRate,
            TurnsAMinute = _turnsAMinute, StartTurns = _startBearing / 360
        };

        float Positive(string what, float value, string unit) => value > 0 && value < float.PositiveInfinity ? value
            : throw Wrong(what, value, unit, "above 0 and finite");

        float Finite(string what, float value, string unit) => math.isfinite(value) ? value
            : throw Wrong(what, value, unit, "finite");

        GlintException Wrong(string what, float value, string unit, string demand) => new GlintException(
            FormattableString.Invariant($"InterferingRadar of '{name}': a {what} of {value} {unit} must be {demand}"));

        void OnEnable() => s_enabled.Add(this);

        void OnDisable() => s_enabled.Remove(this);
    }
}
