using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Glint.Editor;
using Glint.Reference;

namespace Glint.Cli;

/// <summary>A cross section over an angle, VV and HH in dBsm.</summary>
sealed record CrossSectionCurve(string Name, IReadOnlyList<(double Degrees, double VV, double HH)> Rows);

/// <summary>Cross sections of two bodies beside those that others computed.</summary>
sealed class CrossSectionCurves(CrossSectionTracer tracer, IProgressSink progress)
{
    // Tolerance of a pose, decibels.
    const double ToleranceDb = 0.05;

    // The most that a trace takes.
    const int ReceiversPerTrace = 16;

    /// <summary>
    /// A plate of 6 by 10.5 inches without thickness at 5.12 GHz from normal to edge on: the method of moments, and Glint
    /// without and with fringe fields.
    /// </summary>
    /// <exception cref="GlintException">The device cannot trace.</exception>
    /// <exception cref="OperationCanceledException">Stopped by the user.</exception>
    public CrossSectionCurve[] Plate()
    {
        const double inch = 0.0254;
        var scene = new RadarScene(CrossSectionTargets.Plate(10.5 * inch, 6 * inch));
        // Half of the published steps, because lobes are 6 degrees wide and nulls much narrower.
        double[] degrees = [.. Enumerable.Range(0, 361).Select(i => i / 4.0)];
        CrossSectionCurve Curve(string name, bool hasEdges) => new(name, Traced(degrees, 1, some =>
            NewPose(scene, 5.12e9, AspectOf(some[0]), some, hasEdges)));
        return
        [
            new("method of moments", PublishedCrossSections.Read("plate_moments")),
            Curve("Glint, no fringe fields", false), Curve("Glint", true)
        ];
    }

    /// <summary>A sphere of 1 m diameter at 10 GHz over the bistatic angle: Mie's series, and Glint.</summary>
    /// <inheritdoc cref="Plate"/>
    public CrossSectionCurve[] Sphere()
    {
        var scene = new RadarScene(CrossSectionTargets.Sphere(0.5, 33));
        var mie = PublishedCrossSections.Read("sphere_mie");
        double[] degrees = [.. mie.Select(row => row.Degrees)];
        return
        [
            new("Mie", mie), new("Glint", Traced(degrees, ReceiversPerTrace, some =>
                NewPose(scene, 10e9, AspectOf(0), some, false)))
        ];
    }

    // Several angles in a trace.
    (double, double, double)[] Traced(double[] degrees, int perTrace, Func<double[], CrossSectionPose> poseOf)
    {
        var rows = new List<(double, double, double)>();
        progress.Start("directions", degrees.Length);
        try
        {
            foreach (var some in degrees.Chunk(perTrace))
            {
                var s = tracer.Trace(poseOf(some), null, progress.Cancel).S;
                rows.AddRange(some.Select((angle, i) =>
                    (angle, ScatteringMatrix.Dbsm(s[i, 0].VV), ScatteringMatrix.Dbsm(s[i, 0].HH))));
                progress.Advance(rows.Count, null);
            }
        }
        finally
        {
            progress.Finish();
        }
        return [.. rows];
    }

    static CrossSectionPose NewPose(RadarScene scene, double frequency, RadarAspect radar, double[] receivers,
        bool hasEdges) => new()
        {
            Scene = scene,
            Radar = radar,
            Receivers = Array.ConvertAll(receivers, AspectOf),
            Frequencies = [frequency],
            MaxBounces = 1,
            HasEdges = hasEdges,
            ToleranceDb = ToleranceDb,
        };

    // At an angle from the normal of CrossSectionTargets.Plate, on the horizon.
    static RadarAspect AspectOf(double degrees) => RadarAspect.At(-90 - degrees, 0);
}
