using System.Collections.Generic;
using System.Globalization;

namespace Glint.Core
{
    /// <summary>
    /// A quantity that a sweep steps through. Plan, result files, tables and messages follow the table
    /// <see cref="All"/>; an option of glint sweep gives the values, and Glint.AxisDrivers applies them.
    /// </summary>
    public sealed class SweepAxis
    {
        /// <summary>Snapshot of the scene's Sea, from 1.</summary>
        public static readonly SweepAxis Snapshot = new SweepAxis(0, "snapshot", "snapshot", "1", "snapshot {0}", 8);

        /// <summary>Carrier frequency, hertz.</summary>
        public static readonly SweepAxis Frequency = new SweepAxis(1, "frequency", "frequency_hz", "Hz", "{0} Hz", 12);

        /// <summary>Distance from the radar to the point it looks at, metres.</summary>
        public static readonly SweepAxis Range = new SweepAxis(2, "range", "range_m", "m", "range {0} m", 9);

        /// <summary>Angle by which the radar looks down, degrees.</summary>
        public static readonly SweepAxis Grazing =
            new SweepAxis(3, "grazing", "grazing_deg", "deg", "grazing {0} deg", 7);

        /// <summary>Turn of the target about the world's vertical, degrees.</summary>
        public static readonly SweepAxis Angle = new SweepAxis(4, "angle", "angle_deg", "deg", "{0} deg", 7);

        readonly string _text;

        SweepAxis(int index, string name, string column, string unit, string text, int width)
        {
            Index = index;
            Name = name;
            Column = column;
            Unit = unit;
            _text = text;
            Width = width;
        }

        /// <summary>Every axis in the order of a plan: the first changes slowest, the last fastest.</summary>
        public static IReadOnlyList<SweepAxis> All { get; } = new[] { Snapshot, Frequency, Range, Grazing, Angle };

        /// <summary>Name of the axis, one word.</summary>
        public string Name { get; }

        /// <summary>Name of the column in result files.</summary>
        public string Column { get; }

        /// <summary>Unit; "1" for a plain number.</summary>
        public string Unit { get; }

        /// <summary>Index in <see cref="All"/>.</summary>
        internal int Index { get; }

        /// <summary>Characters of the column in printed tables.</summary>
        internal int Width { get; }

        /// <summary>A value in a few words: "15 deg", "snapshot 3".</summary>
        public string Describe(double value) =>
            string.Format(CultureInfo.InvariantCulture, _text, Numbers.Format(value));

        /// <summary>The name.</summary>
        public override string ToString() => Name;
    }
}
