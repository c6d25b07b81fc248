using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Numerics;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary><c>glint rcs</c>: cross sections of a scene or a mesh file.</summary>
    static class CrossSectionCommand
    {
        public static int Execute(CommandLine line, IProgressSink progress)
        {
            var plan = CrossSectionOptions.PlanOf(line, line.Get(CrossSectionOptions.Frequency));
            var opened = OpenScene(line);
            var setup = SetupOf(line, opened, plan);
            return Compute(line, setup, opened.name, ResultTable.CrossSection, new CrossSectionTable(setup), progress);
        }

        /// <summary>Computes the rows of a setup into the folder of a command line, prints them and warns.</summary>
        /// <param name="table">What the rows are written as.</param>
        /// <param name="lines">What is printed of the rows; null: nothing.</param>
        /// <returns>The exit code.</returns>
        /// <exception cref="GlintException">A row cannot be computed or written; earlier rows are kept.</exception>
        public static int Compute(CommandLine line, CrossSectionSetup setup, string name, ResultTable table,
            IRowLines lines, IProgressSink progress)
        {
            if (line.IsGiven(CrossSectionOptions.Reference) && setup.Scene.Seas.Count > 0)
                throw new GlintException($"{name}: the reference tracer knows no diffuse echo of a sea: leave "
                    + $"{CrossSectionOptions.Reference.Flag} out, or switch the clutter off");
            string path = line.IsGiven(CrossSectionOptions.Out)
                ? Path.GetFullPath(line.Get(CrossSectionOptions.Out))
                : RunDescription.DefaultFolder(name, table);
            using (var folder = ResultsFolder.Open(path, table))
            {
                Batch.CheckUnfinished(line, folder);
                using (var run = new CrossSectionRun(setup, ProjectAssets.TubesKernel, folder,
                    line.Get(Options.Shard), line.Get(Options.Resume), CrossSectionTracer.PosesOfADispatch))
                {
                    if (!run.IsComplete)
                        Describe(setup, name, progress);
                    var comparison = new CrossSectionComparison(setup, line.Get(CrossSectionOptions.Reference));
                    int code = Trace(run, setup, name, folder, lines, comparison, progress);
                    if (code == Batch.Done)
                        comparison.Execute(name, progress);
                    return code;
                }
            }
        }

        /// <summary>The setup of a command line.</summary>
        public static CrossSectionSetup SetupOf(CommandLine line,
            (RadarScene scene, SceneGatherer gatherer, string path, string name) opened, CrossSectionPlan plan)
        {
            var (scene, gatherer, path, _) = opened;
            var setup = new CrossSectionSetup(scene, plan)
            {
                ScenePath = path, Objects = gatherer.ObjectCount, Command = Batch.ArgumentsOf(line),
                PhaseCentre = PhaseCentreOf(line, scene),
                Polarisations = line.Get(CrossSectionOptions.Polarisations),
                ToleranceDb = line.Get(CrossSectionOptions.Tolerance),
                GivenFloorDbsm = line.Get(CrossSectionOptions.Floor),
                MaxBounces = line.Get(Options.Bounces),
                HasEdges = line.Get(CrossSectionOptions.Edges),
                Range = line.Get(CrossSectionOptions.Range) ?? double.PositiveInfinity,
                CreaseDegrees = line.Get(CrossSectionOptions.Crease),
                HasContributions = line.Get(CrossSectionOptions.Contributions),
                ObjectNames = Enumerable.Range(0, gatherer.ObjectCount)
                    .Select(number => LoadedScene.PathOf(gatherer.ObjectAt(number))).ToArray()
            };
            // While the device opens.
            setup.Begin();
            return setup;
        }

        /// <summary>The phase centre of a command line's scene, in the scene's frame.</summary>
        public static double3 PhaseCentreOf(CommandLine line, RadarScene scene)
        {
            // Files have an origin of their own; a scene's is arbitrary.
            if (line.InputKind != InputKind.Scene)
                return -scene.Origin;
            var (min, max) = scene.Bound();
            return (min + max) / 2;
        }

        /// <summary>Opens and gathers the scene or mesh file of a command line.</summary>
        /// <exception cref="GlintException">It cannot be opened.</exception>
        public static (RadarScene scene, SceneGatherer gatherer, string path, string name) OpenScene(CommandLine line)
        {
            string path = line.Input, name;
            if (line.InputKind == InputKind.Scene)
            {
                path = LoadedScene.OpenSceneFile(line.Input);
                name = Path.GetFileNameWithoutExtension(path);
            }
            else
                name = LoadedScene.OpenMeshFileAlone(line).Name;
            var gatherer = new SceneGatherer();
            var scene = gatherer.Gather(~0, new Transform[0], null);
            foreach (string warning in gatherer.Warnings)
                Debug.LogWarning($"{line.Input}: {warning}");
            if (line.Get(CrossSectionOptions.Material) is MaterialAssignment[] materials)
                scene = MaterialAssignment.Apply(scene, materials);
            return (scene, gatherer, path, name);
        }

        /// <summary>Warns of the rows of parts that were merged.</summary>
        public static void WarnOf(IReadOnlyList<StoredRow> rows, string name, double toleranceDb)
        {
            var warnings = new RowWarnings();
            foreach (var row in rows)
                warnings.Add(row);
            Warn(warnings, name, toleranceDb);
        }

        static void Warn(RowWarnings warnings, string name, double toleranceDb)
        {
            foreach (string warning in warnings.Of(name, toleranceDb,
                $"{CrossSectionOptions.Tolerance.Flag} or {CrossSectionOptions.Floor.Flag}"))
                Debug.LogWarning(warning);
        }

        static void Describe(CrossSectionSetup setup, string name, IProgressSink progress)
        {
            var centre = setup.Scene.Origin + setup.PhaseCentre;
            progress.Print(FormattableString.Invariant(
                $"phase centre ({centre.x:g6}, {centre.y:g6}, {centre.z:g6}) m, tolerance {setup.ToleranceDb:g4} dB, floor {setup.FloorDbsm:0.00} dBsm"));
            if (setup.Quality.IsOpen)
                progress.Print($"note: the mesh has {setup.Quality.OpenEdgeCount} open edges: open surfaces are thin "
                    + "conductors, lit from both sides");
            var (coatedEdges, length) = setup.CoatedEdges;
            if (coatedEdges > 0)
                progress.Print(FormattableString.Invariant(
                    $"note: {coatedEdges} edges, {length:g4} m in all, have no fringe fields: a face beside them is no perfect conductor"));
            foreach (string warning in setup.Warnings(name))
                Debug.LogWarning(warning);
        }

        static int Trace(CrossSectionRun run, CrossSectionSetup setup, string name, ResultsFolder folder,
            IRowLines lines, CrossSectionComparison comparison, IProgressSink progress)
        {
            int before = run.Done;
            if (before > 0)
                progress.Print(run.IsComplete
                    ? "already complete: nothing to do"
                    : FormattableString.Invariant($"resumed: {before} of {run.Count} rows are done"));
            var warnings = new RowWarnings();
            for (int row = 0; row < before; row++)
                warnings.Add(folder.Rows[row]);
            progress.Start(name, run.Count, before);
            try
            {
                while (!run.IsComplete && !progress.Cancel.IsCancellationRequested)
                {
                    var row = run.Step(progress, progress.Cancel);
                    if (run.Done == before + 1 && lines != null)
                        progress.Print(lines.Header);
                    warnings.Add(row);
                    comparison.Add(row);
                    string text = lines?.Add(row);
                    if (text != null)
                        progress.Print(text);
                    bool isLast = row.Planned.FrequencyIndex == setup.Plan.Frequencies.Count - 1;
                    if (text != null || lines == null && isLast || run.IsComplete)
                        progress.Advance(run.Done, run.Count == 1 ? null : row.ToString());
                }
            }
            finally
            {
                progress.Finish();
                if (!run.IsComplete && folder.Rows.Count > 0)
                    Debug.Log(FormattableString.Invariant(
                        $"{folder.Rows.Count} of {run.Count} rows are done and kept; the same command with {Options.Resume.Flag} continues"));
            }
            if (!run.IsComplete)
                return Batch.Cancelled;
            Warn(warnings, name, setup.ToleranceDb);
            if (run.Done > before)
                progress.Print($"written: {string.Join(", ", folder.WrittenPaths)}");
            return Batch.Done;
        }
    }

    /// <summary>What a command prints of its rows.</summary>
    interface IRowLines
    {
        /// <summary>Heading of the columns.</summary>
        string Header { get; }

        /// <summary>Takes the next row.</summary>
        /// <returns>The line that it completes; null for none.</returns>
        string Add(CrossSectionRow row);
    }

    /// <summary>The table that <c>glint rcs</c> prints, a line for each row.</summary>
    sealed class CrossSectionTable : IRowLines
    {
        readonly CrossSectionSetup _setup;

        public CrossSectionTable(CrossSectionSetup setup) => _setup = setup;

        public string Header => HeaderOf(_setup, _setup.Plan.Frequencies.Count > 1 ? "     frequency" : "")
            + string.Concat(_setup.Polarisations.Select(polarisation =>
                $"{polarisation.Name.ToUpperInvariant() + " dBsm",10}")) + "  error dB";

        public string Add(CrossSectionRow row) => DirectionOf(_setup, row, _setup.Plan.Frequencies.Count > 1
                ? FormattableString.Invariant($"  {row.Planned.Frequency,12:g6}")
                : "")
            + string.Concat(_setup.Polarisations.Select(polarisation => $"{Level(polarisation.Of(row.S)),10}"))
            + FormattableString.Invariant($"  {row.Accuracy.ErrorDb,8:0.000}") + (row.MeetsTolerance ? "" : " !");

        /// <summary>Heading of the directions, with another column between those of radar and receiver.</summary>
        public static string HeaderOf(CrossSectionSetup setup, string between) =>
            "azimuth  elevation" + between + (setup.Plan.IsBistatic ? "  received at" : "");

        /// <summary>The directions of a row.</summary>
        public static string DirectionOf(CrossSectionSetup setup, CrossSectionRow row, string between) =>
            FormattableString.Invariant($"{row.Planned.AzimuthDegrees,7:0.###}  {row.Planned.ElevationDegrees,9:0.###}")
            + between
            + (setup.Plan.IsBistatic
                ? FormattableString.Invariant($"  {row.Planned.ReceiverAzimuthDegrees,11:0.###}")
                : "");

        /// <summary>The level of an amplitude, dBsm.</summary>
        public static string Level(Complex amplitude) => amplitude == Complex.Zero
            ? "-"
            : FormattableString.Invariant($"{ScatteringMatrix.Dbsm(amplitude):0.000}");
    }
}
