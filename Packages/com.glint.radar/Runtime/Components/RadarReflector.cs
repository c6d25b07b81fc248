using System;
using System.Collections.Generic;
using Glint.Core;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// A reflector that a <see cref="RadarScreen"/> shows as a point: its cross section at this object's position. A
    /// buoy's corner reflector has 10 m2, a ship of 500 tons some 1,800 m2.
    /// </summary>
    [AddComponentMenu("Glint/Radar Reflector")]
    [HelpPage("screen.md")]
    [ExecuteAlways]
    public sealed class RadarReflector : MonoBehaviour
    {
        static readonly List<RadarReflector> s_enabled = new List<RadarReflector>();

        [SerializeField, Min(0), Tooltip("Radar cross section in square metres.")]
        double _crossSection = 10;

        /// <summary>All enabled reflectors of the loaded scenes, in no order.</summary>
        internal static IReadOnlyList<RadarReflector> Enabled => s_enabled;

        /// <summary>Radar cross section, square metres.</summary>
        /// <exception cref="GlintException">It is below 0 or not finite.</exception>
        public double CrossSection
        {
            get => _crossSection;
            set => _crossSection = value >= 0 && value < double.PositiveInfinity ? value : throw new GlintException(
                FormattableString.Invariant(
                    $"RadarReflector of '{name}': a cross section of {value} m2 must be 0 or more and finite"));
        }

        void OnEnable() => s_enabled.Add(this);

        void OnDisable() => s_enabled.Remove(this);
    }
}
