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
    // Finer steps of points, the last of which is what all are compared with; grids that show an error.
    const int StepsToConverged = 2, MinGrids = 3;

    // Tolerances of tubes and points along a side that are tried, until the measured error is within the tolerance.
    static readonly double[] s_tolerances = [PointResult.ToleranceDb, 0.07, 0.05, 0.035];
    static readonly int[] s_across =
        [2, 3, 4, 5, 6, 8, PointResult.UsualAcross, 13, 16, 20, 25, 32, 40, 50, 64, 80, 100, 128, 160, 200, 256];

    // Grids are turned by up to this: rows along edges that are level or upright would be worse than usual ones.
    const double MaxTurnDegrees = 15;

    readonly IProgressSink _progress;
    readonly RadarController _radar;
    readonly RadarScene _scene;
    readonly (double3 Min, double3 Max) _box;
    readonly double[] _azimuths;
    readonly PointResult _result;

    public PointBench(CommandLine line, RadarController radar, IProgressSink progress)
    {
        (_radar, _progress) = (radar, progress);
        var pose = radar.Gather();
        _scene = line.InputKind == InputKind.BuiltIn ? Sphere(pose.Settings.FrequencyHz) : pose.Scene;
        _box = _scene.Bound();
        _azimuths = line.Get(Options.CrossSections);
        _result = new PointResult
        {
            Subject = line.InputKind == InputKind.BuiltIn ? "sphere" : line.Input,
            Device = GraphicsDevice.Current.Info,
            Triangles = _scene.TriangleCount,
            FrequencyHz = pose.Settings.FrequencyHz,
            GrazingDegrees = line.Get(Options.Grazing),
            Grids = Math.Max(MinGrids, line.Get(Options.Rounds)),
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
        var row = new PointRow(azimuth, CrossSectionFloor.Of(_box.Min, _box.Max));
        _result.Side = TubeGrid.SideFor(PoseOf(azimuth, 0, 0), _box.Min, _box.Max);
        for (int i = 0, steps = 0; i < s_across.Length && steps <= StepsToConverged; i++)
        {
            int across = s_across[i];
            row.Points.Add(Sample(across, (turn, offset) =>
                tracer.TracePoints(PoseOf(azimuth, turn, 0), across, offset, _progress.Cancel)));
            // The scatter of the grids themselves.
            if (across >= PointResult.UsualAcross && (steps > 0 || row.IsWithin(row.Points[^1])))
                steps++;
        }
        foreach (double tolerance in s_tolerances)
        {
            row.Tubes.Add(Sample(tolerance, (turn, _) =>
                tracer.Trace(PoseOf(azimuth, turn, tolerance), null, _progress.Cancel)));
            if (row.IsWithin(row.Tubes[^1]))
                break;
        }
        return row;
    }

    // The same turns and offsets for each setting.
    Sampling Sample(double setting, Func<double, double2, CrossSectionResult> trace)
    {
        var random = new Random(1);
        var matrices = new List<ScatteringMatrix>();
        var times = new Series();
        long rays = 0;
        for (int i = 0; i < _result.Grids; i++)
        {
            double turn = math.radians(MaxTurnDegrees) * (2 * random.NextDouble() - 1);
            var offset = new double2(random.NextDouble(), random.NextDouble());
            var watch = Stopwatch.StartNew();
            var result = trace(turn, offset);
            times.Add(watch.Elapsed.TotalMilliseconds);
            matrices.Add(Turned(result.S[0, 0], turn));
            rays += result.Rays;
        }
        return new Sampling(setting, rays / _result.Grids, matrices, times);
    }

    // A matrix of polarisations turned by an angle, in those that are not.
    static ScatteringMatrix Turned(in ScatteringMatrix s, double turn)
    {
        double cos = Math.Cos(turn), sin = Math.Sin(turn), cross = sin * cos;
        return new ScatteringMatrix
        {
            VV = cos * cos * s.VV + cross * (s.HV + s.VH) + sin * sin * s.HH,
            HH = sin * sin * s.VV - cross * (s.HV + s.VH) + cos * cos * s.HH,
            HV = cross * (s.HH - s.VV) + cos * cos * s.HV - sin * sin * s.VH,
            VH = cross * (s.HH - s.VV) + cos * cos * s.VH - sin * sin * s.HV,
        };
    }

    // The grid turns with the radar about the sight.
    CrossSectionPose PoseOf(double azimuth, double turn, double toleranceDb)
    {
        var upright = RadarAspect.At(azimuth, _result.GrazingDegrees);
        double cos = Math.Cos(turn), sin = Math.Sin(turn);
        var aspect = new RadarAspect(upright.ToRadar, cos * upright.Up - sin * upright.Right,
            cos * upright.Right + sin * upright.Up);
        return new CrossSectionPose
        {
            Scene = _scene, Radar = aspect, Receivers = [aspect], PhaseCentre = (_box.Min + _box.Max) / 2,
            Frequencies = [_result.FrequencyHz], MaxBounces = _radar.Settings.MaxBounces, HasEdges = false,
            ToleranceDb = toleranceDb,
        };
    }
}
