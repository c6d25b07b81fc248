using System;

namespace Glint.Core
{
    /// <summary>The angles of a sweep, degrees, written FROM:TO:STEP or as a list with commas.</summary>
    public static class Angles
    {
        /// <summary>Maximum number of angles of one sweep.</summary>
        public const int Limit = NumberList.Limit;

        // Unity has single-precision angles: more than one turn only costs digits.
        static readonly NumberList s_list =
            new NumberList("angle", Interval.Closed(-360, 360), "degrees", ("0:45:1", "0,10,45"));

        /// <summary>
        /// The angles in the order given. FROM is included, and TO if whole steps reach it.
        /// </summary>
        /// <exception cref="UsageException">
        /// Malformed, empty, out of range or more than <see cref="Limit"/>.
        /// </exception>
        public static double[] Parse(string text)
        {
            try
            {
                return Read(text);
            }
            catch (FormatException error)
            {
                throw new UsageException($"{Values.Shown(text)}: {error.Message}");
            }
        }

        internal static double[] Read(string text) => s_list.Read(text);
    }
}
