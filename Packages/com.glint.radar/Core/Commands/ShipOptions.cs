using System.Linq;

namespace Glint.Core
{
    /// <summary>The options of <c>glint ship</c>: measures of the ship, and its folder.</summary>
    public static class ShipOptions
    {
        const string Group = "Ship";

        static readonly ShipSettings s_standard = ShipSettings.Default;

        /// <summary>Length from the stern to the tip of the bow in metres.</summary>
        public static readonly Option<double> Length = Number("length", "M", s_standard.Length, ShipSettings.Lengths,
            "Length from the stern to the tip of the bow in metres.");

        /// <summary>Maximum width of the deck in metres.</summary>
        public static readonly Option<double> Beam =
            Number("beam", "M", s_standard.Beam, ShipSettings.Beams, "Greatest width of the deck in metres.");

        /// <summary>Height above the water of the deck aft of the deckhouse, in metres.</summary>
        public static readonly Option<double> Freeboard = Number("freeboard", "M", s_standard.Freeboard,
            ShipSettings.Freeboards, "Height over the water of the deck aft of the deckhouse, in metres.");

        /// <summary>Height of the foredeck above the quarterdeck, in metres.</summary>
        public static readonly Option<double> Forecastle = Number("forecastle", "M", s_standard.Forecastle,
            ShipSettings.Forecastles, "How much higher the deck lies before the deckhouse than aft of it, in metres.");

        /// <summary>Depth of the keel below the water, in metres.</summary>
        public static readonly Option<double> Draught = Number("draught", "M", s_standard.Draught,
            ShipSettings.Draughts, "How far the keel lies below the water, in metres.");

        /// <summary>Rise of the deck from the deckhouse's front to the bow, in metres.</summary>
        public static readonly Option<double> Sheer = Number("sheer", "M", s_standard.Sheer, ShipSettings.Sheers,
            "How much the deck rises from before the deckhouse to the bow, in metres.");

        /// <summary>Overhang of the tip of the bow over the stem at the water, in metres.</summary>
        public static readonly Option<double> Rake = Number("rake", "M", s_standard.Rake, ShipSettings.Rakes,
            "How far the tip of the bow reaches out over the stem at the water, in metres.");

        /// <summary>Narrowing of the bow from the deck to the keel: 0 is as vertical as amidships.</summary>
        public static readonly Option<double> Flare = Number("flare", "X", s_standard.Flare, ShipSettings.Flares,
            "How much finer the bow is at the keel than at the deck: 0 is as upright as amidships.");

        /// <summary>Width of the flat transom at the deck, as a fraction of the beam.</summary>
        public static readonly Option<double> Transom = Number("transom", "X", s_standard.Transom,
            ShipSettings.Transoms, "Width of the flat transom at the deck over the beam.");

        /// <summary>
        /// Distance from amidships forward to the deckhouse's flat front, as a fraction of the length.
        /// </summary>
        public static readonly Option<double> HouseFront =
            Number("house-front", "X", s_standard.HouseFront, ShipSettings.HouseFronts,
                "From the middle of the ship forward to the flat front of the deckhouse, of the length.");

        /// <summary>Distance from amidships aft to the deckhouse's flat end, as a fraction of the length.</summary>
        public static readonly Option<double> HouseAft = Number("house-aft", "X", s_standard.HouseAft,
            ShipSettings.HouseAfts, "From the middle of the ship aft to the flat end of the deckhouse, of the length.");

        /// <summary>Height of each of the three storeys, deckhouse, upper house and bridge, in metres.</summary>
        public static readonly Option<double> StoreyHeight = Number("storey-height", "M", s_standard.StoreyHeight,
            ShipSettings.Storeys, "Height of each of the three storeys, deckhouse, upper house and bridge, in metres.");

        /// <summary>Windows across the front of the bridge.</summary>
        public static readonly Option<int> Windows = Whole("windows", "N", s_standard.Windows,
            ShipSettings.WindowCounts, "Windows across the front of the bridge.");

        /// <summary>Depth of the windows in metres; their corners return rays to the radar.</summary>
        public static readonly Option<double> WindowDepth = Number("window-depth", "M", s_standard.WindowDepth,
            ShipSettings.WindowDepths, "How deep the windows are set in, in metres: the corners return to the radar.");

        /// <summary>Height of the mast's top above the bridge's roof, in metres.</summary>
        public static readonly Option<double> MastHeight = Number("mast-height", "M", s_standard.MastHeight,
            ShipSettings.MastHeights, "Height of the mast's top over the roof of the bridge, in metres.");

        /// <summary>Approximate number of triangles.</summary>
        public static readonly Option<int> Triangles = Whole("triangles", "N", s_standard.Triangles,
            ShipSettings.TriangleCounts, "About as many triangles has the ship.");

        /// <summary>All options, in the order of the help.</summary>
        public static readonly Option[] All =
        {
            Options.AssetFolder, Length, Beam, Freeboard, Forecastle, Draught, Sheer, Rake, Flare, Transom, HouseFront,
            HouseAft, StoreyHeight, Windows, WindowDepth, MastHeight, Triangles
        };

        /// <summary>
        /// The ship of a command line; null without options, which means the stored ship.
        /// </summary>
        /// <exception cref="UsageException">There is no folder for the files.</exception>
        public static ShipSettings? Read(CommandLine line)
        {
            if (!All.Any(line.IsGiven))
                return null;
            if (!line.IsGiven(Options.AssetFolder))
                throw new UsageException($"{Options.AssetFolder.Flag} is missing: "
                    + $"a ship of your own needs {Options.AssetFolder.Flag} {Options.AssetFolder.ValueName}, "
                    + $"such as {Options.AssetFolder.Flag} Assets/Ships; without any option the stored ship is made");
            return new ShipSettings
            {
                Length = line.Get(Length),
                Beam = line.Get(Beam),
                Freeboard = line.Get(Freeboard),
                Forecastle = line.Get(Forecastle),
                Draught = line.Get(Draught),
                Sheer = line.Get(Sheer),
                Rake = line.Get(Rake),
                Flare = line.Get(Flare),
                Transom = line.Get(Transom),
                HouseFront = line.Get(HouseFront),
                HouseAft = line.Get(HouseAft),
                StoreyHeight = line.Get(StoreyHeight),
                Windows = line.Get(Windows),
                WindowDepth = line.Get(WindowDepth),
                MastHeight = line.Get(MastHeight),
                Triangles = line.Get(Triangles),
            };
        }

        static Option<double> Number(string name, string valueName, double standard, Interval range, string help) =>
            Options.Number(name, valueName, Numbers.Format(standard), range, Group, InputKind.Any, help);

        static Option<int> Whole(string name, string valueName, int standard, Interval range, string help) =>
            Options.Whole(name, valueName, Numbers.Format(standard), range, Group, help);
    }
}
