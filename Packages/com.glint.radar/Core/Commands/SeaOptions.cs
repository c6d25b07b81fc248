using System;
using System.Linq;
using Unity.Mathematics;

namespace Glint.Core
{
    /// <summary>The options of <c>glint sea</c>: settings of the sea, and its folder.</summary>
    public static class SeaOptions
    {
        const string Group = "Sea";

        static readonly SeaSettings s_standard = SeaSettings.Default;
        static readonly Interval s_seconds = Interval.Closed(-1e6, 1e6);
        static readonly NumberList s_times = new NumberList("time", s_seconds, "seconds", ("0:45:5", "0,3.5,60"));

        /// <summary>Hs in metres.</summary>
        public static readonly Option<double> WaveHeight =
            Number("wave-height", "M", s_standard.SignificantWaveHeight, SeaSettings.Heights, "Significant wave height "
                + "in metres, which the snapshots have together: 4 times the standard deviation of the heights.");

        /// <summary>Hs by the WMO's code.</summary>
        public static readonly Option<int> State = new Option<int>("sea-state", "N",
            text => Values.Whole(text, Interval.Closed(SeaState.Lowest, SeaState.Highest)))
        {
            Group = Group,
            Range = Interval.Closed(SeaState.Lowest, SeaState.Highest).ToString(),
            Excludes = new (Option, string)[] { (WaveHeight, "both say how high the waves are") },
            Help = "In place of --wave-height: the middle of the WMO's range for a sea state, such as 3.25 m for 5."
        };

        /// <summary>The wave spectrum.</summary>
        public static readonly Option<SeaSpectrumKind> Spectrum =
            new Option<SeaSpectrumKind>("spectrum", "NAME", ReadSpectrum)
            {
                Group = Group,
                Range = "phillips, pierson-moskowitz or jonswap",
                Choices = new[] { "phillips", "pierson-moskowitz", "jonswap" },
                DefaultText = "phillips",
                Help = "How the waves' energy is spread over their lengths; how high they are is --wave-height's."
            };

        /// <summary>Wind, metres per second.</summary>
        public static readonly Option<double> Wind = Number("wind", "M/S", s_standard.WindSpeed, SeaSettings.Winds,
            "Wind speed in metres a second, 10 m up: more wind, longer waves.");

        /// <summary>Direction in which the waves travel, degrees.</summary>
        public static readonly Option<double> WindDirection =
            Number("wind-direction", "DEG", s_standard.WindDirectionDegrees, SeaSettings.Directions,
                "Where wind and waves go, in degrees as Unity's rotation about Y: 0 to +Z, 90 to +X.");

        /// <summary>Horizontal displacement.</summary>
        public static readonly Option<double> Choppiness = Number("choppiness", "X", s_standard.Choppiness,
            SeaSettings.Choppinesses, "How far points move sideways towards the crests: 0 not at all, "
                + "1 as in deep water; crests of steep waves curl over from there on.");

        /// <summary>Side of the tile, metres.</summary>
        public static readonly Option<double> Tile = Number("tile", "M", s_standard.TileSize, SeaSettings.Tiles,
            "Side of the periodic tile in metres; no wave is longer.");

        /// <summary>Waves of each axis.</summary>
        public static readonly Option<int> Grid = Whole("grid", "N", s_standard.GridSize, SeaSettings.Grids,
            "Points of the wave grid along a side, a power of two: waves down to 2 tile sides / N are there.");

        /// <summary>Cells of the mesh.</summary>
        public static readonly Option<int> Cells = Whole("cells", "N", s_standard.Cells, SeaSettings.CellCounts,
            "Cells of the mesh along a side of the tile, two triangles each.");

        /// <summary>Shortest wave, metres.</summary>
        public static readonly Option<double> ShortestWave =
            Number("shortest-wave", "M", s_standard.ShortestWave, Interval.Closed(0, 4096),
                "Waves shorter than this, in metres, are left out; at most half the tile. 0: none are.");

        /// <summary>Fetch, metres.</summary>
        public static readonly Option<double> Fetch = Number("fetch", "M", s_standard.Fetch, SeaSettings.Fetches,
            "Metres of water that the wind has blown over; jonswap only.");

        /// <summary>Peak enhancement of JONSWAP.</summary>
        public static readonly Option<double> PeakEnhancement =
            Number("peak-enhancement", "X", s_standard.PeakEnhancement, SeaSettings.PeakEnhancements,
                "How much higher the spectrum's peak is than that of a fully risen sea; jonswap only.");

        /// <summary>Seed of the random numbers.</summary>
        public static readonly Option<int> Seed = Whole("seed", "N", s_standard.Seed, Interval.Closed(0, int.MaxValue),
            "Which sea it is: the same number, the same waves.");

        /// <summary>Times of the snapshots, seconds.</summary>
        public static readonly Option<double[]> Times = new Option<double[]>("times", "TIMES", s_times.Read)
        {
            Group = Group,
            Range = "each " + s_seconds,
            DefaultText = "0",
            Help = "Moments of the snapshots in seconds: FROM:TO:STEP, TO included when whole steps reach it, "
                + "or a list with commas."
        };

        /// <summary>Tiles of each prefab.</summary>
        public static readonly Option<int2> Tiles =
            new Option<int2>("tiles", "WxD", text => Values.Size(text, Interval.Closed(1, 100)))
            {
                Group = Group,
                Range = "each " + Interval.Closed(1, 100),
                DefaultText = "1x1",
                Help = "Tiles along X and along Z of each prefab, about its origin. All show one mesh."
            };

        /// <summary>All options, in the order of the help.</summary>
        public static readonly Option[] All =
        {
            Options.AssetFolder, WaveHeight, State, Spectrum, Wind, WindDirection, Choppiness, Tile, Grid, Cells,
            ShortestWave, Fetch, PeakEnhancement, Seed, Times, Tiles
        };

        /// <summary>
        /// The sea of a command line; null without options, which means the stored seas.
        /// </summary>
        /// <exception cref="UsageException">
        /// A value is out of its range, or there is no folder for the files.
        /// </exception>
        public static SeaRecipe Read(CommandLine line)
        {
            if (!All.Any(line.IsGiven))
                return null;
            if (!line.IsGiven(Options.AssetFolder))
                throw new UsageException($"{Options.AssetFolder.Flag} is missing: "
                    + $"a sea of your own needs {Options.AssetFolder.Flag} {Options.AssetFolder.ValueName}, such as "
                    + $"{Options.AssetFolder.Flag} Assets/Seas/Breeze; without any option the stored seas are made");
            var settings = new SeaSettings
            {
                Kind = line.Get(Spectrum),
                SignificantWaveHeight =
                    line.IsGiven(State) ? SeaState.WaveHeight(line.Get(State)) : line.Get(WaveHeight),
                WindSpeed = line.Get(Wind),
                WindDirectionDegrees = line.Get(WindDirection),
                Choppiness = line.Get(Choppiness),
                TileSize = line.Get(Tile),
                GridSize = line.Get(Grid),
                Cells = line.Get(Cells),
                ShortestWave = line.Get(ShortestWave),
                Fetch = line.Get(Fetch),
                PeakEnhancement = line.Get(PeakEnhancement),
                Seed = line.Get(Seed),
                HeightFactor = 1,
            };
            try
            {
                settings.Validate();
                return new SeaRecipe("sea", settings, line.Get(Times), line.Get(Tiles));
            }
            catch (GlintException problem) when (!(problem is UsageException))
            {
                throw new UsageException(problem.Message);
            }
        }

        static SeaSpectrumKind ReadSpectrum(string text)
        {
            switch (text)
            {
                case "phillips": return SeaSpectrumKind.Phillips;
                case "pierson-moskowitz": return SeaSpectrumKind.PiersonMoskowitz;
                case "jonswap": return SeaSpectrumKind.Jonswap;
                default: throw new FormatException("must be phillips, pierson-moskowitz or jonswap");
            }
        }

        static Option<double> Number(string name, string valueName, double standard, Interval range, string help) =>
            Options.Number(name, valueName, Numbers.Format(standard), range, Group, InputKind.Any, help);

        static Option<int> Whole(string name, string valueName, int standard, Interval range, string help) =>
            Options.Whole(name, valueName, Numbers.Format(standard), range, Group, help);
    }
}
