using System;
using System.Collections.Generic;
using System.Globalization;

namespace Glint.Core
{
    /// <summary>
    /// One thing that a sweep steps through. This table holds the column, the option, the labels and the parser of
    /// each axis; Glint.AxisDrivers holds what moves it, and the Sweep component a field for its list.
    /// </summary>
    public sealed class SweepAxis
    {
        /// <summary>Turn of the target about the world's vertical, degrees.</summary>
        public static readonly SweepAxis Angle = new SweepAxis("angle", "angles", "angle_deg", "deg")
        {
            Title = "Angle", Text = "{0} {1}", NeedsTarget = true, OptionName = "angles", ValueName = "ANGLES",
            // Unity has single-precision angles: more than one turn only costs digits.
            List = new NumberList("angle", Interval.Closed(-360, 360), "degrees", ("0:45:1", "0,10,45")),
            Help = "Turn angles in degrees, positive as Unity's rotation about Y: FROM:TO:STEP, all three, "
                + "or a list with commas. FROM is included, and TO when whole steps reach it: 0:45:2 ends at 44."
        };

        /// <summary>Snapshot of the scene's Sea, from 1.</summary>
        public static readonly SweepAxis Snapshot = new SweepAxis("snapshot", "snapshots", "snapshot", "1")
        {
            Title = "Snapshot", Text = "snapshot {0}", Width = 8, NeedsSea = true, OptionName = "snapshots",
            List = new NumberList("snapshot", Interval.Closed(1, 1000000), "", ("1:10", "1,4,9")) { IsWhole = true },
            Help = "Snapshots of the scene's Sea, counted from 1: FROM:TO, both included, FROM:TO:STEP, "
                + "or a list with commas."
        };

        /// <summary>Angle by which the radar looks down, degrees.</summary>
        public static readonly SweepAxis Grazing = new SweepAxis("grazing", "grazing angles", "grazing_deg", "deg")
        {
            Title = "Grazing angle", Text = "grazing {0} {1}", NeedsTarget = true, OptionName = "grazing",
            List = new NumberList("angle", Interval.Closed(-90, 90), "degrees", ("1:10:0.5", "1,2,5")),
            Help = "Grazing angles in degrees, how far the radar looks down, as a range or list like --angles. "
                + "It moves about the point that it looks at: for a mesh file that of --aim, "
                + "10 degrees without the option; in a scene the point of its view axis nearest to the target."
        };

        /// <summary>Distance from the radar to the point it looks at, metres.</summary>
        public static readonly SweepAxis Range = new SweepAxis("range", "distances", "range_m", "m")
        {
            Title = "Range", Text = "range {0} {1}", Width = 9, NeedsTarget = true, OptionName = "distance",
            // Lengths go into single precision, which holds both ends.
            List = new NumberList("distance", Interval.Closed(1e-6, 1e6), "metres", ("50:500:50", "50,100,500")),
            Help = "Distances from the radar to the same point in metres, as a range or list. "
                + "For a mesh file 50 without the option."
        };

        /// <summary>Carrier frequency, hertz.</summary>
        public static readonly SweepAxis Frequency =
            new SweepAxis("frequency", "frequencies", "frequency_hz", "Hz")
            {
                Title = "Frequency", Text = "{0} {1}", Width = 12, ShownUnit = "GHz", ShownScale = 1e9,
                OptionName = "frequency",
                List = new NumberList("frequency",
                    Interval.Closed(RadarSettings.LowestFrequencyHz, RadarSettings.HighestFrequencyHz), "hertz",
                    ("9e9:11e9:0.1e9", "9.4e9,10e9"), "frequencies"),
                Help = "Carrier frequencies in hertz, as a range or list. Without the option that of the scene, "
                    + "or 10e9 for a mesh file."
            };

        SweepAxis(string name, string plural, string column, string unit) =>
            (Name, Plural, Column, Unit, ShownUnit) = (name, plural, column, unit, unit);

        /// <summary>Every axis in the order of a plan: the first changes slowest, the last fastest.</summary>
        public static IReadOnlyList<SweepAxis> All { get; } = new[] { Snapshot, Frequency, Range, Grazing, Angle };

        /// <summary>Every axis in the order of the columns of result files; a new one comes last.</summary>
        internal static IReadOnlyList<SweepAxis> Columns { get; } =
            new[] { Angle, Snapshot, Grazing, Range, Frequency };

        /// <summary>Name of the axis, one word.</summary>
        public string Name { get; }

        /// <summary>Several values: "grazing angles".</summary>
        public string Plural { get; }

        /// <summary>Name of the column in result files.</summary>
        public string Column { get; }

        /// <summary>Unit; "1" for a plain number.</summary>
        public string Unit { get; }

        /// <summary>For headings and charts.</summary>
        public string Title { get; private set; }

        /// <summary>Unit of the axis in charts, and how many of <see cref="Unit"/> it is.</summary>
        public string ShownUnit { get; private set; }

        /// <inheritdoc cref="ShownUnit"/>
        public double ShownScale { get; private set; } = 1;

        /// <summary>A value in a few words; {0} is the value, {1} its unit.</summary>
        public string Text { get; private set; }

        /// <summary>Characters of the column in printed tables.</summary>
        public int Width { get; private set; } = 7;

        /// <summary>The option of glint sweep, without dashes, and the placeholder of its value in the help.</summary>
        public string OptionName { get; private set; }

        /// <inheritdoc cref="OptionName"/>
        public string ValueName { get; private set; } = "LIST";

        /// <summary>Explanation of the option.</summary>
        public string Help { get; private set; }

        /// <summary>Whether a scene must have a target that is turned or that the radar is moved about.</summary>
        public bool NeedsTarget { get; private set; }

        /// <summary>Whether a scene must have a Sea.</summary>
        public bool NeedsSea { get; private set; }

        /// <summary>Reads the values.</summary>
        public NumberList List { get; private set; }

        /// <summary>Index in <see cref="All"/>.</summary>
        public int Index => ((IList<SweepAxis>)All).IndexOf(this);

        /// <summary>For the field of its list: "Grazing angles, deg".</summary>
        public string ListLabel =>
            char.ToUpperInvariant(Plural[0]) + Plural.Substring(1) + (Unit == "1" ? "" : ", " + Unit);

        /// <summary>The values that a text names: FROM:TO:STEP or a list with commas.</summary>
        /// <exception cref="UsageException">Malformed, empty, out of range or too many.</exception>
        public double[] Parse(string text)
        {
            try
            {
                return List.Read(text);
            }
            catch (FormatException error)
            {
                throw new UsageException($"{Plural} {Values.Shown(text)}: {error.Message}");
            }
        }

        /// <summary>A value in a few words: "15 deg", "snapshot 3".</summary>
        public string Describe(double value) =>
            string.Format(CultureInfo.InvariantCulture, Text, Numbers.Format(value), Unit);

        /// <summary>The name.</summary>
        public override string ToString() => Name;
    }
}
