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

    /// <summary>
    /// The two seas whose meshes are stored, each at ten times. One wind, choppiness, grid and seed:
    /// only their height differs, so each is the other enlarged upwards.
    /// A wind of 9 m/s puts the spectrum's peak, 7.7 v^2/g, on the longest wave that a tile of 64 m holds;
    /// choppiness 1 is that of waves in deep water.
    /// </summary>
    public static class StoredSeas
    {
        // Seconds, 10 apart: after 8 the waves of so small a tile are as far from what they were
        // as they come to be on average.
        static readonly double[] s_times = { 0, 10, 20, 30, 40, 50, 60, 70, 80, 90 };

        /// <summary>Significant wave height 2.5 m, the low end of the code's range.</summary>
        public static readonly SeaRecipe SeaState5 = OfHeight("SeaState5", 2.5);

        /// <summary>Significant wave height 6 m, the high end of the code's range.</summary>
        public static readonly SeaRecipe SeaState6 = OfHeight("SeaState6", 6);

        /// <summary>Both.</summary>
        public static readonly SeaRecipe[] All = { SeaState5, SeaState6 };

        // Two tiles, one behind the other as the radar of the published experiment sees them; the waves run towards it.
        static SeaRecipe OfHeight(string name, double height) => new SeaRecipe(name, new SeaSettings
        {
            Kind = SeaSpectrumKind.Phillips, SignificantWaveHeight = height,
            WindSpeed = 9, WindDirectionDegrees = 180, Choppiness = 1,
            TileSize = 64, GridSize = 64, Cells = 94, Seed = 9,
        }, s_times, new int2(1, 2));
    }
}
