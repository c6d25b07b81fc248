using System;
using Glint.Core;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// Sweeps when the scene is played: turns the target from angle to angle, or the sea from snapshot to snapshot, one pose a frame, and writes the same files as the command.
    /// When done it stops and puts the target's rotation and the sea's snapshot back.
    /// </summary>
    [AddComponentMenu("Glint/Sweep")]
    [DisallowMultipleComponent]
    public sealed class Sweep : MonoBehaviour
    {
        [SerializeField, Tooltip("The radar that traces. Empty: the one of the scene.")]
        RadarController _radar;

        [SerializeField, Tooltip("What is turned about the vertical through its own position. Empty: nothing, and the angles do not matter.")]
        Transform _target;

        [SerializeField, Tooltip("Degrees, positive as Unity's rotation about Y: FROM:TO:STEP, FROM and (when whole steps reach it) TO included, or a list with commas.")]
        string _angles = "0:45:1";

        [SerializeField, Tooltip("Snapshots of the scene's Sea, from 1: FROM:TO, both included, FROM:TO:STEP or a list with commas; every angle is traced for each. Empty: the sea stays as it is.")]
        string _snapshots = "";

        [SerializeField, Tooltip("Folder for results.csv and results.json, relative to the project. Empty: Results/<scene> beside Assets.")]
        string _outputFolder = "";

        readonly LogProgress _progress = new LogProgress();
        SweepRun _run;

        /// <summary>The radar that traces; null: the one of the scene.</summary>
        public RadarController Radar { get => _radar; set => _radar = value; }

        /// <summary>What is turned; null: nothing.</summary>
        public Transform Target { get => _target; set => _target = value; }

        /// <summary>Degrees: FROM:TO:STEP or a list with commas.</summary>
        public string Angles { get => _angles; set => _angles = value; }

        /// <summary>Snapshots of the scene's sea, from 1: FROM:TO, FROM:TO:STEP or a list with commas; empty: it stays as it is.</summary>
        public string Snapshots { get => _snapshots; set => _snapshots = value; }

        /// <summary>Folder for the result files, relative to the project; empty: Results/&lt;scene&gt; beside Assets.</summary>
        public string OutputFolder { get => _outputFolder; set => _outputFolder = value; }

        /// <summary>True from the first pose until all are traced and written.</summary>
        public bool IsRunning => _run != null;

        /// <summary>Who looks for a radar or a sea, in messages.</summary>
        internal string Searcher => $"scene of Sweep '{name}'";

        bool HasSnapshots => !string.IsNullOrWhiteSpace(_snapshots);

        /// <summary>The poses.</summary>
        /// <exception cref="GlintException">There is nothing to sweep, angles or snapshots are malformed, or there are too many.</exception>
        internal SweepPlan Plan()
        {
            if (_target == null && !HasSnapshots)
                throw new GlintException($"Sweep of '{name}' has no target and no snapshots: assign the object to turn to its field Target, or write the snapshots of the scene's Sea, such as 1:10, into its field Snapshots");
            return new SweepPlan(_target == null ? null : Glint.Core.Angles.Parse(_angles), HasSnapshots ? Glint.Core.Snapshots.Parse(_snapshots) : null);
        }

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
            var folder = ResultsFolder.Open(string.IsNullOrEmpty(_outputFolder) ? RunDescription.DefaultFolder(scene) : RunDescription.InProject(_outputFolder));
            _run = new SweepRun(new SweepSetup(_radar, plan) { Target = _target, Sea = sea, Scene = gameObject.scene.path }, folder);
            _progress.Start(scene, plan.Count);
        }

        void Continue()
        {
            var row = _run.Step();
            _progress.Advance(_run.Done, FormattableString.Invariant($"{row.Pose}, amplitude {row.Result.Amplitude:g6}"));
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
