using System.Collections.Generic;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>What the stored snapshots of a sea are made from.</summary>
    public sealed class SeaRecipe
    {
        /// <summary>A sea to be stored.</summary>
        /// <param name="name">Of the sea, for files and messages.</param>
        /// <param name="settings">
        /// Its height factor is found here: the one that makes Hs of all snapshots together that asked for.
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

        /// <summary>Of the sea, for files and messages.</summary>
        public string Name { get; }

        /// <summary>What the tile is made from, the height factor included.</summary>
        public SeaSettings Settings { get; }

        /// <summary>Moments of the snapshots, seconds.</summary>
        public IReadOnlyList<double> Times { get; }

        /// <summary>Tiles along X and Z of each snapshot, laid about the origin.</summary>
        public int2 Tiles { get; }
    }
}
