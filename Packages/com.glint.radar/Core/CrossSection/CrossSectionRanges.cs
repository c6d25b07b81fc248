namespace Glint.Core
{
    /// <summary>What the settings of a cross section may be, for options and fields.</summary>
    public static class CrossSectionRanges
    {
        /// <summary>A direction about the vertical, degrees.</summary>
        public static readonly Interval Azimuth = Interval.Closed(-360, 360);

        /// <summary>A direction above the horizontal, degrees.</summary>
        public static readonly Interval Elevation = Interval.Closed(-90, 90);

        /// <summary>The error asked for, decibels.</summary>
        public static readonly Interval Tolerance = Interval.Closed(0.001, 10);

        /// <summary>A cross section, dBsm.</summary>
        public static readonly Interval Level = Interval.Closed(-200, 200);

        /// <summary>Bend of an edge, degrees.</summary>
        public static readonly Interval Crease = Interval.Closed(0, 90);

        /// <summary>Reads azimuths.</summary>
        public static readonly NumberList Azimuths =
            new NumberList("azimuth", Azimuth, "degrees", ("0:359.5:0.5", "0,30,90"));

        /// <summary>Reads elevations.</summary>
        public static readonly NumberList Elevations =
            new NumberList("elevation", Elevation, "degrees", ("0:10:1", "0,5,10"));
    }
}
