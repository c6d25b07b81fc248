using Glint.Core;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// A stored moment of a sea: the mesh of a tile and its recipe, on the root of a prefab that shows the sea.
    /// <c>glint sea</c> writes such prefabs.
    /// </summary>
    [AddComponentMenu("")]
    [HelpPage("sea.md")]
    [DisallowMultipleComponent]
    public sealed class SeaSnapshot : MonoBehaviour
    {
        [SerializeField, Tooltip("The tile, periodic over its width.")]
        Mesh _tile;

        [SerializeField, Tooltip("Settings that the tile was made from. To change it, make another with glint sea.")]
        SeaSettings _settings;

        [SerializeField, Tooltip("Time of the sea in seconds.")]
        double _timeSeconds;

        [SerializeField, Tooltip("Significant wave height at this time in metres: 4 times the standard deviation of "
            + "its heights. Over the snapshots of a sea it varies around the requested one.")]
        double _waveHeight;

        /// <summary>The tile, periodic over its width.</summary>
        public Mesh Tile => _tile;

        /// <summary>Settings of the tile.</summary>
        public SeaSettings Settings => _settings;

        /// <summary>Time of the sea, seconds.</summary>
        public double TimeSeconds => _timeSeconds;

        /// <summary>Significant wave height of this moment, metres.</summary>
        public double WaveHeight => _waveHeight;

        /// <summary>Describes the mesh of a tile.</summary>
        /// <param name="timeSeconds">Time of the sea, seconds.</param>
        /// <param name="waveHeight">Significant wave height of this moment, metres.</param>
        public void Set(Mesh tile, SeaSettings settings, double timeSeconds, double waveHeight) =>
            (_tile, _settings, _timeSeconds, _waveHeight) = (tile, settings, timeSeconds, waveHeight);
    }
}
