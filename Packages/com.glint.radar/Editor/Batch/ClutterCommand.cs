using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Glint.Core;

namespace Glint.Editor
{
    /// <summary><c>glint clutter</c>: the diffuse echo of the sea of a scene, beside published models.</summary>
    static class ClutterCommand
    {
        // The angle at which the measured shape is that without swell.
        const double WithoutSwellDegrees = 45;

        public static int Execute(CommandLine line, IProgressSink progress)
        {
            var startedUtc = DateTime.UtcNow;
            var setup = new ClutterSetup(line);
            string path = line.IsGiven(ClutterOptions.Out) ? Path.GetFullPath(line.Get(ClutterOptions.Out))
                : RunDescription.DefaultFolder(setup.Name, ResultTable.Clutter);
            using (var folder = ResultsFolder.Open(path, ResultTable.Clutter))
            using (var tracer = new ClutterTracer(ProjectAssets.TubesKernel, setup.Name))
            {
                int code = Trace(setup, tracer, folder, progress);
                if (code != Batch.Done)
                    return code;
                folder.Finish(setup.Describe(startedUtc));
                progress.Print($"written: {string.Join(", ", folder.WrittenPaths)}");
                return Batch.Done;
            }
        }

        static int Trace(ClutterSetup setup, ClutterTracer tracer, ResultsFolder folder, IProgressSink progress)
        {
            var first = setup.First.Clutter;
            progress.Print(FormattableString.Invariant(
                $"sea state {first.SeaState:0.0}, clutter wind {first.ShortWaves.Wind:0.0} m/s, level ")
                + ClutterModel.NameOf(first.Settings.Level));
            var levels = setup.Model == null ? null : new ClutterLevels(tracer, setup.Model);
            var models = ClutterModel.All;
            int done = 0;
            progress.Start(setup.Name, setup.Count);
            try
            {
                foreach (var (sea, snapshot, frequency, azimuth, grazing) in setup.Rows())
                {
                    if (progress.Cancel.IsCancellationRequested)
                        return Batch.Cancelled;
                    var row = new ClutterRow
                    {
                        Snapshot = snapshot, TimeSeconds = sea.Clutter.Time, AzimuthDegrees = azimuth,
                        Conditions = sea.Clutter.ConditionsAt(frequency, azimuth, grazing)
                    };
                    Measure(row, sea, setup, tracer, progress);
                    if (levels != null)
                        Scale(row, levels.TableOf(sea, frequency, azimuth, progress, progress.Cancel));
                    Compare(row, setup, models, sea.Clutter.SwellAngleAt(azimuth) ?? WithoutSwellDegrees);
                    folder.Append(row);
                    if (done == 0)
                        progress.Print(ClutterTable.Header);
                    progress.Print(ClutterTable.Line(row));
                    progress.Advance(++done, row.ToString());
                }
            }
            finally
            {
                progress.Finish();
            }
            return Batch.Done;
        }

        static void Measure(ClutterRow row, EndlessSea sea, ClutterSetup setup, ClutterTracer tracer,
            IProgressSink progress)
        {
            double frequency = row.Conditions.Frequency;
            var (grid, areWhole) = sea.CellsOf(row.AzimuthDegrees, setup.Cell);
            var cells = tracer.Trace(sea.PoseOf(row.AzimuthDegrees, row.Conditions.GrazingDegrees, frequency), frequency,
                grid, progress, progress.Cancel);
            var whole = cells.Where((_, i) => areWhole[i]).ToArray();
            var all = ClutterEcho.Sum(cells);
            (row.Sigma0, row.LitFraction, row.Cells) = (all.Sigma0, all.LitFraction, whole.Length);
            row.ShapeVV = ShapeOf(whole.Select(cell => cell.SigmaVV).ToArray());
            row.ShapeHH = ShapeOf(whole.Select(cell => cell.SigmaHH).ToArray());
        }

        static double? ShapeOf(double[] textures)
        {
            double shape = textures.Length < ClutterSetup.MinCells ? double.NaN
                : ClutterStatistics.ShapeOfTexture(textures);
            return double.IsNaN(shape) || double.IsInfinity(shape) ? (double?)null : shape;
        }

        static void Scale(ClutterRow row, ClutterLevelTable table)
        {
            var factor = table.FactorAt(row.Conditions.GrazingDegrees * Math.PI / 180);
            var own = row.Sigma0;
            row.Sigma0 = new Sigma0(factor.HH * own.HH, factor.VV * own.VV, factor.HV * own.HV);
        }

        static void Compare(ClutterRow row, ClutterSetup setup, IReadOnlyList<ClutterModel> models, double swellDegrees)
        {
            var at = row.Conditions;
            row.Models = models.Select(model =>
                (model.DecibelsOrNull(Polarisation.VV, at), model.DecibelsOrNull(Polarisation.HH, at))).ToArray();
            if (at.GrazingDegrees > ClutterStatistics.MaxGrazingOfShape
                || !ClutterStatistics.FrequenciesOfShape.Contains(at.Frequency))
                return;
            double Measured(bool isHorizontal) => ClutterStatistics.EmpiricalShape(at.GrazingDegrees,
                setup.Cell.x * setup.Cell.y, isHorizontal, swellDegrees);
            (row.MeasuredShapeVV, row.MeasuredShapeHH) = (Measured(false), Measured(true));
        }
    }

    /// <summary>The table that <c>glint clutter</c> prints, a line for each row.</summary>
    static class ClutterTable
    {
        public const string Header =
            "    frequency  azimuth  grazing   VV dB   HH dB   HV dB    lit  shape VV  shape HH";

        public static string Line(ClutterRow row) => FormattableString.Invariant(
                $"{row.Conditions.Frequency,13:g6}  {row.AzimuthDegrees,7:0.###}  {row.Conditions.GrazingDegrees,7:0.###}")
            + Level(row.Sigma0.VV) + Level(row.Sigma0.HH) + Level(row.Sigma0.HV)
            + FormattableString.Invariant($"  {row.LitFraction,5:0.000}") + Text(row.ShapeVV) + Text(row.ShapeHH);

        static string Level(double sigma) => "  " + (sigma > 0
            ? FormattableString.Invariant($"{Sigma0.Decibels(sigma),6:0.0}") : "     -");

        static string Text(double? number) => "  " + (number is double value
            ? FormattableString.Invariant($"{value,8:0.00}") : "       -");
    }
}
