using System;

namespace Glint.Core
{
    /// <summary>What sea there is: a tile that repeats without a seam. All of a surface follows from these numbers and the time, bit for bit on any machine.</summary>
    [Serializable]
    public struct SeaSettings
    {
        /// <summary>Metres. Tile sizes are multiples of it, so that float32 holds the edges of neighbouring tiles alike.</summary>
        public const double TileStep = 1.0 / 1024;

        /// <summary>Largest tile, metres.</summary>
        public const double LargestTile = 8192;

        /// <summary>Least and greatest number of grid points a side.</summary>
        public const int LeastGrid = 4, GreatestGrid = 1024;

        /// <summary>Most cells of the mesh a side.</summary>
        public const int MostCells = 2048;

        /// <summary>How the variance is spread over wavelengths.</summary>
        public SeaSpectrumKind Kind;

        /// <summary>Hs in metres: four standard deviations of the height, on average over seeds.</summary>
        public double SignificantWaveHeight;

        /// <summary>Metres a second, 10 m above the sea. It shapes the spectrum and leaves the height alone.</summary>
        public double WindSpeed;

        /// <summary>Where wind and waves run to, as Unity's rotation about Y: 0 to +Z, 90 to +X.</summary>
        public double WindDirectionDegrees;

        /// <summary>Horizontal displacement over that of waves in deep water (Gerstner's): 0 none, 1 theirs; crests curl over where it is large.</summary>
        public double Choppiness;

        /// <summary>Side of the tile in metres, a multiple of 1/1024 m up to 8192 m.</summary>
        public double TileSize;

        /// <summary>Grid points a side, a power of two from 4 to 1024: waves down to nearly 2 TileSize / GridSize are there.</summary>
        public int GridSize;

        /// <summary>Cells of the mesh a side, 1 to 2048. They sample the sea and do not change it; a power of two of at least GridSize is fastest.</summary>
        public int Cells;

        /// <summary>Metres. Shorter waves are left out; 0: none are.</summary>
        public double ShortestWave;

        /// <summary>Metres of water that the wind has blown over. JONSWAP only.</summary>
        public double Fetch;

        /// <summary>How much higher the peak is than that of a fully risen sea, 1 to 10. JONSWAP only.</summary>
        public double PeakEnhancement;

        /// <summary>Which of all seas with this spectrum. Finer grids of one seed, tile and wind have the same long waves.</summary>
        public int Seed;

        /// <summary>Multiplies the height: 1, or what <see cref="SeaSurface.FactorFor"/> gives a stored sea.</summary>
        public double HeightFactor;

        /// <summary>Sea state 4 of a breeze, 64 x 64 m.</summary>
        public static SeaSettings Default => new SeaSettings
        {
            Kind = SeaSpectrumKind.Phillips, SignificantWaveHeight = 2, WindSpeed = 7, Choppiness = 1, TileSize = 64, GridSize = 64, Cells = 64,
            Fetch = 100000, PeakEnhancement = 3.3, Seed = 1, HeightFactor = 1,
        };

        /// <summary>Refuses values that make no sea.</summary>
        /// <exception cref="GlintException">A value is out of its range.</exception>
        public void Validate()
        {
            if (!Enum.IsDefined(typeof(SeaSpectrumKind), Kind))
                throw new GlintException($"sea: spectrum {(int)Kind} must be {string.Join(" or ", Enum.GetNames(typeof(SeaSpectrumKind)))}");
            Check("significant wave height", SignificantWaveHeight, "m", 0.001, 100, "for a calm take a flat plate");
            Check("wind speed", WindSpeed, "m/s", 0.1, 100, "turn the wind by its direction, not by its sign");
            Check("wind direction", WindDirectionDegrees, "deg", -3600, 3600, "give it as a rotation about Y");
            Check("choppiness", Choppiness, "", 0, 10, "0 moves nothing sideways, 1 as waves in deep water do");
            Check("tile size", TileSize, "m", 1, LargestTile, "lay several tiles side by side for a larger sea");
            double steps = TileSize / TileStep;
            if (steps != Math.Floor(steps))
                throw new GlintException($"sea: tile size {Text(TileSize)} m must be a multiple of 1/1024 m, or neighbouring tiles would not meet: use {Text(Math.Floor(steps + 0.5) * TileStep)}");
            if (GridSize < LeastGrid || GridSize > GreatestGrid || (GridSize & (GridSize - 1)) != 0)
                throw new GlintException($"sea: grid size {GridSize} must be a power of two from {LeastGrid} to {GreatestGrid}: the mesh may have any number of cells, set that instead");
            Check("cells", Cells, "", 1, MostCells, "lay several tiles side by side for a larger sea");
            Check("shortest wave", ShortestWave, "m", 0, TileSize / 2, "0 leaves none out");
            if (Kind == SeaSpectrumKind.Jonswap)
            {
                Check("fetch", Fetch, "m", 100, 1e7, "100000 is usual");
                Check("peak enhancement", PeakEnhancement, "", 1, 10, "3.3 is usual");
            }
            Check("height factor", HeightFactor, "", 0.001, 1000, "1 leaves the height as asked for");
        }

        static void Check(string name, double value, string unit, double least, double greatest, string wayOut)
        {
            if (!(value >= least && value <= greatest))
                throw new GlintException($"sea: {name} {Text(value)}{(unit == "" ? "" : " " + unit)} must be from {Text(least)} to {Text(greatest)}: {wayOut}");
        }

        static string Text(double value) => RadarSettings.Text(value);
    }
}
