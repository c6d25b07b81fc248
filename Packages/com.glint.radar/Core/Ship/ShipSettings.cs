using System;

namespace Glint.Core
{
    /// <summary>
    /// Parameters of the procedural ship. Lengths in metres; heights above the water, which is at y = 0.
    /// </summary>
    [Serializable]
    public struct ShipSettings
    {
        internal static readonly Interval Lengths = Interval.Closed(55, 90), Beams = Interval.Closed(11, 16),
            Freeboards = Interval.Closed(1.5, 6),
            Forecastles = Interval.Closed(0, 3), Draughts = Interval.Closed(2, 8),
            Sheers = Interval.Closed(0, 3), Rakes = Interval.Closed(0, 6),
            Flares = Interval.Closed(0, 0.8), Transoms = Interval.Closed(0.4, 1), Storeys = Interval.Closed(2, 4),
            WindowCounts = Interval.Closed(1, 15),
            WindowDepths = Interval.Closed(0.02, 0.5), MastHeights = Interval.Closed(5, 20),
            HouseFronts = Interval.Closed(0.28, 0.36), HouseAfts = Interval.Closed(0.2, 0.34),
            TriangleCounts = Interval.Closed(15000, 200000);

        /// <summary>From the stern to the tip of the bow, metres: 55 to 90.</summary>
        public double Length;

        /// <summary>Maximum width of the deck, metres: 11 to 16.</summary>
        public double Beam;

        /// <summary>Height of the deck aft of the deckhouse, metres: 1.5 to 6.</summary>
        public double Freeboard;

        /// <summary>Height of the foredeck above the quarterdeck, metres: 0 to 3.</summary>
        public double Forecastle;

        /// <summary>Depth of the keel below the water, metres: 2 to 8.</summary>
        public double Draught;

        /// <summary>Rise of the deck from the deckhouse's front to the bow, metres: 0 to 3.</summary>
        public double Sheer;

        /// <summary>Overhang of the tip of the bow over the stem at the water, metres: 0 to 6.</summary>
        public double Rake;

        /// <summary>
        /// Narrowing of the bow from the deck to the keel: 0 (as vertical as amidships) to 0.8.
        /// </summary>
        public double Flare;

        /// <summary>Width of the flat transom at the deck, as a fraction of the beam: 0.4 to 1.</summary>
        public double Transom;

        /// <summary>
        /// Distance from the middle of the ship forward to the flat front of the deckhouse, as a fraction of the
        /// length: 0.28 to 0.36. Front and deck form a dihedral: the peak bow-on.
        /// </summary>
        public double HouseFront;

        /// <summary>
        /// Distance from the middle of the ship aft to the flat end of the deckhouse, as a fraction of the length: 0.2
        /// to 0.34. End and deck form a dihedral: the peak stern-on.
        /// </summary>
        public double HouseAft;

        /// <summary>
        /// Height of each of the three storeys (deckhouse, upper house, bridge), metres: 2 to 4.
        /// </summary>
        public double StoreyHeight;

        /// <summary>Windows across the bridge's front, 1 to 15; each side has two thirds as many.</summary>
        public int Windows;

        /// <summary>
        /// Depth of the windows in the bridge's walls, metres: 0.02 to 0.5. Sill, jambs and pane of each form small
        /// corner reflectors.
        /// </summary>
        public double WindowDepth;

        /// <summary>Height of the mast's top over the bridge's roof, metres: 5 to 20.</summary>
        public double MastHeight;

        /// <summary>
        /// Triangles of the whole ship, 15,000 to 200,000, within 2 %. Most belong to the hull; more triangles make
        /// round parts rounder.
        /// </summary>
        public int Triangles;

        /// <summary>
        /// A patrol vessel with about as many rays hit as the published experiment's ship, seen from the bow, the sides
        /// and the stern.
        /// </summary>
        public static ShipSettings Default => new ShipSettings
        {
            Length = 62, Beam = 13.4, Freeboard = 2.4, Forecastle = 2.2, Draught = 5.6,
            Sheer = 1, Rake = 3.4, Flare = 0.5, Transom = 0.55,
            HouseFront = 0.355, HouseAft = 0.234, StoreyHeight = 3.5, Windows = 9,
            WindowDepth = 0.15, MastHeight = 12, Triangles = 44000,
        };

        // z of the deckhouse's front and end, metres.
        internal double HouseFrontZ => -HouseFront * Length;

        internal double HouseAftZ => HouseAft * Length;

        /// <summary>Refuses values out of range.</summary>
        /// <exception cref="GlintException">A value is out of its range.</exception>
        public void Validate()
        {
            Check("length", Length, Lengths, " m");
            Check("beam", Beam, Beams, " m");
            Check("freeboard", Freeboard, Freeboards, " m");
            Check("forecastle", Forecastle, Forecastles, " m");
            Check("draught", Draught, Draughts, " m");
            Check("sheer", Sheer, Sheers, " m");
            Check("rake", Rake, Rakes, " m");
            Check("flare", Flare, Flares);
            Check("transom", Transom, Transoms, " of the beam");
            Check("house front", HouseFront, HouseFronts, " of the length");
            Check("house aft", HouseAft, HouseAfts, " of the length");
            Check("storey height", StoreyHeight, Storeys, " m");
            Check("windows", Windows, WindowCounts);
            Check("window depth", WindowDepth, WindowDepths, " m");
            Check("mast height", MastHeight, MastHeights, " m");
            Check("triangles", Triangles, TriangleCounts);
        }

        static void Check(string name, double value, Interval range, string unit = "")
        {
            if (!range.Contains(value))
                throw new GlintException($"ship: {name} {RadarSettings.Text(value)}{unit} must be {range}{unit}");
        }
    }
}
