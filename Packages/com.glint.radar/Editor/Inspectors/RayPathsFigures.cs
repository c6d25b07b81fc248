using System;
using System.Collections.Generic;

namespace Glint.Editor
{
    /// <summary>Figures of Ray Paths for an inspector.</summary>
    static class RayPathsFigures
    {
        /// <summary>Why no rays are drawn, if known; else null.</summary>
        public static Finding Check(RayPaths paths)
        {
            if (paths.MinBounces > paths.MaxBounces)
                return new Finding(Severity.Warning, FormattableString.Invariant(
                    $"no rays are drawn: none has {paths.MinBounces} bounces or more and {paths.MaxBounces} or fewer; lower Fewest Bounces, or raise Most Bounces"));
            if (paths.GetComponent<RadarController>().Result == null)
                return new Finding(Severity.Warning,
                    "no rays are drawn: nothing is traced yet; press Trace now, or play the scene");
            if (paths.IsOutdated)
                return new Finding(Severity.Warning, "no rays are drawn: the scene or the radar has changed since the "
                    + "last pose, or the radar has released it; press Trace now");
            return null;
        }

        /// <summary>The figures: label, value, meaning.</summary>
        public static IEnumerable<(string label, string value, string tooltip)> Rows(RayPaths paths)
        {
            string followed = paths.LeftOut > 0 ? FormattableString.Invariant(
                $"; followed {RayPaths.MaxRays:N0} of {(long)RayPaths.MaxRays + paths.LeftOut:N0}") : "";
            yield return ("Rays drawn", FormattableString.Invariant($"{paths.Count:N0}{followed}"), "Rays of the "
                + "last drawn pose that pass the filters. Above the maximum number an even selection is drawn.");
        }
    }
}
