using System;

namespace Glint.Core
{
    /// <summary>The named parameters of the procedural ship. Lengths in metres; heights are above the water, which lies at y = 0.</summary>
    [Serializable]
    public struct ShipSettings
    {
        internal static readonly Interval Lengths = Interval.Closed(40, 100), Flares = Interval.Closed(0, 1), Transoms = Interval.Closed(0.4, 1), Storeys = Interval.Closed(2, 4),
            WindowCounts = Interval.Closed(1, 15), WindowDepths = Interval.Closed(0.02, 0.5), TriangleCounts = Interval.Closed(10000, 2000000);

        // Of the length.
        internal static readonly Interval Beams = Interval.Closed(0.12, 0.25), Freeboards = Interval.Closed(0.03, 0.1), Draughts = Interval.Closed(0.03, 0.1), Sheers = Interval.Closed(0, 0.05),
            Rakes = Interval.Closed(0, 0.1), HouseEnds = Interval.Closed(0.2, 0.34), MastHeights = Interval.Closed(0.2, 0.5);

        /// <summary>From the stern to the tip of the bow, metres: 40 to 100.</summary>
        public double Length;

        /// <summary>Greatest width of the deck, metres: 0.12 to 0.25 of the length.</summary>
        public double Beam;

        /// <summary>Height of the deck amidships, metres: 0.03 to 0.1 of the length.</summary>
        public double Freeboard;

        /// <summary>How far the keel lies below the water, metres: 0.03 to 0.1 of the length.</summary>
        public double Draught;

        /// <summary>How much higher the deck is at the bow than amidships, metres: 0 to 0.05 of the length.</summary>
        public double Sheer;

        /// <summary>How far the tip of the bow reaches out beyond the stem at the water, metres: 0 to 0.1 of the length.</summary>
        public double Rake;

        /// <summary>How much finer the bow is at the keel than at the deck: 0 (sides as upright as amidships) to 1 (most flared).</summary>
        public double Flare;

        /// <summary>Width of the flat transom at the deck over the beam: 0.4 to 1.</summary>
        public double Transom;

        /// <summary>From the middle of the ship forward to the flat front of the deckhouse, metres: 0.2 to 0.34 of the length. The front and the deck before it are a dihedral: the peak bow-on.</summary>
        public double HouseFront;

        /// <summary>From the middle of the ship aft to the flat end of the deckhouse, metres: 0.2 to 0.34 of the length. The end and the deck behind it are a dihedral: the peak stern-on.</summary>
        public double HouseAft;

        /// <summary>Height of the deckhouse over the deck, and of the bridge over the deckhouse, metres: 2 to 4.</summary>
        public double StoreyHeight;

        /// <summary>Windows across the bridge's front, 1 to 15; each side has two thirds as many.</summary>
        public int Windows;

        /// <summary>How deep the windows are set into the bridge, metres: 0.02 to 0.5. Sill, jambs and pane of each are small corner reflectors.</summary>
        public double WindowDepth;

        /// <summary>Height of the top of the mast, metres: 0.2 to 0.5 of the length.</summary>
        public double MastHeight;

        /// <summary>Triangles of the whole ship, 10,000 to 2,000,000, met within 2 %. Most are the hull's; round parts are the rounder the more there are.</summary>
        public int Triangles;

        /// <summary>A patrol vessel of 64 m that fills a radar's picture about as the published experiment's ship does.</summary>
        public static ShipSettings Default => new ShipSettings
        {
            Length = 64, Beam = 11, Freeboard = 3.2, Draught = 3.8, Sheer = 1.6, Rake = 4, Flare = 0.6, Transom = 0.75,
            HouseFront = 18.1, HouseAft = 18.1, StoreyHeight = 2.5, Windows = 9, WindowDepth = 0.15, MastHeight = 18, Triangles = 44000,
        };

        /// <summary>Refuses ships that cannot be built.</summary>
        /// <exception cref="GlintException">A value is out of its range.</exception>
        public void Validate()
        {
            Check("length", Length, Lengths, " m");
            CheckPart("beam", Beam, Beams);
            CheckPart("freeboard", Freeboard, Freeboards);
            CheckPart("draught", Draught, Draughts);
            CheckPart("sheer", Sheer, Sheers);
            CheckPart("rake", Rake, Rakes);
            Check("flare", Flare, Flares);
            Check("transom", Transom, Transoms, " of the beam");
            CheckPart("house front", HouseFront, HouseEnds);
            CheckPart("house aft", HouseAft, HouseEnds);
            Check("storey height", StoreyHeight, Storeys, " m");
            Check("windows", Windows, WindowCounts);
            Check("window depth", WindowDepth, WindowDepths, " m");
            CheckPart("mast height", MastHeight, MastHeights);
            Check("triangles", Triangles, TriangleCounts);
        }

        static void Check(string name, double value, Interval range, string unit = "")
        {
            if (!range.Contains(value))
                throw new GlintException($"ship: {name} {RadarSettings.Text(value)}{unit} must be {range}{unit}");
        }

        // A length that must suit the ship's.
        void CheckPart(string name, double value, Interval range)
        {
            if (!range.Contains(value / Length))
                throw new GlintException($"ship: {name} {RadarSettings.Text(value)} m must be {range} of the length, which is {RadarSettings.Text(Length)} m");
        }
    }
}
