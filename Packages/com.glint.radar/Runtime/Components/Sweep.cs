using System;
using Glint.Core;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// Sweeps when the scene is played: turns the target from angle to angle, moves the radar about it,
    /// steps through frequencies or the sea's snapshots, one pose a frame, and writes the same files as the command.
    /// When done it stops and puts everything back.
    /// </summary>
    [AddComponentMenu("Glint/Sweep")]
    [DisallowMultipleComponent]
    public sealed class Sweep : MonoBehaviour
    {
        [SerializeField, Tooltip("The radar that traces. Empty: the one of the scene.")]
        RadarController _radar;

        [SerializeField, Tooltip("What is turned about the vertical through its own position, "
            + "and the radar moved about. Empty: nothing, and the angles do not matter.")]
        Transform _target;

        [SerializeField,
            Tooltip("Degrees, positive as Unity's rotation about Y: FROM:TO:STEP, FROM and (when whole steps reach it) "
                + "TO included, or a list with commas. Empty, beside another list: the target is not turned.")]
        string _angles = "0:45:1";

        [SerializeField, Tooltip("How far the radar looks down, degrees: a range or list as for the angles. It is "
            + "moved about the point of its view axis that is nearest to the target. Empty: it stays where it is.")]
        string _grazingAngles = "";

        [SerializeField, Tooltip("From the radar to that point, metres: a range or list. Empty: as it is.")]
        string _distances = "";

        [SerializeField, Tooltip("Carrier frequencies, hertz: a range or list. Empty: the radar's.")]
        string _frequencies = "";

        [SerializeField, Tooltip("Snapshots of the scene's Sea, from 1: FROM:TO, both included, "
            + "FROM:TO:STEP or a list with commas; everything else is traced for each. Empty: the sea stays as it is.")]
        string _snapshots = "";

        [SerializeField, Tooltip("Folder for results.csv and results.json, relative to the project. Empty: "
            + "Results/<scene> beside Assets.")]
        string _outputFolder = "";

        readonly LogProgress _progress = new LogProgress();
        SweepRun _run;

        /// <summary>The radar that traces; null: the one of the scene.</summary>
        public RadarController Radar { get => _radar; set => _radar = value; }

        /// <summary>What is turned, and the radar moved about; null: nothing.</summary>
        public Transform Target { get => _target; set => _target = value; }

        /// <summary>
        /// Degrees: FROM:TO:STEP or a list with commas; empty beside another list: the target is not turned.
        /// </summary>
        public string Angles { get => _angles; set => _angles = value; }

        /// <summary>
        /// How far the radar looks down, degrees: FROM:TO:STEP or a list with commas; empty: as it does.
        /// </summary>
        public string GrazingAngles { get => _grazingAngles; set => _grazingAngles = value; }

        /// <summary>
        /// From the radar to the point that it is moved about, metres:
        /// FROM:TO:STEP or a list with commas; empty: as it is.
        /// </summary>
        public string Distances { get => _distances; set => _distances = value; }

        /// <summary>Carrier frequencies, hertz: FROM:TO:STEP or a list with commas; empty: the radar's.</summary>
        public string Frequencies { get => _frequencies; set => _frequencies = value; }

        /// <summary>
        /// Snapshots of the scene's sea, from 1: FROM:TO, FROM:TO:STEP or a list with commas; empty: it stays as it is.
        /// </summary>
        public string Snapshots { get => _snapshots; set => _snapshots = value; }

        /// <summary>
        /// Folder for the result files, relative to the project; empty: Results/&lt;scene&gt; beside Assets.
        /// </summary>
        public string OutputFolder { get => _outputFolder; set => _outputFolder = value; }

        /// <summary>True from the first pose until all are traced and written.</summary>
        public bool IsRunning => _run != null;

        /// <summary>Who looks for a radar or a sea, in messages.</summary>
        internal string Searcher => $"scene of Sweep '{name}'";

        bool HasSnapshots => IsGiven(_snapshots);

        bool MovesRadar => IsGiven(_grazingAngles) || IsGiven(_distances);

        /// <summary>The poses.</summary>
        /// <exception cref="GlintException">
        /// There is nothing to sweep, a list is malformed, or there are too many poses.
        /// </exception>
        internal SweepPlan Plan()
        {
            bool hasOthers = HasSnapshots || IsGiven(_frequencies) || MovesRadar;
            if (_target == null && MovesRadar)
                throw new GlintException($"Sweep of '{name}' has grazing angles or distances and no target: "
                    + "assign the object that the radar is to be moved about to its field Target");
            if (_target == null && !hasOthers)
                throw new GlintException($"Sweep of '{name}' has no target and no snapshots: "
                    + "assign the object to turn to its field Target, or write the snapshots of the scene's Sea, "
                    + "such as 1:10, into its field Snapshots");
            return new SweepPlan(
                (SweepAxis.Angle,
                    _target != null && (IsGiven(_angles) || !hasOthers) ? Glint.Core.Angles.Parse(_angles) : null),
                (SweepAxis.Grazing, Values(SweepLists.GrazingAngles, _grazingAngles, "grazing angles")),
                (SweepAxis.Range, Values(SweepLists.Distances, _distances, "distances")),
                (SweepAxis.Frequency, Values(SweepLists.Frequencies, _frequencies, "frequencies")),
                (SweepAxis.Snapshot, HasSnapshots ? Array.ConvertAll(Glint.Core.Snapshots.Parse(_snapshots),
                    number => (double)number) : null));
        }

        static bool IsGiven(string list) => !string.IsNullOrWhiteSpace(list);

        static double[] Values(NumberList numbers, string list, string where) =>
            IsGiven(list) ? numbers.Parse(list, where) : null;

        /// <summary>Whose snapshots are shown; null when none are.</summary>
        /// <exception cref="GlintException">The scene has no sea, or several.</exception>
        internal Sea FindSea() => HasSnapshots ? SceneSearch.FindSea(Searcher) : null;

        void Start() => Attempt(Begin);

        void Update()
        {
            if (_run != null)
                Attempt(Continue);
        }

        void OnDisable() => End();

        void Begin()
        {
            var plan = Plan();
            if (_radar == null)
                _radar = SceneSearch.FindRadar(Searcher);
            var sea = FindSea();
            string scene = gameObject.scene.name;
            var folder = ResultsFolder.Open(string.IsNullOrEmpty(_outputFolder)
                ? RunDescription.DefaultFolder(scene)
                : RunDescription.InProject(_outputFolder));
            _run = new SweepRun(
                new SweepSetup(_radar, plan) { Target = _target, Sea = sea, Scene = gameObject.scene.path }, folder);
            _progress.Start(scene, plan.Count);
        }

        void Continue()
        {
            var row = _run.Step();
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

        // A sweep that cannot go on says why, once, and stops; the rows written are kept.
        void Attempt(Action step)
        {
            try
            {
                step();
            }
            catch (GlintException problem)
            {
                End();
                Debug.LogError(problem.Message, this);
            }
            catch (Exception fault)
            {
                End();
                Debug.LogException(fault, this);
            }
        }
    }
}
