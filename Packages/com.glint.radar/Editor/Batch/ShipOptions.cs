using System.Linq;
using Glint.Core;

namespace Glint.Editor
{
    /// <summary>The options of <c>glint ship</c>: measures of the ship, and its folder.</summary>
    public static class ShipOptions
    {
        static readonly Option[] s_measures = ShipSettings.Measures
            .Select(measure => Options.Of(measure, ShipSettings.Default, "Ship")).ToArray();

        /// <summary>All options, in the order of the help.</summary>
        public static readonly Option[] All = s_measures.Prepend(Options.AssetFolder).ToArray();

        /// <summary>
        /// The ship of a command line; null without options, which means the stored ship.
        /// </summary>
        /// <exception cref="UsageException">The folder for the files is missing.</exception>
        public static ShipSettings? Read(CommandLine line)
        {
            if (!All.Any(line.IsGiven))
                return null;
            if (!line.IsGiven(Options.AssetFolder))
                throw new UsageException($"{Options.AssetFolder.Flag} is missing: "
                    + $"your own ship needs {Options.AssetFolder.Flag} {Options.AssetFolder.ValueName}, "
                    + $"such as {Options.AssetFolder.Flag} Assets/Ships; without any option the stored ship is made");
            object settings = ShipSettings.Default;
            for (int i = 0; i < s_measures.Length; i++)
                Options.Set(ShipSettings.Measures[i], settings, line.ValueOf(s_measures[i]));
            return (ShipSettings)settings;
        }
    }
}
