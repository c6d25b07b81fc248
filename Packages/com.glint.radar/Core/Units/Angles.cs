using System;

namespace Glint.Core
{
    /// <summary>The angles of a sweep, degrees, written FROM:TO:STEP or as a list with commas.</summary>
    public static class Angles
    {
        /// <summary>Most angles of one sweep.</summary>
        public const int Limit = NumberList.Limit;

        // Unity turns objects by single-precision angles: another turn only costs digits.
        static readonly NumberList s_list =
            new NumberList("angle", Interval.Closed(-360, 360), "degrees", ("0:45:1", "0,10,45"));

        /// <summary>
        /// The angles in the order written. FROM and TO are both included, TO when whole steps reach it.
        /// </summary>
        /// <exception cref="UsageException">
        /// Malformed, empty, out of range or more than <see cref="Limit"/>.
        /// </exception>
        public static double[] Parse(string text) => Values.Parse(Read, text);

        /// <summary>As <see cref="Parse"/>, for a caller that names the text itself.</summary>
        /// <exception cref="FormatException">
        /// Malformed, empty, out of range or more than <see cref="Limit"/>.
        /// </exception>
        public static double[] Read(string text) => s_list.Read(text);
    }
}
