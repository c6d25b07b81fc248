using System;
using System.IO;
using System.Linq;
using System.Numerics;
using Glint.Core;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary><c>glint rcs</c>: cross sections of a scene or a mesh file.</summary>
    static class CrossSectionCommand
    {
        public static int Execute(CommandLine line, IProgressSink progress)
        {
            var plan = CrossSectionOptions.PlanOf(line);
            var (setup, name) = Open(line, plan);
            string path = line.IsGiven(CrossSectionOptions.Out)
                ? Path.GetFullPath(line.Get(CrossSectionOptions.Out))
                : RunDescription.DefaultFolder(name, ResultTable.CrossSection);
            using (var folder = ResultsFolder.Open(path, ResultTable.CrossSection))
            {
                Batch.WarnOfUnfinished(line, folder);
                using (var run = new CrossSectionRun(setup, ProjectAssets.TubesKernel, folder,
                    line.Get(Options.Shard), line.Get(Options.Resume)))
                {
                    if (!run.IsComplete)
                        Describe(setup, name, progress);
                    var comparison = new CrossSectionComparison(setup, line.Get(CrossSectionOptions.Reference));
                    int code = Trace(run, setup, name, folder, comparison, progress);
                    if (code == Batch.Done)
                        comparison.Execute(name, progress);
                    return code;
                }
            }
        }

        static (CrossSectionSetup setup, string name) Open(CommandLine line, CrossSectionPlan plan)
        {
            var (scene, gatherer, path, name) = OpenScene(line);
            var setup = new CrossSectionSetup(scene, plan)
            {
                ScenePath = path, Objects = gatherer.ObjectCount, Command = Batch.ArgumentsOf(line),
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
            // Files have an origin of their own; a scene's is arbitrary.
            setup.PhaseCentre = line.InputKind == InputKind.Scene ? setup.BoxCentre : -scene.Origin;
            return (setup, name);
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

        static void Describe(CrossSectionSetup setup, string name, IProgressSink progress)
        {
            var centre = setup.Scene.Origin + setup.PhaseCentre;
            progress.Print(FormattableString.Invariant(
                $"phase centre ({centre.x:g6}, {centre.y:g6}, {centre.z:g6}) m, tolerance {setup.ToleranceDb:g4} dB, floor {setup.FloorDbsm:0.00} dBsm"));
            if (setup.Quality.IsOpen)
                progress.Print($"note: the mesh has {setup.Quality.OpenEdgeCount} open edges: open surfaces are thin "
                    + "conductors, lit from both sides");
            if (setup.CoarseMeshWarning(name) is string warning)
                Debug.LogWarning(warning);
        }

        static int Trace(CrossSectionRun run, CrossSectionSetup setup, string name, ResultsFolder folder,
            CrossSectionComparison comparison, IProgressSink progress)
        {
            int before = run.Done;
            if (before > 0)
                progress.Print(run.IsComplete
                    ? "already complete: nothing to do"
                    : FormattableString.Invariant($"resumed: {before} of {run.Count} rows are done"));
            var unmet = new UnmetRows();
            progress.Start(name, run.Count);
            try
            {
                if (before > 0)
                    progress.Advance(before, null);
                while (!run.IsComplete && !progress.Cancel.IsCancellationRequested)
                {
                    var row = run.Step(progress, progress.Cancel);
                    if (run.Done == before + 1)
                        progress.Print(CrossSectionTable.Header(setup));
                    progress.Print(CrossSectionTable.Row(setup, row));
                    unmet.Add(row);
                    comparison.Add(row);
                    progress.Advance(run.Done, run.Count == 1 ? null : row.ToString());
                }
            }
            finally
            {
                progress.Finish();
                if (!run.IsComplete && run.Done > 0)
                    Debug.Log(FormattableString.Invariant(
                        $"{run.Done} of {run.Count} rows are done and kept; the same command with {Options.Resume.Flag} continues"));
            }
            if (!run.IsComplete)
                return Batch.Cancelled;
            unmet.Warn(name, setup.ToleranceDb, run.Count - before);
            if (run.Done > before)
                progress.Print($"written: {string.Join(", ", folder.WrittenPaths)}");
            return Batch.Done;
        }

        // Rows whose error remained above the tolerance.
        sealed class UnmetRows
        {
            CrossSectionRow _worst;
            int _count, _outside;

            public void Add(CrossSectionRow row)
            {
                _outside += row.IsOutsidePhysicalOptics ? 1 : 0;
                if (row.MeetsTolerance)
                    return;
                _count++;
                if (_worst == null || row.Accuracy.ErrorDb > _worst.Accuracy.ErrorDb)
                    _worst = row;
            }

            public void Warn(string name, double toleranceDb, int rows)
            {
                if (_count > 0)
                    Debug.LogWarning(FormattableString.Invariant(
                        $"{name}: the tolerance of {toleranceDb:g4} dB was not met in {_count} of {rows} rows (column tolerance_met): the largest standard error reached is {_worst.Accuracy.ErrorDb:g3} dB, at {_worst}; accept it, or ask for a larger {CrossSectionOptions.Tolerance.Flag} or {CrossSectionOptions.Floor.Flag}"));
                if (_outside > 0)
                    Debug.LogWarning(FormattableString.Invariant(
                        $"{name}: {_outside} of {rows} rows are outside physical optics, with radar and receiver more than {CrossSectionRow.MaxBistaticDegrees:0} degrees apart (column outside_physical_optics)"));
            }
        }
    }

    /// <summary>The table that <c>glint rcs</c> prints, a line for each row.</summary>
    static class CrossSectionTable
    {
        /// <summary>Heading of the columns.</summary>
        public static string Header(CrossSectionSetup setup) => "azimuth  elevation"
            + (setup.Plan.Frequencies.Count > 1 ? "     frequency" : "")
            + (setup.Plan.IsBistatic ? "  received at" : "")
            + string.Concat(setup.Polarisations.Select(polarisation =>
                $"{polarisation.Name.ToUpperInvariant() + " dBsm",10}")) + "  error dB";

        /// <summary>The line of a row.</summary>
        public static string Row(CrossSectionSetup setup, CrossSectionRow row) =>
            FormattableString.Invariant($"{row.Planned.AzimuthDegrees,7:0.###}  {row.Planned.ElevationDegrees,9:0.###}")
            + (setup.Plan.Frequencies.Count > 1 ? FormattableString.Invariant($"  {row.Planned.Frequency,12:g6}") : "")
            + (setup.Plan.IsBistatic
                ? FormattableString.Invariant($"  {row.Planned.ReceiverAzimuthDegrees,11:0.###}")
                : "")
            + string.Concat(setup.Polarisations.Select(polarisation =>
                $"{Level(polarisation.Of(row.S)),10}"))
            + FormattableString.Invariant($"  {row.Accuracy.ErrorDb,8:0.000}") + (row.MeetsTolerance ? "" : " !");

        static string Level(Complex amplitude) => amplitude == Complex.Zero
            ? "-"
            : FormattableString.Invariant($"{ScatteringMatrix.Dbsm(amplitude):0.000}");
    }
}
