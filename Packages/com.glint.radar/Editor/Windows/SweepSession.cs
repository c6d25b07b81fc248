using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Threading;
using Glint.Core;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;
using UnityEngine.SceneManagement;
using Debug = UnityEngine.Debug;

namespace Glint.Editor
{
    /// <summary>
    /// A sweep, or a single pose, of the open scene, in edit mode or play mode: a pose a tick, with the files of the
    /// command. At its end everything that was moved is restored, also before scripts are reloaded, play mode changes,
    /// or the scene is saved or closed.
    /// </summary>
    sealed class SweepSession : IDisposable
    {
        readonly List<StoredRow> _rows = new List<StoredRow>();
        readonly CancellationTokenSource _cancel = new CancellationTokenSource();
        readonly Stopwatch _watch = Stopwatch.StartNew();
        readonly RadarController _radar;
        readonly int _before;
        readonly ResultsFolder _folder;
        SweepRun _run;
        string _reason;
        bool _isTracing;

        SweepSession(SweepSetup setup, string folder, bool resume)
        {
            _radar = setup.Radar;
            FolderPath = folder;
            try
            {
                LoadedScene.RebuildSeas();
                // The division into rigid groups depends on motion seen before. Without that history the rows are those
                // of the command.
                _radar.Release();
                _folder = folder == null ? null : ResultsFolder.Open(folder);
                _run = new SweepRun(setup, _folder, null, resume);
            }
            catch
            {
                PutBack();
                throw;
            }
            Count = _run.Count;
            Done = _before = _run.Done;
            if (_folder != null)
                _rows.AddRange(_folder.Rows);
            AssemblyReloadEvents.beforeAssemblyReload += EndBeforeReload;
            EditorApplication.playModeStateChanged += EndBeforePlayMode;
            EditorSceneManager.sceneSaving += EndBeforeSaving;
            EditorSceneManager.sceneClosing += EndBeforeClosing;
            if (_run.IsComplete)
                End(null);
        }

        /// <summary>Begins a sweep; the first tick traces its first pose.</summary>
        /// <exception cref="GlintException">It cannot begin; the scene is unchanged.</exception>
        public static SweepSession Sweep(SweepForm form)
        {
            foreach (var other in UnityEngine.Object.FindObjectsByType<Glint.Sweep>(FindObjectsInactive.Exclude,
                FindObjectsSortMode.None))
                if (other.IsRunning)
                    throw new GlintException($"the Sweep of '{other.name}' is sweeping this scene: "
                        + "wait for its end, or disable it");
            return new SweepSession(form.Setup(), form.FolderPath, form.Resume);
        }

        /// <summary>One pose of the scene in its current state, without files.</summary>
        /// <exception cref="GlintException">It cannot be traced.</exception>
        public static SweepSession Pose(RadarController radar) =>
            new SweepSession(new SweepSetup(radar, SweepPlan.Single), null, false);

        /// <summary>Number of poses, and of those done, including those before a resumption.</summary>
        public int Count { get; }

        /// <inheritdoc cref="Count"/>
        public int Done { get; private set; }

        /// <summary>The rows so far.</summary>
        public IReadOnlyList<StoredRow> Rows => _rows;

        /// <summary>Whether the radar's view is traced for each pose.</summary>
        public bool Looks { get; set; }

        /// <summary>The last radar's view; null for none.</summary>
        public RadarPreview Preview { get; private set; }

        /// <summary>The results folder; null for a single pose.</summary>
        public string FolderPath { get; }

        /// <summary>Whether poses remain.</summary>
        public bool IsRunning => _run != null;

        /// <summary>Why it ended early; null while it runs and if it is complete.</summary>
        public string Problem { get; private set; }

        /// <summary>Estimated remaining seconds; null before the first pose.</summary>
        public double? SecondsLeft =>
            Done > _before ? _watch.Elapsed.TotalSeconds / (Done - _before) * (Count - Done) : (double?)null;

        /// <summary>A line about the progress.</summary>
        public string Status()
        {
            string count = FormattableString.Invariant($"{Done} of {Count} poses");
            if (IsRunning)
                return SecondsLeft is double left ? FormattableString.Invariant($"{count}, {left:0} s left") : count;
            return Done == Count ? count : $"{count} are done and kept; Resume continues";
        }

        /// <summary>Traces the next pose.</summary>
        /// <param name="progress">
        /// Receives the fraction of the pose done, 0 to 1; may be null. It may call <see cref="Cancel"/>.
        /// </param>
        public void Tick(IProgress<double> progress = null)
        {
            if (!IsRunning || _isTracing)
                return;
            _isTracing = true;
            try
            {
                if (_radar == null)
                    throw new GlintException("the radar of the sweep was destroyed: it must stay until the last pose");
                // A look needs the scene of the row.
                _run.PosesAhead = Looks ? 0 : 1;
                var row = _run.Step(progress, _cancel.Token);
                Done = _run.Done;
                _rows.Add(new StoredRow(row));
                if (Looks)
                    Preview = RadarPreview.Of(_radar, _cancel.Token);
                if (_run.IsComplete)
                    End(null);
                else if (_cancel.IsCancellationRequested)
                    End(_reason);
            }
            catch (OperationCanceledException)
            {
                End(_reason);
            }
            catch (GlintException problem)
            {
                End(problem.Message);
            }
            catch (Exception fault)
            {
                End($"{fault.GetType().Name}: {fault.Message}");
                Debug.LogException(fault);
            }
            finally
            {
                _isTracing = false;
            }
        }

        /// <summary>
        /// Cancels the current pose and the sweep; the rows stay.
        /// Between two poses everything is restored when this returns.
        /// </summary>
        public void Cancel() => Stop("cancelled");

        /// <summary>Same as <see cref="Cancel"/>.</summary>
        public void Dispose() => Stop("cancelled");

        void Stop(string reason)
        {
            _reason = reason;
            _cancel.Cancel();
            if (!_isTracing && IsRunning)
                End(reason);
        }

        void End(string problem)
        {
            Problem = problem;
            AssemblyReloadEvents.beforeAssemblyReload -= EndBeforeReload;
            EditorApplication.playModeStateChanged -= EndBeforePlayMode;
            EditorSceneManager.sceneSaving -= EndBeforeSaving;
            EditorSceneManager.sceneClosing -= EndBeforeClosing;
            PutBack();
        }

        void PutBack()
        {
            _run?.Dispose();
            _folder?.Dispose();
            _run = null;
            // In play mode the radar keeps its buffers for the next pose until it is destroyed.
            if (_radar != null && !Application.isPlaying)
                _radar.Release();
        }

        void EndBeforeReload() => Stop("ended: scripts are reloaded");

        void EndBeforePlayMode(PlayModeStateChange change) => Stop("ended: play mode begins or ends");

        // The scene is restored before it is saved.
        void EndBeforeSaving(Scene scene, string path) => Stop("ended: the scene is saved");

        void EndBeforeClosing(Scene scene, bool isRemoved) => Stop("ended: the scene is closed");
    }
}
