using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;
using UnityEditor;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>
    /// The commands without a window: <c>Unity -batchmode -executeMethod Glint.Editor.Batch.Sweep --glint
    /// Scenes/X.unity --target NAME --angles 0:45:1</c>.
    /// The headless command calls <see cref="Execute"/> with the same command line.
    /// </summary>
    public static class Batch
    {
        /// <summary>The exit code of work that was cancelled.</summary>
        public const int Cancelled = 130;

        internal const int Done = 0, Failed = 1;

        /// <summary>Entry of Unity's -executeMethod: <c>glint sweep</c>.</summary>
        public static void Sweep() => ExecuteAndExit(Commands.Sweep, Environment.GetCommandLineArgs());

        /// <summary>Entry of Unity's -executeMethod: <c>glint run</c>.</summary>
        public static void Run() => ExecuteAndExit(Commands.Run, Environment.GetCommandLineArgs());

        /// <summary>Entry of Unity's -executeMethod: <c>glint rcs</c>.</summary>
        public static void Rcs() => ExecuteAndExit(Commands.Rcs, Environment.GetCommandLineArgs());

        /// <summary>Entry of Unity's -executeMethod: <c>glint echo</c>.</summary>
        public static void Echo() => ExecuteAndExit(Commands.Echo, Environment.GetCommandLineArgs());

        /// <summary>Entry of Unity's -executeMethod: <c>glint isar</c>.</summary>
        public static void Isar() => ExecuteAndExit(Commands.Isar, Environment.GetCommandLineArgs());

        /// <summary>Entry of Unity's -executeMethod: <c>glint clutter</c>.</summary>
        public static void Clutter() => ExecuteAndExit(Commands.Clutter, Environment.GetCommandLineArgs());

        /// <summary>Entry of Unity's -executeMethod: <c>glint ppi</c>.</summary>
        public static void Ppi() => ExecuteAndExit(Commands.Ppi, Environment.GetCommandLineArgs());

        /// <summary>Entry of Unity's -executeMethod: <c>glint merge</c>.</summary>
        public static void Merge() => ExecuteAndExit(Commands.Merge, Environment.GetCommandLineArgs());

        /// <summary>Entry of Unity's -executeMethod: <c>glint report</c>.</summary>
        public static void Report() => ExecuteAndExit(Commands.Report, Environment.GetCommandLineArgs());

        /// <summary>Entry of Unity's -executeMethod: <c>glint sea</c>.</summary>
        public static void Sea() => ExecuteAndExit(Commands.Sea, Environment.GetCommandLineArgs());

        /// <summary>Entry of Unity's -executeMethod: <c>glint ship</c>.</summary>
        public static void Ship() => ExecuteAndExit(Commands.Ship, Environment.GetCommandLineArgs());

        /// <summary>Entry of Unity's -executeMethod: <c>glint reflector</c>.</summary>
        public static void Reflector() => ExecuteAndExit(Commands.Reflector, Environment.GetCommandLineArgs());

        /// <summary>Executes a command line in edit mode; the scene is not saved.</summary>
        /// <returns>The exit code: 0 done, 130 cancelled.</returns>
        /// <exception cref="GlintException">A problem with a file, the scene or the device.</exception>
        /// <exception cref="OperationCanceledException">
        /// Cancelled within a pose; earlier rows are kept.
        /// </exception>
        public static int Execute(CommandLine line, IProgressSink progress) =>
            line.Command.Handler(line, progress);

        internal static int TracePoses(CommandLine line, IProgressSink progress)
        {
            var plan = PlanOf(line);
            var loaded = LoadedScene.Open(line);
            try
            {
                using (var folder = OpenFolder(line, loaded.Name))
                {
                    CheckUnfinished(line, folder);
                    var setup = loaded.Sweep(plan);
                    setup.Command = ArgumentsOf(line);
                    using (var run = new SweepRun(setup, folder, line.Get(Options.Shard), line.Get(Options.Resume))
                    {
                        PosesAhead = int.MaxValue
                    })
                    {
                        if (!run.IsComplete)
                            WarnOfSize(setup, loaded.Name);
                        return Trace(run, loaded, folder, plan, progress);
                    }
                }
            }
            finally
            {
                loaded.Radar.Release();
            }
        }

        /// <summary>The arguments that identify what is traced, without output folder, part and device.</summary>
        internal static string[] ArgumentsOf(CommandLine line) =>
            line.Arguments.Where(word => new Option[] { Options.Out, Options.Shard, Options.Resume, Options.Device }
                .All(aside => word.Split('=')[0] != aside.Flag)).ToArray();

        internal static int MergeParts(CommandLine line, IProgressSink progress)
        {
            string output = line.Get(Options.Out);
            if (ResultsMerge.IsOneOf(line.Folders, output))
                throw new UsageException($"{Options.Out.Flag} {output}: is one of the parts, "
                    + "which the whole would replace: choose another results folder");
            if (File.Exists(Path.Combine(output, ResultsFolder.PartialName)))
                Debug.LogWarning($"{output}: holds a sweep that is not finished; the whole replaces it");
            var folder = ResultsMerge.Merge(line.Folders, Path.GetFullPath(output));
            WarnOfRows(folder);
            progress.Print($"written: {string.Join(", ", folder.WrittenPaths)}");
            return Done;
        }

        // As at the end of a run of all rows.
        static void WarnOfRows(ResultsFolder folder)
        {
            string name = Path.GetFileNameWithoutExtension(folder.Info.ScenePath);
            double toleranceDb = folder.Info.Settings.FirstOrDefault(setting => setting.Name == "tolerance").Number;
            if (folder.Table != ResultTable.Sweep)
            {
                CrossSectionCommand.WarnOf(folder.Rows, name, toleranceDb);
                return;
            }
            var warnings = new PoseWarnings();
            foreach (var row in folder.Rows)
                warnings.Add(row);
            warnings.Log(name, toleranceDb > 0);
        }

        /// <summary>The poses of a sweep; a single pose for other commands.</summary>
        internal static SweepPlan PlanOf(CommandLine line)
        {
            if (line.Command != Commands.Sweep)
                return SweepPlan.Single;
            var plan = new SweepPlan(axis => line.Get(Options.Of(axis)));
            if (line.Get(Options.Shard) is SweepShard shard && shard.Count > plan.Count)
                throw new UsageException($"{Options.Shard.Flag} {shard}: the sweep has {plan.Count} poses: "
                    + "use at most as many parts");
            return plan;
        }

        static int Trace(SweepRun run, LoadedScene loaded, ResultsFolder folder,
            SweepPlan plan, IProgressSink progress)
        {
            int before = run.Done;
            var warnings = new PoseWarnings();
            foreach (var row in folder?.Rows ?? Array.Empty<StoredRow>())
                warnings.Add(row);
            if (before > 0)
                progress.Print(run.IsComplete
                    ? "already complete: nothing to do"
                    : FormattableString.Invariant($"resumed: {before} of {run.Count} poses are done"));
            progress.Start(loaded.Name, run.Count, before);
            try
            {
                while (!run.IsComplete && !progress.Cancel.IsCancellationRequested)
                {
                    var row = run.Step(progress, progress.Cancel);
                    if (run.Done == before + 1)
                        progress.Print(PoseTable.Header(plan));
                    warnings.Add(row.Result);
                    progress.Print(PoseTable.Row(plan, row));
                    if (plan == SweepPlan.Single)
                    {
                        progress.Print(PoseTable.Details(row.Result));
                        if (row.Result.Echo != null)
                            progress.Print(PoseTable.Details(row.Result.Echo));
                    }
                    progress.Advance(run.Done, plan == SweepPlan.Single ? null : row.Pose.ToString());
                }
            }
            finally
            {
                progress.Finish();
                if (!run.IsComplete && run.Done > 0)
                    Debug.Log(FormattableString.Invariant(
                        $"{run.Done} of {run.Count} poses are done and kept; the same command with {Options.Resume.Flag} continues"));
            }
            if (!run.IsComplete)
                return Cancelled;
            warnings.Log(loaded.Name, loaded.Radar.Settings.ToleranceDb > 0);
            if (folder != null && run.Done > before)
                progress.Print($"written: {folder.CsvPath}, {folder.JsonPath}");
            return Done;
        }

        // Of all that is traced, at the lowest frequency.
        static void WarnOfSize(SweepSetup setup, string name)
        {
            var boxes = new SceneBoxes();
            boxes.Update(setup.Radar.Gather().Scene);
            double lowest = setup.Plan.Values(SweepAxis.Frequency)?.Min() ?? setup.Radar.Settings.FrequencyHz;
            if (!boxes.IsEmpty && ElectricalSize.Warning(name, math.distance(boxes.Min, boxes.Max), lowest) is string warning)
                Debug.LogWarning(warning);
        }

        // A sweep that begins anew is warned of what it replaces; a single pose, which cannot go on with it, is refused.
        internal static void CheckUnfinished(CommandLine line, ResultsFolder folder)
        {
            if (folder == null || line.Get(Options.Resume) || !File.Exists(folder.PartialPath))
                return;
            if (!line.Command.Options.Contains(Options.Resume))
                throw new GlintException($"{folder.FolderPath}: holds a sweep that is not finished: finish it by its command "
                    + $"with {Options.Resume.Flag}, or choose another folder with {Options.Out.Flag}");
            Debug.LogWarning($"{folder.FolderPath}: holds a sweep that is not finished; "
                    + $"the first row replaces it ({Options.Resume.Flag} would continue it)");
        }

        // A sweep always writes results; a single pose only with --out.
        static ResultsFolder OpenFolder(CommandLine line, string name)
        {
            if (line.IsGiven(Options.Out))
                return ResultsFolder.Open(Path.GetFullPath(line.Get(Options.Out)));
            return line.Command == Commands.Sweep ? ResultsFolder.Open(RunDescription.DefaultFolder(name)) : null;
        }

        internal static void ExecuteAndExit(Command command, IReadOnlyList<string> processArguments)
        {
            // Unity would write ten lines of stack trace below each line of progress.
            Application.SetStackTraceLogType(LogType.Log, StackTraceLogType.None);
            int code = Failed;
            try
            {
                code = Execute(CommandLine.FromUnity(command, processArguments), new LogProgress());
            }
            catch (GlintException problem)
            {
                Debug.LogError($"glint {command.Name}: {problem.Message}");
                code = problem.ExitCode;
            }
            catch (Exception fault)
            {
                Debug.LogException(fault);
            }
            EditorApplication.Exit(code);
        }
    }

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
            Decibels(result.AmplitudeDb),
            result.RaysReceived,
            result.RaysHit);

        /// <summary>
        /// Details without a column: the sampling error, and the wavefront of a parallel ray.
        /// </summary>
        public static string Details(RadarResult result) => FormattableString.Invariant(
                $"normalised amplitude {result.NormalisedAmplitude:0.000}, sampling error ")
            + (result.Sampling is SamplingReport sampling
                ? FormattableString.Invariant($"{sampling.Error:g3}; ") + (sampling.LargestPathStep is double step
                    ? FormattableString.Invariant($"largest step between neighbouring paths {step:g3} wavelengths")
                    : FormattableString.Invariant($"ray tubes, {result.RaysEmitted:N0} rays, tolerance ")
                        + (sampling.Undersampled ? "not met" : "met"))
                : ResultColumn.NotEstimated)
            + (result.RayArea is double area ? FormattableString.Invariant($"; {area:g6} m2 a ray") : "");

        /// <summary>Cross section, clutter and signal to clutter of a pose whose sea has clutter, in VV and HH.</summary>
        public static string Details(PoseEcho echo) => string.Join("; ", Polarisation.All
            .Where(it => it.Sent == it.Received)
            .Select(it => $"{it.Name.ToUpperInvariant()} {Decibels(echo.SigmaDbsm(it))} dBsm, "
                + $"clutter {Decibels(echo.ClutterDbsm(it))} dBsm, "
                + $"signal to clutter {Decibels(echo.SignalToClutterDb(it))} dB"));

        static string Decibels(double? value) => value.HasValue ? Decibels(value.Value) : "-";

        // + 0 turns -0, rounded from slightly below 0 dB, into 0.
        static string Decibels(double value) =>
            (Math.Round(value, 2) + 0.0).ToString("0.00", CultureInfo.InvariantCulture);
    }
}
