using System;
using System.Collections.Generic;

namespace Glint.Core
{
    /// <summary>What is at the top of a radar's picture.</summary>
    public enum PictureOrientation
    {
        /// <summary>The bow of the own ship.</summary>
        HeadUp,

        /// <summary>North.</summary>
        NorthUp
    }

    /// <summary>How a radar's picture is drawn.</summary>
    [Serializable]
    public struct ScreenDisplay
    {
        /// <summary>The numbers, in the order of the declaration.</summary>
        public static readonly IReadOnlyList<Measure> Measures = new MeasureList<ScreenDisplay>
        {
            { nameof(Side), it => it.Side, "Side", "pixels", Interval.Closed(64, 4096),
                "Pixels along a side of the picture. Used when the component is enabled." },
            { nameof(RangeRings), it => it.RangeRings, "Range Rings", "", Interval.Closed(0, 20),
                "Rings of equal distance; the last one is the edge. 0: none." },
            { nameof(BearingLine), it => it.BearingLine, "Bearing Line", "deg", Interval.Closed(-360, 360),
                "True bearing of the electronic bearing line, clockwise from north." },
            { nameof(RangeMarker), it => it.RangeMarker, "Range Marker", "m", Interval.Closed(0, 1e6),
                "Radius of the variable range marker. 0: none." }
        };

        /// <summary>Head-up or north-up.</summary>
        public PictureOrientation Orientation;

        /// <summary>Pixels along a side.</summary>
        public int Side;

        /// <summary>Number of range rings.</summary>
        public int RangeRings;

        /// <summary>Whether the heading line is drawn.</summary>
        public bool HasHeadingLine;

        /// <summary>Whether the electronic bearing line is drawn.</summary>
        public bool HasBearingLine;

        /// <summary>True bearing of that line, degrees.</summary>
        public double BearingLine;

        /// <summary>Radius of the variable range marker in metres; 0: none.</summary>
        public double RangeMarker;

        /// <summary>North-up with six rings and the heading line.</summary>
        public static ScreenDisplay Default => new ScreenDisplay
        {
            Orientation = PictureOrientation.NorthUp, Side = 1024, RangeRings = 6, HasHeadingLine = true
        };

        /// <inheritdoc cref="ScreenRadar.Validate"/>
        public void Validate(string subject)
        {
            foreach (var measure in Measures)
                Require.Within(subject, measure, this);
        }
    }
}
