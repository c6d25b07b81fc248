using System;

namespace Glint.Core
{
    /// <summary>
    /// Settings of a sea's tile, which repeats without a seam. The surface is a function of these numbers and the time,
    /// bit for bit on any machine.
    /// </summary>
    [Serializable]
    public struct SeaSettings
    {
        /// <summary>
        /// Metres. Tile sizes are multiples of it, so that the edges of neighbouring tiles round to the same float32.
        /// </summary>
        public const double TileStep = 1.0 / 1024;

        internal static readonly Interval Heights = Interval.Closed(0.001, 100), Winds = Interval.Closed(0.1, 100),
            Directions = Interval.Closed(-360, 360),
            Choppinesses = Interval.Closed(0, 10), Tiles = Interval.Closed(1, 8192),
            Grids = Interval.Closed(4, 1024), CellCounts = Interval.Closed(1, 2048),
            Fetches = Interval.Closed(100, 1e7), PeakEnhancements = Interval.Closed(1, 10);

        static readonly Interval s_factors = Interval.Closed(0.001, 1000);

        /// <summary>Distribution of the variance over wavelengths.</summary>
        public SeaSpectrumKind Kind;

        /// <summary>Hs in metres: four standard deviations of the height, on average over seeds.</summary>
        public double SignificantWaveHeight;

        /// <summary>Metres a second, 10 m above the sea. It sets the shape of the spectrum, not the height.</summary>
        public double WindSpeed;

        /// <summary>Direction in which wind and waves travel, as Unity's rotation about Y: 0 is +Z, 90 is +X.</summary>
        public double WindDirectionDegrees;

        /// <summary>
        /// Horizontal displacement as a multiple of that of deep-water waves (Gerstner's); crests curl over where it is
        /// large.
        /// </summary>
        public double Choppiness;

        /// <summary>Side of the tile in metres, a multiple of 1/1024 m up to 8192 m.</summary>
        public double TileSize;

        /// <summary>
        /// Grid points a side, a power of two from 4 to 1024. The shortest wave is nearly 2 TileSize / GridSize.
        /// </summary>
        public int GridSize;

        /// <summary>
        /// Cells of the mesh a side, 1 to 2048. They sample the sea and do not change it;
        /// a power of two of at least GridSize is fastest.
        /// </summary>
        public int Cells;

        /// <summary>Metres. Shorter waves are omitted; 0: all waves.</summary>
        public double ShortestWave;

        /// <summary>Fetch in metres. JONSWAP only.</summary>
        public double Fetch;

        /// <summary>Ratio of the peak to that of a fully developed sea, 1 to 10. JONSWAP only.</summary>
        public double PeakEnhancement;

        /// <summary>
        /// Seed of the random numbers. Finer grids of one seed, tile and wind have the same long waves.
        /// </summary>
        public int Seed;

        /// <summary>Multiplies the height: 1, or what <see cref="SeaSurface.FactorFor"/> gives a stored sea.</summary>
        public double HeightFactor;

        /// <summary>Sea state 4 of a breeze, 64 x 64 m.</summary>
        public static SeaSettings Default => new SeaSettings
        {
            Kind = SeaSpectrumKind.Phillips, SignificantWaveHeight = 2, WindSpeed = 7,
            Choppiness = 1, TileSize = 64, GridSize = 64, Cells = 64,
            Fetch = 100000, PeakEnhancement = 3.3, Seed = 1, HeightFactor = 1,
        };

        /// <summary>Refuses values out of range.</summary>
        /// <param name="subject">Whose settings they are, for messages.</param>
        /// <exception cref="GlintException">A value is out of its range.</exception>
        public void Validate(string subject = "sea")
        {
            if (!Enum.IsDefined(typeof(SeaSpectrumKind), Kind))
                throw new GlintException($"{subject}: spectrum {(int)Kind} must be "
                    + $"{string.Join(" or ", Enum.GetNames(typeof(SeaSpectrumKind)))}");
            Check(subject, "significant wave height", SignificantWaveHeight, Heights, " m",
                "for a calm take a flat plate");
            Check(subject, "wind speed", WindSpeed, Winds, " m/s", "turn the wind by its direction, not by its sign");
            Check(subject, "wind direction", WindDirectionDegrees, Directions, " deg", "give it as a rotation about Y");
            Check(subject, "choppiness", Choppiness, Choppinesses, "",
                "0 moves nothing sideways, 1 as waves in deep water do");
            Check(subject, "tile size", TileSize, Tiles, " m", "lay several tiles side by side for a larger sea");
            double steps = TileSize / TileStep;
            if (steps != Math.Floor(steps))
                throw new GlintException($"{subject}: tile size {Text(TileSize)} m must be a multiple of 1/1024 m, "
                    + $"or neighbouring tiles would not meet: use {Text(Math.Floor(steps + 0.5) * TileStep)}");
            if (!Grids.Contains(GridSize) || (GridSize & (GridSize - 1)) != 0)
                throw new GlintException($"{subject}: grid size {GridSize} must be a power of two {Grids}: "
                    + "the mesh may have any number of cells, set that instead");
            Check(subject, "cells", Cells, CellCounts, "", "lay several tiles side by side for a larger sea");
            Check(subject, "shortest wave", ShortestWave, Interval.Closed(0, TileSize / 2), " m", "0 leaves none out");
            if (Kind == SeaSpectrumKind.Jonswap)
            {
                Check(subject, "fetch", Fetch, Fetches, " m", "100000 is usual");
                Check(subject, "peak enhancement", PeakEnhancement, PeakEnhancements, "", "3.3 is usual");
            }
            Check(subject, "height factor", HeightFactor, s_factors, "", "1 leaves the height as asked for");
        }

        static void Check(string subject, string name, double value, Interval range, string unit, string wayOut)
        {
            if (!range.Contains(value))
                throw new GlintException($"{subject}: {name} {Text(value)}{unit} must be {range}: {wayOut}");
        }

        static string Text(double value) => RadarSettings.Text(value);
    }
}
