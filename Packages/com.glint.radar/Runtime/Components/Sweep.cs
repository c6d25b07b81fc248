using System;
using System.Linq;
using Glint.Core;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// Sweeps when the scene is played: turns the target, moves the radar about it, steps through frequencies or the
    /// sea's snapshots, one pose a frame, and writes the files of the command. At the end it restores everything.
    /// </summary>
    [AddComponentMenu("Glint/Sweep")]
    [HelpPage("editor.md")]
    [DisallowMultipleComponent]
    public sealed class Sweep : MonoBehaviour
    {
        [SerializeField, Tooltip("The radar that traces. Empty: the scene's radar.")]
        RadarController _radar;

        [SerializeField, Tooltip("Object that turns about the vertical through its own position, and that the radar "
            + "moves about. Empty: none, and the angles are ignored.")]
        Transform _target;

        [SerializeField,
            Tooltip("Degrees, positive as Unity's rotation about Y: FROM:TO:STEP, FROM and (when whole steps reach it) "
                + "TO included, or a list with commas. Empty, beside another list: the target is not turned.")]
        string _angles = "0:45:1";

        [SerializeField, Tooltip("Grazing angles, degrees: a range or list as for the angles. The radar moves about "
            + "the point of its view axis nearest to the target. Empty: unchanged.")]
        string _grazingAngles = "";

        [SerializeField, Tooltip("Distances from the radar to that point, metres: a range or list. Empty: unchanged.")]
        string _distances = "";

        [SerializeField, Tooltip("Carrier frequencies, hertz: a range or list. Empty: the radar's.")]
        string _frequencies = "";

        [SerializeField, Tooltip("Snapshots of the scene's Sea, from 1: FROM:TO, both included, "
            + "FROM:TO:STEP or a list with commas; everything else is traced for each. Empty: the sea is unchanged.")]
        string _snapshots = "";

        [SerializeField, Tooltip("Folder for results.csv and results.json, relative to the project, in a player to "
            + "Application.persistentDataPath. Empty: Results/<scene>.")]
        string _outputFolder = "";

        readonly LogProgress _progress = new LogProgress();
        SweepRun _run;

        /// <summary>The radar; null: the only one of the scene.</summary>
        public RadarController Radar { get => _radar; set => _radar = value; }

        /// <summary>The object that turns, and about which the radar moves; may be null.</summary>
        public Transform Target { get => _target; set => _target = value; }

        /// <summary>
        /// Turns of the target, degrees: FROM:TO:STEP or a list with commas. Empty, with another list: not swept.
        /// </summary>
        public string Angles { get => _angles; set => _angles = value; }

        /// <summary>
        /// Angles by which the radar looks down, degrees: FROM:TO:STEP or a list with commas; empty: not swept.
        /// </summary>
        public string GrazingAngles { get => _grazingAngles; set => _grazingAngles = value; }

        /// <summary>
        /// Distances from the radar to the point about which it moves, metres: FROM:TO:STEP or a list with commas;
        /// empty: not swept.
        /// </summary>
        public string Distances { get => _distances; set => _distances = value; }

        /// <summary>Carrier frequencies, hertz: FROM:TO:STEP or a list with commas; empty: not swept.</summary>
        public string Frequencies { get => _frequencies; set => _frequencies = value; }

        /// <summary>
        /// Snapshots of the scene's sea, from 1: FROM:TO, FROM:TO:STEP or a list with commas; empty: not swept.
        /// </summary>
        public string Snapshots { get => _snapshots; set => _snapshots = value; }

        /// <summary>
        /// Folder for the result files, relative to the project or, in a player, to Application.persistentDataPath;
        /// empty: Results/&lt;scene&gt;.
        /// </summary>
        public string OutputFolder { get => _outputFolder; set => _outputFolder = value; }

        /// <summary>True from the first pose until all poses are written.</summary>
        public bool IsRunning => _run != null;

        /// <summary>Poses of the sweep last begun; 0 before it.</summary>
        public int Poses { get; private set; }

        /// <summary>Poses of this sweep that are done.</summary>
        public int PosesDone { get; private set; }

        /// <summary>Folder of its result files; null before it.</summary>
        public string ResultsPath { get; private set; }

        /// <summary>Why the sweep could not begin or continue; null if nothing was wrong.</summary>
        public string Problem { get; private set; }

        /// <summary>Name for messages of searches for a radar or a sea.</summary>
        public string Searcher => $"scene of Sweep '{name}'";

        // In the order of SweepAxis.All.
        string ListOf(SweepAxis axis) =>
            new[] { _snapshots, _frequencies, _distances, _grazingAngles, _angles }[axis.Index];

        bool IsGiven(SweepAxis axis) => !string.IsNullOrWhiteSpace(ListOf(axis));

        /// <summary>The poses.</summary>
        /// <exception cref="GlintException">
        /// There is nothing to sweep, a list is malformed, or there are too many poses.
        /// </exception>
        public SweepPlan Plan()
        {
            bool hasOthers = SweepAxis.All.Any(axis => axis != SweepAxis.Angle && IsGiven(axis));
            if (_target == null && (IsGiven(SweepAxis.Grazing) || IsGiven(SweepAxis.Range)))
                throw new GlintException($"Sweep of '{name}' has grazing angles or distances and no target: "
                    + "assign the object that the radar is to be moved about to its field Target");
            if (_target == null && !hasOthers)
                throw new GlintException($"Sweep of '{name}' has no target and no snapshots: "
                    + "assign the object to turn to its field Target, or write the snapshots of the scene's Sea, "
                    + "such as 1:10, into its field Snapshots");
            bool turns = _target != null && (IsGiven(SweepAxis.Angle) || !hasOthers);
            return new SweepPlan(axis =>
                (axis == SweepAxis.Angle ? turns : IsGiven(axis)) ? axis.Parse(ListOf(axis)) : null);
        }

        /// <summary>The sea whose snapshots are swept; null if none are.</summary>
        /// <exception cref="GlintException">The scene has no sea, or several.</exception>
        public Sea FindSea() => IsGiven(SweepAxis.Snapshot) ? SceneSearch.FindSea(Searcher) : null;

        // In the editor, when the component is added or reset. What is not clear stays empty.
        void Reset()
        {
            var radars = Array.FindAll(
                FindObjectsByType<RadarController>(FindObjectsInactive.Include, FindObjectsSortMode.None),
                radar => radar.gameObject.scene == gameObject.scene);
            _radar = radars.Length == 1 ? radars[0] : null;
            _target = _radar != null && _radar.Roots.Count == 1 ? _radar.Roots[0] : null;
        }

        void Start() => Attempt(Begin);

        void Update()
        {
            if (_run != null)
                Attempt(Continue);
        }

        void OnDisable() => End();

        void Begin()
        {
            // Where Play does not reload the scene, those of the Play before are still there.
            (Problem, ResultsPath, Poses, PosesDone) = (null, null, 0, 0);
            var plan = Plan();
            if (_radar == null)
                _radar = SceneSearch.FindRadar(Searcher);
            var sea = FindSea();
            string scene = RunDescription.SceneOf(this);
            var folder = ResultsFolder.Open(string.IsNullOrEmpty(_outputFolder)
                ? RunDescription.DefaultFolder(scene)
                : RunDescription.InProject(_outputFolder));
            _run = new SweepRun(
                new SweepSetup(_radar, plan) { Target = _target, Sea = sea, Scene = gameObject.scene.path }, folder)
            {
                PosesAhead = 1
            };
            (Poses, ResultsPath) = (plan.Count, folder.FolderPath);
            _progress.Start(scene, plan.Count);
        }

        void Continue()
        {
            var row = _run.Step();
            PosesDone = _run.Done;
            _progress.Advance(_run.Done,
                FormattableString.Invariant($"{row.Pose}, amplitude {row.Result.Amplitude:g6}"));
            if (_run.IsComplete)
                End();
        }

        void End()
        {
            _run?.Dispose();
            _run = null;
        }

        // A sweep that cannot continue reports why and stops; its rows are kept.
        void Attempt(Action step)
        {
            try
            {
                step();
            }
            catch (GlintException problem)
            {
                End();
                Problem = problem.Message;
                Debug.LogError(Problem, this);
            }
            catch (Exception fault)
            {
                End();
                Problem = fault.Message;
                Debug.LogException(fault, this);
            }
        }
    }
}
