using System.Collections.Generic;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>Recipe of the stored snapshots of a sea.</summary>
    public sealed class SeaRecipe
    {
        /// <summary>A sea to be stored.</summary>
        /// <param name="name">Name of the sea, for files and messages.</param>
        /// <param name="settings">
        /// The recipe computes the height factor with which Hs of all snapshots together is the requested one.
        /// </param>
        /// <param name="times">Moments of the snapshots, seconds.</param>
        /// <param name="tiles">Tiles along X and Z of each snapshot.</param>
        /// <exception cref="GlintException">A setting is out of its range.</exception>
        public SeaRecipe(string name, SeaSettings settings, IReadOnlyList<double> times, int2 tiles)
        {
            Name = name;
            Times = times;
            Tiles = tiles;
            settings.HeightFactor = SeaSurface.FactorFor(settings, times);
            Settings = settings;
        }

        /// <summary>Name of the sea, for files and messages.</summary>
        public string Name { get; }

        /// <summary>Settings of the tile, including the height factor.</summary>
        public SeaSettings Settings { get; }

        /// <summary>Times of the snapshots, seconds.</summary>
        public IReadOnlyList<double> Times { get; }

        /// <summary>Tiles along X and Z of each snapshot, centred on the origin.</summary>
        public int2 Tiles { get; }
    }
}
