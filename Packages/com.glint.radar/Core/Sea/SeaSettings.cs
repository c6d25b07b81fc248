using System;
using System.Collections.Generic;

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

        internal const double MaxFetch = 1e7;

        internal static readonly Interval Heights = Interval.Closed(0, 100), Winds = Interval.Closed(0.1, 100),
            Directions = Interval.Closed(-360, 360),
            Choppinesses = Interval.Closed(0, 10), Tiles = Interval.Closed(1, 8192),
            Grids = Interval.Closed(4, 1024), CellCounts = Interval.Closed(1, 2048),
            Fetches = Interval.Closed(0, MaxFetch), PeakEnhancements = Interval.Closed(1, 10),
            SwellPeriods = Interval.Closed(3, 30);

        static readonly Interval s_factors = Interval.Closed(0.001, 1000), s_shortest = Interval.Closed(0, 4096),
            s_seeds = Interval.Closed(0, int.MaxValue), s_jonswapFetches = Interval.Closed(100, MaxFetch);

        /// <summary>The numbers of a sea, in the order of the declaration, without the height factor.</summary>
        public static readonly IReadOnlyList<Measure> Measures = new MeasureList<SeaSettings>
        {
            { nameof(SignificantWaveHeight), it => it.SignificantWaveHeight, "Wave Height", "m", Heights,
                "Significant wave height: four standard deviations of the height, over all snapshots. 0: that of the "
                    + "wind, not with Phillips." },
            { nameof(WindSpeed), it => it.WindSpeed, "Wind", "m/s", Winds,
                "Wind speed 10 m above the sea: more wind, longer waves. Their height follows it if Wave Height is 0. "
                    + "Elfouhaily: 3 to 20." },
            { nameof(WindDirectionDegrees), it => it.WindDirectionDegrees, "Wind Direction", "deg", Directions,
                "Direction in which wind and waves travel, as a rotation about Y: 0 to +Z, 90 to +X." },
            { nameof(Choppiness), it => it.Choppiness, "Choppiness", "", Choppinesses,
                "Horizontal displacement relative to that of deep-water waves. From 1 on the crests of steep waves "
                    + "curl over." },
            { nameof(TileSize), it => it.TileSize, "Tile", "m", Tiles,
                "Side of the repeated tile: a multiple of 1/1024 m. No wave is longer." },
            { nameof(GridSize), it => it.GridSize, "Grid", "", Grids,
                "Points of the wave grid along a side, a power of two. The shortest wave is nearly twice the tile's "
                    + "size over this number." },
            { nameof(Cells), it => it.Cells, "Cells", "", CellCounts,
                "Cells of the mesh along a side of the tile, of two triangles each. They sample the sea without "
                    + "changing it." },
            { nameof(ShortestWave), it => it.ShortestWave, "Shortest Wave", "m", s_shortest,
                "Shorter waves are left out; at most half the tile. 0: all are kept." },
            { nameof(Fetch), it => it.Fetch, "Fetch", "m", Fetches,
                "Length of water that the wind has blown over. JONSWAP: 100 or more. Elfouhaily: 0 is unlimited." },
            { nameof(PeakEnhancement), it => it.PeakEnhancement, "Peak Enhancement", "", PeakEnhancements,
                "Height of the peak relative to that of a fully developed sea. JONSWAP only." },
            { nameof(SwellHeight), it => it.SwellHeight, "Swell Height", "m", Heights,
                "Significant height of a swell that is added to the waves of the wind. 0: none." },
            { nameof(SwellPeriod), it => it.SwellPeriod, "Swell Period", "s", SwellPeriods,
                "Period of the swell's highest waves: those of 10 s are 156 m long. The tile must hold them." },
            { nameof(SwellDirectionDegrees), it => it.SwellDirectionDegrees, "Swell Direction", "deg", Directions,
                "Direction in which the swell travels, as a rotation about Y: 0 to +Z, 90 to +X." },
            { nameof(Seed), it => it.Seed, "Seed", "", s_seeds,
                "Seed of the sea's random phases and heights. The same number gives the same sea." }
        };

        /// <summary>Distribution of the variance over wavelengths.</summary>
        public SeaSpectrumKind Kind;

        /// <summary>
        /// Hs in metres: four standard deviations of the height, on average over seeds. 0: that of the wind, which all
        /// spectra but Phillips have.
        /// </summary>
        public double SignificantWaveHeight;

        /// <summary>
        /// Metres a second, 10 m above the sea. It sets the shape of the spectrum, and the height if
        /// <see cref="SignificantWaveHeight"/> is 0.
        /// </summary>
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

        /// <summary>Fetch in metres. JONSWAP and Elfouhaily, for which 0 is unlimited.</summary>
        public double Fetch;

        /// <summary>Ratio of the peak to that of a fully developed sea, 1 to 10. JONSWAP only.</summary>
        public double PeakEnhancement;

        /// <summary>
        /// Significant height in metres of a swell that is added to the waves of the wind. 0: none, and the other
        /// numbers of the swell do not matter.
        /// </summary>
        public double SwellHeight;

        /// <summary>Period of the swell's spectral peak, seconds.</summary>
        public double SwellPeriod;

        /// <summary>Direction in which the swell travels, as Unity's rotation about Y.</summary>
        public double SwellDirectionDegrees;

        /// <summary>
        /// Seed of the random numbers. Finer grids of one seed, tile and wind have the same long waves.
        /// </summary>
        public int Seed;

        /// <summary>Multiplies the height: 1, or what <see cref="SeaSurface.FactorFor"/> gives a stored sea.</summary>
        public double HeightFactor;

        /// <summary>The fully developed sea of a breeze, 64 x 64 m.</summary>
        public static SeaSettings Default => new SeaSettings
        {
            Kind = SeaSpectrumKind.Elfouhaily, WindSpeed = 7,
            Choppiness = 1, TileSize = 64, GridSize = 64, Cells = 64,
            PeakEnhancement = 3.3, SwellPeriod = 10, Seed = 1, HeightFactor = 1,
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
                "use a flat plate for a calm sea");
            if (Kind == SeaSpectrumKind.Phillips && SignificantWaveHeight == 0)
                throw new GlintException($"{subject}: significant wave height 0 m, that of the wind, is not defined "
                    + "for the Phillips spectrum: give the height, or another spectrum");
            Check(subject, "wind speed", WindSpeed, Winds, " m/s",
                "it shapes the waves, also those of a requested height; turn it by its direction, not by its sign");
            Check(subject, "wind direction", WindDirectionDegrees, Directions, " deg", "give it as a rotation about Y");
            Check(subject, "choppiness", Choppiness, Choppinesses, "",
                "0 has no horizontal displacement, 1 that of deep-water waves");
            Check(subject, "tile size", TileSize, Tiles, " m", "lay several tiles side by side for a larger sea");
            double steps = TileSize / TileStep;
            if (steps != Math.Floor(steps))
                throw new GlintException($"{subject}: tile size {Text(TileSize)} m must be a multiple of 1/1024 m, "
                    + $"or neighbouring tiles would not join: use {Text(Math.Floor(steps + 0.5) * TileStep)}");
            if (!Grids.Contains(GridSize) || (GridSize & (GridSize - 1)) != 0)
                throw new GlintException($"{subject}: grid size {GridSize} must be a power of two {Grids}: "
                    + "the mesh may have any number of cells, set that instead");
            Check(subject, "cells", Cells, CellCounts, "", "lay several tiles side by side for a larger sea");
            Check(subject, "shortest wave", ShortestWave, Interval.Closed(0, TileSize / 2), " m", "0 leaves none out");
            if (Kind == SeaSpectrumKind.Jonswap)
            {
                Check(subject, "fetch", Fetch, s_jonswapFetches, " m", "100000 is usual");
                Check(subject, "peak enhancement", PeakEnhancement, PeakEnhancements, "", "3.3 is usual");
            }
            if (Kind == SeaSpectrumKind.Elfouhaily)
                Elfouhaily.Validate(subject, WindSpeed, Fetch);
            ValidateSwell(subject);
            Check(subject, "height factor", HeightFactor, s_factors, "", "1 leaves the height as asked for");
        }

        void ValidateSwell(string subject)
        {
            Check(subject, "swell height", SwellHeight, Heights, " m", "0 is a sea without swell");
            if (SwellHeight == 0)
                return;
            Check(subject, "swell period", SwellPeriod, SwellPeriods, " s", "10 is usual");
            Check(subject, "swell direction", SwellDirectionDegrees, Directions, " deg",
                "give it as a rotation about Y");
            double length = Swell.Length(SwellPeriod), shortest = TileSize / (GridSize / 2 - 1);
            shortest = ShortestWave > shortest ? ShortestWave : shortest;
            if (!(length >= shortest && length <= TileSize))
                throw new GlintException($"{subject}: swell period {Text(SwellPeriod)} s, waves of {Text(length)} m, "
                    + $"must be that of waves from {Text(shortest)} to {Text(TileSize)} m, which tile and grid hold: "
                    + "give the sea a tile that is some times longer than the swell");
        }

        static void Check(string subject, string name, double value, Interval range, string unit, string wayOut)
        {
            if (!range.Contains(value))
                throw new GlintException($"{subject}: {name} {Text(value)}{unit} must be {range}: {wayOut}");
        }

        static string Text(double value) => RadarSettings.Text(value);
    }

    /// <summary>
    /// Distribution of a sea's variance over wavelengths. Stored as numbers.
    /// </summary>
    public enum SeaSpectrumKind
    {
        /// <summary>
        /// Tessendorf's form of the Phillips spectrum (Simulating Ocean Water, 2001, eq. 40): 1/k^4,
        /// cut off above the wave whose speed is the wind's.
        /// </summary>
        Phillips,

        /// <summary>Pierson and Moskowitz 1964: a fully developed sea.</summary>
        PiersonMoskowitz,

        /// <summary>JONSWAP, Hasselmann et al. 1973: a developing sea of limited fetch, with a sharper peak.</summary>
        Jonswap,

        /// <summary>Elfouhaily et al. 1997: all waves of a wind, down to ripples.</summary>
        Elfouhaily
    }

    /// <summary>
    /// The sea states of the World Meteorological Organization (code table 3700, the Douglas scale) as
    /// significant wave heights in metres.
    /// </summary>
    public static class SeaState
    {
        /// <summary>The codes with a range of heights: 0 is calm, and 9 (above 14 m) has no upper end.</summary>
        public const int Lowest = 1, Highest = 8;

        // Range of code c: from s_ends[c - 1] to s_ends[c].
        static readonly double[] s_ends = { 0, 0.1, 0.5, 1.25, 2.5, 4, 6, 9, 14 };

        /// <summary>The middle of the code's range, metres: 3.25 m for sea state 5, 5 m for sea state 6.</summary>
        /// <exception cref="GlintException">The code is not one of 1 to 8.</exception>
        public static double WaveHeight(int code)
        {
            var (from, to) = Range(code);
            return (from + to) / 2;
        }

        /// <summary>Range of the significant wave height of the code, metres.</summary>
        /// <exception cref="GlintException">The code is not one of 1 to 8.</exception>
        public static (double From, double To) Range(int code)
        {
            if (code < Lowest || code > Highest)
                throw new GlintException($"sea state {code} must be from {Lowest} to {Highest}: "
                    + "0 has no waves and 9 no maximum height; give the significant wave height in metres instead");
            return (s_ends[code - 1], s_ends[code]);
        }
    }
}
