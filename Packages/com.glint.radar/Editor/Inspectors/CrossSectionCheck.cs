using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using Glint.Core;
using UnityEditor;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>Checks a RadarCrossSection as it would begin, and describes its run.</summary>
    sealed class CrossSectionCheck
    {
        readonly RadarCrossSection _radar;
        readonly SceneGatherer _gatherer = new SceneGatherer();
        readonly List<Finding> _findings = new List<Finding>();

        public CrossSectionCheck(RadarCrossSection radar) => _radar = radar;

        public IReadOnlyList<Finding> Findings => _findings;

        /// <summary>What would be computed; null if it is refused.</summary>
        public CrossSectionSetup Setup { get; private set; }

        /// <summary>Duration of the last update, by which callers may space theirs.</summary>
        public double Seconds { get; private set; }

        /// <summary>Updates the findings. It gathers the scene.</summary>
        public void Update()
        {
            var watch = Stopwatch.StartNew();
            _findings.Clear();
            Setup = null;
            if (!_radar.isActiveAndEnabled)
                _findings.Add(new Finding(Severity.Warning, SceneSearch.IsDisabled(_radar)));
            Finding.Add(_findings, () => CrossSectionTracer.Check(_radar.Kernel, _radar.Subject), AssignKernel);
            Finding.Add(_findings, () => Setup = _radar.Setup(_gatherer));
            if (Setup != null)
                _findings.AddRange(_gatherer.Warnings.Select(warning =>
                    new Finding(Severity.Warning, $"{_radar.Subject}: {warning}")));
            Seconds = watch.Elapsed.TotalSeconds;
        }

        /// <summary>The figures of the last update for an inspector: label, value, meaning.</summary>
        public IEnumerable<(string label, string value, string tooltip)> Figures()
        {
            if (Setup == null)
                yield break;
            yield return ("Rows", FormattableString.Invariant($"{Setup.Plan.Count:N0}"),
                "Every azimuth with every elevation, frequency and receiver.");
            yield return ("Target", FormattableString.Invariant(
                    $"{Setup.Scene.TriangleCount:N0} triangles, {Setup.Objects:N0} objects, radius {Setup.Radius:g4} m"),
                "What is traced, and the radius of the sphere around it.");
            yield return ("Floor", FormattableString.Invariant($"{Setup.FloorDbsm:0.00} dBsm"),
                "Cross section below which the tolerance is relative to this one.");
        }

        /// <summary>The run for an inspector: label, value, meaning.</summary>
        public static IEnumerable<(string label, string value, string tooltip)> Results(RadarCrossSection radar)
        {
            if (radar.Rows.Count == 0)
                yield break;
            foreach (var polarisation in Polarisation.All)
                if (radar.Rows[0].Amplitude(polarisation).HasValue)
                {
                    var largest = radar.Rows.OrderByDescending(row => polarisation.Of(row.S).Magnitude).First();
                    yield return ($"Largest {polarisation.Name.ToUpperInvariant()}", FormattableString.Invariant(
                            $"{ScatteringMatrix.Dbsm(polarisation.Of(largest.S)):0.00} dBsm at {largest}"),
                        "The largest cross section of the rows so far.");
                }
            yield return ("Largest error", FormattableString.Invariant(
                    $"{radar.Rows.Max(row => row.Accuracy.ErrorDb):0.000} dB, tolerance met in {radar.Rows.Count(row => row.MeetsTolerance):N0} of {radar.Rows.Count:N0} rows"),
                "Standard error of the integration, not of physical optics.");
            int outside = radar.Rows.Count(row => row.IsOutsidePhysicalOptics);
            if (outside > 0)
                yield return ("Outside physical optics", FormattableString.Invariant(
                        $"{outside:N0} of {radar.Rows.Count:N0} rows"),
                    FormattableString.Invariant(
                        $"Radar and receiver are more than {CrossSectionRow.MaxBistaticDegrees:0} degrees apart, outside the forward lobe: column outside_physical_optics."));
        }

        // Null if it has the kernel, or the project has none.
        Fix AssignKernel()
        {
            var kernel = ProjectAssets.TubesKernel;
            return kernel == null || _radar.Kernel == kernel ? null : new Fix("Assign Tubes.compute",
                () => Fix.Change(_radar, "Assign Tubes.compute", it => it.Kernel = kernel));
        }
    }

    /// <summary>
    /// Runs a RadarCrossSection in edit mode: a direction a tick of the editor. A long one shows a bar that cancels.
    /// </summary>
    static class CrossSectionTicks
    {
        /// <summary>Begins. In play mode the component continues by itself.</summary>
        /// <param name="secondsUntilBar">A shorter direction shows no bar.</param>
        public static void Run(RadarCrossSection radar, double secondsUntilBar = CancelBar.SecondsUntilShown)
        {
            radar.Run();
            if (Application.IsPlaying(radar.gameObject))
                return;
            EditorApplication.update += Tick;

            void Tick()
            {
                // It ends by itself when it is disabled or destroyed, scripts are reloaded or the scene is closed.
                if (radar == null || !radar.IsRunning)
                    EditorApplication.update -= Tick;
                else
                    using (var bar = new CancelBar($"Cross section of '{radar.name}', row {radar.Rows.Count + 1} of "
                        + radar.RowCount, secondsUntilBar))
                        radar.Step(bar, bar.Cancel);
            }
        }
    }
}
