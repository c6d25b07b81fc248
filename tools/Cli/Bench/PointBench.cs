using System;
using System.Collections.Generic;
using System.Diagnostics;
using Glint.Core;
using Glint.Editor;
using Glint.Host;
using Glint.Reference;
using Unity.Mathematics;

namespace Glint.Cli;

/// <summary>
/// Counts the rays that ray tubes and point sampling take for the same error of a cross section, without edges. Both
/// have the same kernels for paths and currents; a point's current stands for its square of the wavefront.
/// </summary>
sealed class PointBench
{
    // Tolerance of what both are compared with, decibels: it adds 2 % to errors of 0.1 dB.
    const double ConvergedDb = PointResult.ToleranceDb / 5;

    // Points along a wavelength that are tried, up to those within the tolerance.
    static readonly int[] s_across = [2, 3, 4, 5, 6, 8, PointResult.UsualAcross, 13, 16, 20, 25, 32, 40, 50];

    readonly IProgressSink _progress;
    readonly RadarController _radar;
    readonly RadarScene _scene;
    readonly double[] _azimuths;
    readonly PointResult _result;

    public PointBench(CommandLine line, RadarController radar, IProgressSink progress)
    {
        (_radar, _progress) = (radar, progress);
        var pose = radar.Gather();
        _scene = line.InputKind == InputKind.BuiltIn ? Sphere(pose.Settings.FrequencyHz) : pose.Scene;
        _azimuths = line.Get(Options.TimedCrossSections);
        _result = new PointResult
        {
            Subject = line.InputKind == InputKind.BuiltIn ? "sphere" : line.Input,
            Device = GraphicsDevice.Current.Info,
            Triangles = _scene.TriangleCount,
            FrequencyHz = pose.Settings.FrequencyHz,
            GrazingDegrees = line.Get(Options.Grazing),
            Offsets = line.Get(Options.Rounds),
        };
    }

    /// <exception cref="GlintException">The device cannot trace.</exception>
    /// <exception cref="OperationCanceledException">Stopped by the user.</exception>
    public PointResult Run()
    {
        using var tracer = new CrossSectionTracer(_radar.ClutterKernel, "point sampling");
        _progress.Start("directions", _azimuths.Length);
        try
        {
            for (int i = 0; i < _azimuths.Length; i++)
            {
                _result.Rows.Add(Measure(tracer, _azimuths[i]));
                _progress.Advance(i + 1, null);
            }
        }
        finally
        {
            _progress.Finish();
        }
        return _result;
    }

    // A right-angled facet of legs a is below the sphere by a^2 / 4R at most.
    static RadarScene Sphere(double frequency)
    {
        const double radius = 1;
        double sagitta = Signal.Wavelength(frequency) / MeshQuality.WavelengthsPerSagitta;
        double leg = 2 * Math.Sqrt(sagitta * radius);
        return new RadarScene(CrossSectionTargets.Sphere(radius, (int)Math.Ceiling(Math.PI / 2 * radius / leg)));
    }

    PointRow Measure(CrossSectionTracer tracer, double azimuth)
    {
        var pose = PoseOf(azimuth);
        pose.ToleranceDb = ConvergedDb;
        var converged = tracer.Trace(pose, null, _progress.Cancel);
        pose.ToleranceDb = PointResult.ToleranceDb;
        var watch = Stopwatch.StartNew();
        var tubes = tracer.Trace(pose, null, _progress.Cancel);
        var row = new PointRow(azimuth, converged, tubes, watch.Elapsed.TotalMilliseconds);
        foreach (int across in s_across)
        {
            row.Points.Add(Sample(tracer, pose, row, across));
            if (row.Enough != null && across >= PointResult.UsualAcross)
                break;
        }
        return row;
    }

    PointSampling Sample(CrossSectionTracer tracer, CrossSectionPose pose, PointRow row, int across)
    {
        // Another row has the same offsets.
        var random = new Random(across);
        var results = new List<CrossSectionResult>();
        var times = new Series();
        for (int i = 0; i < _result.Offsets; i++)
        {
            var offset = new double2(random.NextDouble(), random.NextDouble());
            var watch = Stopwatch.StartNew();
            results.Add(tracer.TracePoints(pose, across, offset, _progress.Cancel));
            times.Add(watch.Elapsed.TotalMilliseconds);
        }
        return new PointSampling(across, results[0].Rays, row.ErrorOf(results), times);
    }

    CrossSectionPose PoseOf(double azimuth)
    {
        var aspect = RadarAspect.At(azimuth, _result.GrazingDegrees);
        var (boxMin, boxMax) = _scene.Bound();
        var pose = new CrossSectionPose
        {
            Scene = _scene, Radar = aspect, Receivers = [aspect], PhaseCentre = (boxMin + boxMax) / 2,
            Frequencies = [_result.FrequencyHz], MaxBounces = _radar.Settings.MaxBounces, HasEdges = false,
        };
        _result.Side = TubeGrid.SideFor(pose, boxMin, boxMax);
        return pose;
    }
}
