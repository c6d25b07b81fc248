using System;
using System.Linq;
using Glint.Core;

namespace Glint.Editor
{
    /// <summary>The options of <c>glint ship</c>: measures of the ship, and its folder or file.</summary>
    public static class ShipOptions
    {
        static readonly Option[] s_measures = ShipSettings.Measures
            .Select(measure => Options.Of(measure, ShipSettings.Default, "Ship")).ToArray();

        /// <summary>File of the mesh, in place of assets of the project; null when not given.</summary>
        public static readonly Option<string> Stl = new Option<string>("stl", "FILE", ReadStl)
        {
            Group = Options.AssetFolder.Group,
            Excludes = new (Option, string)[] { (Options.AssetFolder, "the ship goes to one or the other") },
            Help = "Instead of mesh and prefab: a binary STL file of the mesh, in metres with y up, for glint rcs and "
                + "other programs. It takes 50 bytes a triangle."
        };

        // Other programs go by the name.
        static string ReadStl(string text) => text.EndsWith(".stl", StringComparison.OrdinalIgnoreCase) ? text
            : throw new FormatException("the name of an STL file must end with .stl");

        /// <summary>All options, in the order of the help.</summary>
        public static readonly Option[] All = s_measures.Prepend(Stl).Prepend(Options.AssetFolder).ToArray();

        /// <summary>
        /// The ship of a command line; null without options, which means the stored ship.
        /// </summary>
        /// <exception cref="UsageException">The folder or file is missing.</exception>
        public static ShipSettings? Read(CommandLine line)
        {
            if (!All.Any(line.IsGiven))
                return null;
            if (!line.IsGiven(Options.AssetFolder) && !line.IsGiven(Stl))
                throw new UsageException($"{Options.AssetFolder.Flag} is missing: "
                    + $"your own ship needs {Options.AssetFolder.Flag} {Options.AssetFolder.ValueName}, "
                    + $"such as {Options.AssetFolder.Flag} Assets/Ships, or {Stl.Flag} {Stl.ValueName}; "
                    + "without any option the stored ship is made");
            object settings = ShipSettings.Default;
            for (int i = 0; i < s_measures.Length; i++)
                Options.Set(ShipSettings.Measures[i], settings, line.ValueOf(s_measures[i]));
            return (ShipSettings)settings;
        }
    }
}
