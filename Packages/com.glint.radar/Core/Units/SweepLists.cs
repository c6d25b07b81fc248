namespace Glint.Core
{
    /// <summary>
    /// What the lists of a sweep hold beside <see cref="Angles"/> and <see cref="Snapshots"/>:
    /// the component and the commands read them by the same parsers.
    /// </summary>
    public static class SweepLists
    {
        /// <summary>Of each length, metres. Single precision, which the radar works in, holds both ends.</summary>
        public static readonly Interval Length = Interval.Closed(1e-6, 1e6);

        /// <summary>Of each grazing angle, degrees.</summary>
        public static readonly Interval GrazingAngle = Interval.Closed(-90, 90);

        /// <summary>Of each carrier frequency, hertz.</summary>
        public static readonly Interval Frequency =
            Interval.Closed(RadarSettings.LowestFrequencyHz, RadarSettings.HighestFrequencyHz);

        /// <summary>Grazing angles, degrees.</summary>
        public static readonly NumberList GrazingAngles =
            new NumberList("angle", GrazingAngle, "degrees", ("1:10:0.5", "1,2,5"));

        /// <summary>Distances from the radar, metres.</summary>
        public static readonly NumberList Distances =
            new NumberList("distance", Length, "metres", ("50:500:50", "50,100,500"));

        /// <summary>Carrier frequencies, hertz.</summary>
        public static readonly NumberList Frequencies =
            new NumberList("frequency", Frequency, "hertz", ("9e9:11e9:0.1e9", "9.4e9,10e9"), "frequencies");
    }
}
