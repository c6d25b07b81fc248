using Glint.Core;
using Unity.Mathematics;

namespace Glint.Editor
{
    /// <summary>
    /// The two seas whose meshes are stored, each at ten times. They have the same wind, choppiness, grid and seed and
    /// differ in height only. A wind of 9 m/s puts the spectrum's peak, 7.7 v^2/g, on the longest wave that a tile of
    /// 64 m holds; choppiness 1 is that of deep-water waves.
    /// </summary>
    public static class StoredSeas
    {
        // Seconds, 10 apart: the waves of this small tile decorrelate after 8.
        static readonly double[] s_times = { 0, 10, 20, 30, 40, 50, 60, 70, 80, 90 };

        /// <summary>Significant wave height 2.5 m, the low end of the code's range.</summary>
        public static readonly SeaRecipe SeaState5 = OfHeight("SeaState5", 2.5);

        /// <summary>Significant wave height 6 m, the high end of the code's range.</summary>
        public static readonly SeaRecipe SeaState6 = OfHeight("SeaState6", 6);

        /// <summary>Both seas.</summary>
        public static readonly SeaRecipe[] All = { SeaState5, SeaState6 };

        // Two tiles, one behind the other as the radar of the published experiment sees them; the waves travel towards
        // it.
        static SeaRecipe OfHeight(string name, double height) => new SeaRecipe(name, new SeaSettings
        {
            Kind = SeaSpectrumKind.Phillips, SignificantWaveHeight = height,
            WindSpeed = 9, WindDirectionDegrees = 180, Choppiness = 1,
            TileSize = 64, GridSize = 64, Cells = 94, Seed = 9,
        }, s_times, new int2(1, 2));
    }
}
