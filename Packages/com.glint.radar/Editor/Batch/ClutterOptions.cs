using Glint.Core;
using Unity.Mathematics;

namespace Glint.Editor
{
    /// <summary>The options of <c>glint clutter</c>.</summary>
    public static class ClutterOptions
    {
        const string Group = "Sea clutter";

        static readonly Interval s_grazing = Interval.Closed(0.1, 90), s_cells = Interval.Closed(0.5, 10000),
            s_seconds = Interval.Closed(-1e6, 1e6);

        /// <summary>Grazing angles, degrees.</summary>
        public static readonly Option<double[]> Grazing = Options.List("grazing",
            new NumberList("grazing angle", s_grazing, "degrees", ("1:10:1", "1,3,10")),
            "1,2,3,5,7,10,15,20,30,45,60,70", Group,
            "Grazing angles in degrees, from the horizontal: FROM:TO:STEP or a list with commas. Without it, with the "
                + "level of a published model: those at which the model holds.");

        /// <summary>Azimuths of the radar, degrees.</summary>
        public static readonly Option<double[]> Azimuth = Options.List("azimuth", CrossSectionRanges.Azimuths, "0",
            Group, "Azimuths of the radar in degrees, positive as Unity's rotation about Y, as a range or list. At 0 "
                + "it looks north, along +Z; at 90 east, along +X.");

        /// <summary>Frequencies, hertz.</summary>
        public static readonly Option<double[]> Frequency = Options.List("frequency",
            new NumberList("frequency", SeaScattering.Frequencies, "hertz", ("9e9:11e9:0.1e9", "9.4e9,10e9"),
                "frequencies"), "10e9", Group, "Frequencies in hertz, as a range or list.");

        /// <summary>Times of a sea without snapshots, seconds; null when not given.</summary>
        public static readonly Option<double[]> Times = new Option<double[]>("times", "LIST",
            new NumberList("time", s_seconds, "seconds", ("0:45:5", "0,3.5,60")).Read)
        {
            Group = Group,
            Range = "each " + s_seconds,
            Excludes = new (Option, string)[] { (Options.Snapshots, "snapshots have times of their own") },
            Help = "Times in seconds of a sea that has no snapshots, as a range or list. Without it: its own."
        };

        /// <summary>Size of a cell, metres, along the direction of the radar and across.</summary>
        public static readonly Option<double2> Cell = new Option<double2>("cell", "RxA",
            text => Values.Area(text, s_cells))
        {
            Group = Group,
            Range = "each " + s_cells,
            DefaultText = "15x30",
            Help = "Cells in which the texture is measured, in metres along the direction of the radar and across, or "
                + "the side of square ones. The shape is the squared mean of their echoes without speckle over the "
                + "variance."
        };

        /// <summary>Folder for the result files; null when not given.</summary>
        public static readonly Option<string> Out = Options.Text("out", "DIR", "Results",
            "Folder for clutter.csv and results.json, created with its parents if missing.");

        /// <summary>All options, in the order of the help.</summary>
        public static readonly Option[] All =
            { Grazing, Azimuth, Frequency, Options.Snapshots, Times, Cell, Options.Clutter, Out, Options.Device };
    }
}
