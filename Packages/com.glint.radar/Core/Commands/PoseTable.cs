using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace Glint.Core
{
    /// <summary>The table that a command prints, a line for each pose.</summary>
    public static class PoseTable
    {
        /// <summary>
        /// Heading of the columns for the poses of a plan: the axes that have more than one value, the angle always.
        /// </summary>
        public static string Header(SweepPlan plan) =>
            string.Concat(Columns(plan).Select(axis => axis.Name.PadLeft(axis.Width) + "  "))
            + "    amplitude         dB   received        hit";

        /// <summary>The line of one pose.</summary>
        /// <param name="plan">The plan of the pose.</param>
        /// <param name="row">The pose and its result.</param>
        public static string Row(SweepPlan plan, SweepRow row) =>
            string.Concat(Columns(plan).Select(axis => Cell(axis, row.Pose[axis]))) + Row(row.Result);

        static IEnumerable<SweepAxis> Columns(SweepPlan plan) =>
            SweepAxis.All.Where(axis => axis == SweepAxis.Angle || plan.Varies(axis));

        static string Cell(SweepAxis axis, double? value) =>
            (value?.ToString("0.###", CultureInfo.InvariantCulture) ?? "-").PadLeft(axis.Width) + "  ";

        static string Row(RadarResult result) => string.Format(CultureInfo.InvariantCulture,
            "{0,13:0.000}  {1,9}  {2,9}  {3,9}",
            result.Amplitude,
            result.AmplitudeDb.HasValue ? Decibels(result.AmplitudeDb.Value) : "-",
            result.RaysReceived,
            result.RaysHit);

        /// <summary>
        /// Details without a column: the sampling error, and the wavefront of a parallel ray.
        /// </summary>
        public static string Details(RadarResult result) => FormattableString.Invariant(
                $"normalised amplitude {result.NormalisedAmplitude:0.000}, sampling error ")
            + (result.Sampling is SamplingReport sampling
                ? FormattableString.Invariant($"{sampling.Error:g3}; largest step between neighbouring paths ")
                    + FormattableString.Invariant($"{sampling.LargestPathStep:g3} wavelengths")
                : "not estimated")
            + (result.RayArea is double area ? FormattableString.Invariant($"; {area:g6} m2 a ray") : "");

        // + 0 turns -0, rounded from slightly below 0 dB, into 0.
        static string Decibels(double value) =>
            (Math.Round(value, 2) + 0.0).ToString("0.00", CultureInfo.InvariantCulture);
    }
}
