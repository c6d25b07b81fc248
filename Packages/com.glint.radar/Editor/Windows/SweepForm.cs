using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Glint.Core;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>
    /// The form of a sweep of the open scene: the options of <c>glint sweep</c> as text, with the same parsers.
    /// </summary>
    [Serializable]
    sealed class SweepForm
    {
        /// <summary>The radar; null: the only one of the scene.</summary>
        public RadarController Radar;

        /// <summary>The object that turns, or about which the radar moves.</summary>
        public Transform Target;

        // FROM:TO:STEP or a list with commas, in the order of SweepAxis.All; empty where the axis is left alone.
        [SerializeField] string[] _lists = StandardLists();

        /// <summary>
        /// Results folder, relative to the project; empty: Results/&lt;scene&gt; beside Assets.
        /// </summary>
        public string Folder = "";

        /// <summary>Resume an unfinished sweep.</summary>
        public bool Resume;

        /// <summary>Chooses the only radar of the scene if none is chosen.</summary>
        public void FindRadar()
        {
            if (Radar != null)
                return;
            var all = UnityEngine.Object.FindObjectsByType<RadarController>(FindObjectsInactive.Exclude,
                FindObjectsSortMode.None);
            Radar = all.Length == 1 ? all[0] : null;
        }

        /// <summary>The text for an axis.</summary>
        public string this[SweepAxis axis] { get => Lists[axis.Index]; set => Lists[axis.Index] = value; }

        // A window may have been stored by a version with other axes.
        string[] Lists => _lists.Length == SweepAxis.All.Count ? _lists : _lists = StandardLists();

        static string[] StandardLists() =>
            SweepAxis.All.Select(axis => axis == SweepAxis.Angle ? "0:45:1" : "").ToArray();

        /// <summary>The command's error message for the text of an axis; null if it is valid.</summary>
        public string ProblemOf(SweepAxis axis)
        {
            if (!IsGiven(axis))
                return null;
            try
            {
                Options.Of(axis).ParseValue(this[axis]);
                return null;
            }
            catch (UsageException problem)
            {
                return problem.Message;
            }
        }

        /// <summary>The first error of the form; null if a sweep can begin.</summary>
        public string Problem()
        {
            try
            {
                RequireRadar();
                Batch.PlanOf(Line());
                _ = FolderPath;
                return null;
            }
            catch (GlintException problem)
            {
                return problem.Message;
            }
        }

        /// <summary>The results folder.</summary>
        /// <exception cref="GlintException">The text is not a path.</exception>
        public string FolderPath
        {
            get
            {
                try
                {
                    return string.IsNullOrWhiteSpace(Folder)
                        ? RunDescription.DefaultFolder(Name)
                        : RunDescription.InProject(Folder.Trim());
                }
                catch (ArgumentException error)
                {
                    throw new GlintException(
                        $"results folder {Values.Shown(Folder)}: {error.Message.TrimEnd('.')}: name another", error);
                }
            }
        }

        /// <summary>The folder and whether it holds an unfinished sweep, or its error.</summary>
        /// <param name="isRunning">Whether the current sweep writes into it.</param>
        public string FolderText(bool isRunning)
        {
            try
            {
                return !isRunning && File.Exists(Path.Combine(FolderPath, ResultsFolder.PartialName))
                    ? $"{FolderPath} holds a sweep that is not finished: Resume continues it, "
                        + "otherwise the first row replaces it."
                    : FolderPath;
            }
            catch (GlintException problem)
            {
                return problem.Message;
            }
        }

        /// <summary>Name of the radar's scene.</summary>
        public string Name =>
            Radar == null || string.IsNullOrEmpty(ScenePath) ? "Untitled" : Path.GetFileNameWithoutExtension(ScenePath);

        string ScenePath => Radar.gameObject.scene.path;

        /// <summary>The setup of the sweep.</summary>
        /// <exception cref="GlintException">The form is invalid; the message says why.</exception>
        public SweepSetup Setup()
        {
            RequireRadar();
            var line = Line();
            var setup = new SweepSetup(Radar, Batch.PlanOf(line))
            {
                Scene = ScenePath, Command = string.IsNullOrEmpty(ScenePath) ? null : Batch.ArgumentsOf(line)
            };
            if (line.IsGiven(Options.Target))
                setup.Target = Target;
            if (line.IsGiven(Options.Snapshots))
                setup.Sea = SceneSearch.FindSea($"scene '{Name}'");
            return setup;
        }

        void RequireRadar()
        {
            if (Radar == null)
                throw new GlintException("no radar: choose the RadarController of the scene, "
                    + "or add one to a camera (Glint > Radar Controller)");
            if (!Radar.isActiveAndEnabled)
                throw new GlintException($"RadarController of '{Radar.name}' is disabled or inactive: enable it");
        }

        // The equivalent command: it validates the form, and is stored with the results.
        CommandLine Line()
        {
            var words = new List<string>();
            foreach (var axis in SweepAxis.All.Reverse().Where(IsGiven))
                words.Add($"{Options.Of(axis).Flag}={this[axis].Trim()}");
            if (Target != null && Options.Target.Needs.Any(
                option => words.Any(word => word.StartsWith(option.Flag + "=", StringComparison.Ordinal))))
                words.Add($"{Options.Target.Flag}={LoadedScene.PathOf(Target)}");
            words.Add("--");
            words.Add(string.IsNullOrEmpty(ScenePath) ? "Untitled.unity" : ScenePath);
            return CommandLine.Parse(Commands.Sweep, words);
        }

        bool IsGiven(SweepAxis axis) => !string.IsNullOrWhiteSpace(this[axis]);
    }
}
