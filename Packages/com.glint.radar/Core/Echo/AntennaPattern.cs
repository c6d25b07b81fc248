using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;

namespace Glint.Core
{
    /// <summary>
    /// One cut of an antenna's pattern: the field, one way, over the angle from the middle of the beam, where an
    /// analytic pattern is 1. Beam widths are between the points of half power.
    /// </summary>
    public sealed class AntennaPattern
    {
        // sin(pi x) / (pi x) = 1 / sqrt(2) at this x.
        const double HalfPowerSinc = 0.44294647068945;

        static readonly Interval s_width = Interval.Closed(0.01, 179);

        readonly Func<double, Complex> _field;

        AntennaPattern(double widthDegrees, Func<double, Complex> field) => (Width, _field) = (widthDegrees, field);

        /// <summary>Beam width, degrees; of a table, between the points of half of its largest power.</summary>
        public double Width { get; }

        /// <summary>A Gaussian beam: no sidelobes.</summary>
        /// <exception cref="GlintException">The width is out of its range.</exception>
        public static AntennaPattern Gaussian(double beamWidthDegrees)
        {
            double exponent = GaussianExponent(beamWidthDegrees);
            return new AntennaPattern(beamWidthDegrees, angle => GaussianField(exponent, angle));
        }

        /// <summary>A line or rectangle of constant field: sin(x) / x, sidelobes of -13 dB, 0 behind it.</summary>
        /// <inheritdoc cref="Gaussian" path="/exception"/>
        public static AntennaPattern Sinc(double beamWidthDegrees)
        {
            double scale = Math.PI * HalfPowerSinc / Math.Sin(Checked(beamWidthDegrees) / 2);
            return new AntennaPattern(beamWidthDegrees, angle =>
            {
                double x = scale * Math.Sin(angle);
                return Math.Abs(angle) > Math.PI / 2 ? 0 : x == 0 ? 1 : Math.Sin(x) / x;
            });
        }

        /// <summary>Whether two angles lead away from 0 on one side, as those of a cosecant do.</summary>
        public static bool LeadAway(double from, double to) =>
            Math.Sign(from) == Math.Sign(to) && Math.Abs(to) > Math.Abs(from) && from != 0;

        /// <summary>
        /// A Gaussian beam up to an angle, from there a power of 1 / sin^2 up to another, and nothing behind it: the
        /// same echo from any range at one height.
        /// </summary>
        /// <param name="fromDegrees">Where the beam ends; negative for a pattern to the left or downwards.</param>
        /// <param name="toDegrees">Where the pattern ends: further from 0, on the same side.</param>
        /// <exception cref="GlintException">An angle is out of its range.</exception>
        public static AntennaPattern CosecantSquared(double beamWidthDegrees, double fromDegrees, double toDegrees)
        {
            double exponent = GaussianExponent(beamWidthDegrees), side = Math.Sign(fromDegrees),
                from = Radians(side * fromDegrees), to = Radians(side * toDegrees);
            Require.Within("antenna", "end of the cosecant's angles", toDegrees, "degrees", Interval.Closed(-179, 179));
            if (!LeadAway(fromDegrees, toDegrees))
                throw new GlintException($"antenna: the cosecant's angles from {RadarSettings.Text(fromDegrees)} to "
                    + $"{RadarSettings.Text(toDegrees)} degrees must lead away from 0 on one side");
            double scale = GaussianField(exponent, from) * Math.Sin(from);
            return new AntennaPattern(beamWidthDegrees, angle => side * angle <= from ? GaussianField(exponent, angle)
                : side * angle <= to ? scale / Math.Sin(side * angle) : 0);
        }

        /// <summary>
        /// Fields at angles. Between them real and imaginary part are linear, outside them the field is 0.
        /// </summary>
        /// <param name="degrees">Ascending, two at least, from -180 to 180.</param>
        /// <exception cref="GlintException">
        /// The table has no order or other angles, or its columns differ in length.
        /// </exception>
        public static AntennaPattern Table(IReadOnlyList<double> degrees, IReadOnlyList<Complex> fields)
        {
            Require.Equal("antenna", "fields of the pattern's table", fields.Count, degrees.Count);
            if (degrees.Count < 2)
                throw new GlintException($"antenna: a pattern's table needs 2 rows or more, it has {degrees.Count}");
            foreach (double angle in new[] { degrees[0], degrees[degrees.Count - 1] })
                if (!(Math.Abs(angle) <= 180))
                    throw new GlintException($"antenna: the angle {RadarSettings.Text(angle)} degrees of the pattern's "
                        + "table must be from -180 to 180: write 359 as -1, and put the rows in ascending order");
            for (int i = 1; i < degrees.Count; i++)
                if (!(degrees[i] > degrees[i - 1]))
                    throw new GlintException($"antenna: the angle {RadarSettings.Text(degrees[i])} degrees of the "
                        + $"pattern's table follows {RadarSettings.Text(degrees[i - 1])}: put the rows in ascending "
                        + "order");
            double[] angles = degrees.Select(Radians).ToArray();
            Complex[] values = fields.ToArray();
            return new AntennaPattern(HalfPowerWidth(degrees, values), angle => Interpolate(angles, values, angle));
        }

        /// <summary>The field at an angle, radians, any number of turns.</summary>
        public Complex Field(double angle) => _field(Math.IEEERemainder(angle, 2 * Math.PI));

        /// <summary>
        /// The field of a Gaussian beam falls with exp(-this angle^2), the angle in radians: the power is 1/2 at half the
        /// width.
        /// </summary>
        /// <exception cref="GlintException">The width is out of its range.</exception>
        public static double GaussianExponent(double beamWidthDegrees)
        {
            double width = Checked(beamWidthDegrees);
            return 2 * Math.Log(2) / (width * width);
        }

        static double GaussianField(double exponent, double angle) => Math.Exp(-exponent * angle * angle);

        static Complex Interpolate(double[] angles, Complex[] fields, double angle)
        {
            if (angle < angles[0] || angle > angles[angles.Length - 1])
                return 0;
            int found = Array.BinarySearch(angles, angle);
            if (found >= 0)
                return fields[found];
            int next = ~found;
            double part = (angle - angles[next - 1]) / (angles[next] - angles[next - 1]);
            return (1 - part) * fields[next - 1] + part * fields[next];
        }

        // Where the table ends above half of the power, the beam ends there.
        static double HalfPowerWidth(IReadOnlyList<double> degrees, Complex[] fields)
        {
            double largest = fields.Max(field => field.Magnitude), half = largest * Math.Sqrt(0.5);
            int peak = Array.FindIndex(fields, field => field.Magnitude == largest);
            double Edge(int step)
            {
                int at = peak, next = at + step;
                while (next >= 0 && next < fields.Length && fields[next].Magnitude > half)
                    (at, next) = (next, next + step);
                if (next < 0 || next == fields.Length)
                    return degrees[at];
                double inside = fields[at].Magnitude, outside = fields[next].Magnitude;
                return degrees[at] + (inside - half) / (inside - outside) * (degrees[next] - degrees[at]);
            }
            return Edge(1) - Edge(-1);
        }

        static double Checked(double degrees)
        {
            Require.Within("antenna", "beam width", degrees, "degrees", s_width);
            return Radians(degrees);
        }

        static double Radians(double degrees) => degrees * (Math.PI / 180);
    }
}
