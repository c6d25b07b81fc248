using System;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Editor
{
    /// <summary>The options of <c>glint sea</c>: settings of the sea, and its folder.</summary>
    public static class SeaOptions
    {
        const string Group = "Sea", SpectrumRange = "phillips, pierson-moskowitz, jonswap or elfouhaily";

        static readonly string[] s_spectra = { "phillips", "pierson-moskowitz", "jonswap", "elfouhaily" };

        static readonly Option[] s_measures = SeaSettings.Measures
            .Select(measure => Options.Of(measure, SeaSettings.Default, Group)).ToArray();

        static readonly Interval s_seconds = Interval.Closed(-1e6, 1e6);
        static readonly NumberList s_times = new NumberList("time", s_seconds, "seconds", ("0:45:5", "0,3.5,60"));

        /// <summary>Hs by the WMO's code.</summary>
        public static readonly Option<int> State = new Option<int>("sea-state", "N",
            text => Values.Whole(text, Interval.Closed(SeaState.Lowest, SeaState.Highest)))
        {
            Group = Group,
            Range = Interval.Closed(SeaState.Lowest, SeaState.Highest).ToString(),
            Excludes = new (Option, string)[] { (s_measures[0], "both set the wave height") },
            Help = "In place of --wave-height: the middle of the WMO's range for a sea state, such as 3.25 m for 5."
        };

        /// <summary>The wave spectrum.</summary>
        public static readonly Option<SeaSpectrumKind> Spectrum =
            new Option<SeaSpectrumKind>("spectrum", "NAME", ReadSpectrum)
            {
                Group = Group,
                Range = SpectrumRange,
                Choices = s_spectra,
                DefaultText = "elfouhaily",
                Help = "Distribution of the waves' energy over their lengths. phillips needs --wave-height or "
                    + "--sea-state, jonswap --fetch."
            };

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
        public static readonly Option[] All = new[] { Options.AssetFolder, s_measures[0], State, Spectrum }
            .Concat(s_measures.Skip(1)).Concat(new Option[] { Times, Tiles }).ToArray();

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
                    + $"your own sea needs {Options.AssetFolder.Flag} {Options.AssetFolder.ValueName}, such as "
                    + $"{Options.AssetFolder.Flag} Assets/Seas/Breeze; without any option the stored seas are made");
            object measured = SeaSettings.Default;
            for (int i = 0; i < s_measures.Length; i++)
                Options.Set(SeaSettings.Measures[i], measured, line.ValueOf(s_measures[i]));
            var settings = (SeaSettings)measured;
            settings.Kind = line.Get(Spectrum);
            if (line.IsGiven(State))
                settings.SignificantWaveHeight = SeaState.WaveHeight(line.Get(State));
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

        // In the order of SeaSpectrumKind.
        static SeaSpectrumKind ReadSpectrum(string text)
        {
            int kind = Array.IndexOf(s_spectra, text);
            return kind >= 0 ? (SeaSpectrumKind)kind : throw new FormatException($"must be {SpectrumRange}");
        }
    }
}
