using System;
using System.Collections.Generic;

namespace Glint.Core
{
    /// <summary>
    /// Parameters of the procedural ship. Lengths in metres; heights above the water, which is at y = 0.
    /// </summary>
    [Serializable]
    public struct ShipSettings
    {
        /// <summary>Every field, in the order of the declaration.</summary>
        public static readonly IReadOnlyList<Measure> Measures = new MeasureList<ShipSettings>
        {
            { nameof(Length), it => it.Length, "Length", "m", 55, 140, "Length from the stern to the tip of the bow." },
            { nameof(Beam), it => it.Beam, "Beam", "m", 11, 20, "Maximum width of the deck." },
            { nameof(Freeboard), it => it.Freeboard, "Freeboard", "m", 1.5, 6,
                "Height above the water of the deck aft of the deckhouse." },
            { nameof(Forecastle), it => it.Forecastle, "Forecastle", "m", 0, 3,
                "Height of the deck before the deckhouse above the deck aft of it." },
            { nameof(Draught), it => it.Draught, "Draught", "m", 2, 8, "Depth of the keel below the water." },
            { nameof(Sheer), it => it.Sheer, "Sheer", "m", 0, 3, "Rise of the deck from the deckhouse to the bow." },
            { nameof(Rake), it => it.Rake, "Rake", "m", 0, 6,
                "Overhang of the bow's tip beyond the stem at the water." },
            { nameof(Flare), it => it.Flare, "Flare", "", 0, 0.8,
                "Flare of the bow between keel and deck: 0 is as upright as amidships." },
            { nameof(Transom), it => it.Transom, "Transom", "of the beam", 0.4, 1,
                "Width of the flat transom at the deck." },
            { nameof(HouseFront), it => it.HouseFront, "House Front", "of the length", 0.28, 0.36,
                "Distance from midships forward to the flat front of the deckhouse. With the deck before it it is a "
                    + "dihedral: the bow-on peak." },
            { nameof(HouseAft), it => it.HouseAft, "House Aft", "of the length", 0.2, 0.34,
                "Distance from midships aft to the flat end of the deckhouse. With the deck behind it it is a "
                    + "dihedral: the stern-on peak." },
            { nameof(StoreyHeight), it => it.StoreyHeight, "Storey Height", "m", 2, 4,
                "Height of each of the three storeys: deckhouse, upper house and bridge." },
            { nameof(Windows), it => it.Windows, "Windows", "", 1, 15,
                "Windows across the bridge's front; each side has two thirds as many." },
            { nameof(WindowDepth), it => it.WindowDepth, "Window Depth", "m", 0.02, 0.5,
                "Depth of the windows in the bridge. Sill, jambs and pane are small corner reflectors." },
            { nameof(MastHeight), it => it.MastHeight, "Mast Height", "m", 5, 20,
                "Height of the mast's top over the bridge's roof." },
            { nameof(Triangles), it => it.Triangles, "Triangles", "", 15000, 600000,
                "Triangles of the whole ship, within 2 %." }
        };

        /// <summary>Length from the stern to the tip of the bow, metres: 55 to 140.</summary>
        public double Length;

        /// <summary>Maximum width of the deck, metres: 11 to 20.</summary>
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
        /// Triangles of the whole ship, 15,000 to 600,000, within 2 %. Most belong to the hull; more triangles make
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
            foreach (var measure in Measures)
                if (!measure.Range.Contains(measure.Of(this)))
                {
                    string unit = measure.Unit.Length == 0 ? "" : " " + measure.Unit;
                    throw new GlintException($"ship: {measure.Title.ToLowerInvariant()} "
                        + $"{RadarSettings.Text(measure.Of(this))}{unit} must be {measure.Range}{unit}");
                }
        }
    }
}
