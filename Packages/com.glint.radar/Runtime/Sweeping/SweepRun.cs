using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Threading;
using Glint.Core;

namespace Glint
{
    /// <summary>
    /// A sweep: applies a pose, traces it and writes its row, step by step. Disposing restores the scene.
    /// Play mode takes one step a frame; the commands loop.
    /// </summary>
    public sealed class SweepRun : IDisposable
    {
        readonly SweepSetup _setup;
        readonly AxisDrivers _motions;
        readonly int _first;
        readonly ResultsFolder _folder;
        readonly DateTime _startedUtc = DateTime.UtcNow;
        readonly Stopwatch _watch = Stopwatch.StartNew();
        SweepIdentity _identity;
        readonly List<PoseInFlight> _started = new List<PoseInFlight>(); // the pose of the next step, and those after it

        /// <summary>
        /// Begins or resumes a sweep; nothing is traced before the first <see cref="Step"/>.
        /// </summary>
        /// <param name="setup">Must not change while the sweep runs.</param>
        /// <param name="folder">
        /// Receives the rows, and is released with the run, also if it is refused; null: nothing is written.
        /// </param>
        /// <param name="shard">The part to trace; null: all of it.</param>
        /// <param name="resume">Resumes the same sweep in the folder.</param>
        /// <exception cref="GlintException">
        /// An axis cannot be applied: the sea has no such snapshot, the radar cannot move about the target. Or the
        /// folder holds another sweep.
        /// </exception>
        public SweepRun(SweepSetup setup, ResultsFolder folder = null, SweepShard? shard = null, bool resume = false)
        {
            _setup = setup;
            _folder = folder;
            int poses = setup.Plan.Count;
            _first = shard?.First(poses) ?? 0;
            Count = (shard?.End(poses) ?? poses) - _first;
            try
            {
                _motions = new AxisDrivers(setup);
                if (setup.Plan == SweepPlan.Single)
                    return;
                Rehearse();
                if (folder != null)
                    Begin(RunDescription.IdentityOf(setup), shard, resume);
            }
            catch
            {
                _folder?.Dispose();
                _motions?.Dispose();
                throw;
            }
        }

        /// <summary>Number of poses of the plan, or of the part.</summary>
        public int Count { get; }

        /// <summary>Number of poses done, including those before a resumption.</summary>
        public int Done { get; private set; }

        /// <summary>
        /// Poses that are gathered before the row of the current one is made, at most: one is given to the device; with a
        /// tolerance as many as a GPU traces together. The sweep is faster, and after a <see cref="Step"/> the scene shows
        /// one of them. Poses do not overlap while a script listens to <see cref="RadarController.Traced"/>, or when single
        /// rays are kept.
        /// </summary>
        public int PosesAhead { get; set; }

        /// <summary>When the row of the last pose was written, since the run began.</summary>
        public TimeSpan RowWritten { get; private set; }

        /// <summary>Time spent on writing rows.</summary>
        public TimeSpan Writing { get; private set; }

        /// <summary>True if all poses are done.</summary>
        public bool IsComplete => Done == Count;

        /// <summary>Traces the next pose and writes its row; after the last pose it writes results.json.</summary>
        /// <param name="progress">Receives the fraction of the pose done, 0 to 1; may be null.</param>
        /// <param name="cancel">Cancels the pose.</param>
        /// <param name="readback">Rays that the row's result carries.</param>
        /// <exception cref="GlintException">
        /// The pose cannot be traced, or its row cannot be written; earlier rows are kept.
        /// </exception>
        /// <exception cref="OperationCanceledException">
        /// The pose was cancelled; earlier rows are kept, and the next step traces it again.
        /// </exception>
        public SweepRow Step(IProgress<double> progress = null, CancellationToken cancel = default,
            RayReadback readback = RayReadback.None)
        {
            var radar = _setup.Radar;
            if (radar == null)
                throw new GlintException("the radar of the sweep was destroyed: it must stay until the last pose");
            bool isStarted = _started.Count > 0 && radar.IsInFlight(_started[0]) && _started[0].Readback == readback;
            if (!isStarted)
            {
                Abandon();
                Start(readback, cancel);
            }
            while (_started.Count <= PosesAhead && Done + _started.Count < Count
                && radar.MayOverlap(_started[0], _started.Count) && StartsNext(cancel))
            {
            }
            SweepRow row;
            try
            {
                row = new SweepRow(_setup.Plan[_first + Done], radar.FinishTrace(_started[0], progress, cancel));
                var begin = _watch.Elapsed;
                _folder?.Append(row);
                RowWritten = _watch.Elapsed;
                Writing += RowWritten - begin;
            }
            catch
            {
                // The step that follows starts this pose anew.
                Abandon();
                throw;
            }
            Done++;
            _started.RemoveAt(0);
            if (IsComplete)
                WriteJson();
            return row;
        }

        /// <summary>Closes results.csv and restores the scene.</summary>
        public void Dispose()
        {
            Abandon();
            _folder?.Dispose();
            _motions.Dispose();
        }

        void Start(RayReadback readback, CancellationToken cancel)
        {
            _motions.Show(_setup.Plan[_first + Done + _started.Count]);
            _started.Add(_setup.Radar.StartTrace(readback, cancel));
        }

        // False if the next pose cannot start: its own step says why, after the current row is written.
        bool StartsNext(CancellationToken cancel)
        {
            try
            {
                Start(RayReadback.None, cancel);
                return true;
            }
            catch (Exception problem) when (problem is GlintException || problem is OperationCanceledException)
            {
                return false;
            }
        }

        void Abandon()
        {
            foreach (var pose in _started)
                _setup.Radar.Abandon(pose);
            _started.Clear();
        }

        void Begin(SweepIdentity identity, SweepShard? shard, bool resume)
        {
            identity.Shard = shard;
            _identity = identity;
            _folder.Begin(identity, _startedUtc);
            if (resume)
                Done = _folder.Resume(Count, (number, row) => _setup.Plan.ProblemOf(_first + number, row));
        }

        // The division into rigid groups depends on the motion seen so far. A resumed sweep or a part has not seen
        // earlier poses, so each axis changes once before the first row. Ends at the first pose.
        void Rehearse()
        {
            RequireFrequencies(Gather(0));
            foreach (var axis in SweepAxis.All)
                if (_setup.Plan.FirstChange(axis) is var pose && pose > 0)
                    Gather(pose);
            if (_setup.Plan.Has(SweepAxis.Snapshot))
                SetLevels();
            Gather(0);
        }

        // Published levels scale all snapshots as the first one, which a resumed sweep or a part does not trace.
        void SetLevels()
        {
            var known = new HashSet<(double?, double?)>();
            for (int number = 0; number < _setup.Plan.Count; number++)
            {
                var pose = _setup.Plan[number];
                if (pose[SweepAxis.Snapshot] != _setup.Plan[0][SweepAxis.Snapshot])
                    return;
                if (!known.Add((pose[SweepAxis.Angle], pose[SweepAxis.Frequency])))
                    continue;
                _motions.Show(pose);
                if (!_setup.Radar.SetClutterLevels())
                    return;
            }
        }

        RadarScene Gather(int pose)
        {
            _motions.Show(_setup.Plan[pose]);
            return _setup.Radar.Gather().Scene;
        }

        // Those of the last pose too, before the first one is traced.
        void RequireFrequencies(RadarScene scene)
        {
            if (scene.Seas.Count == 0 || !_setup.Plan.Has(SweepAxis.Frequency))
                return;
            foreach (double frequency in _setup.Plan.Values(SweepAxis.Frequency))
            {
                SeaScattering.RequireFrequency(frequency);
                foreach (var surface in scene.Surfaces)
                    surface.RequireData(frequency);
            }
        }

        void WriteJson()
        {
            if (_folder == null)
                return;
            var info = RunDescription.Of(_setup);
            info.Sweep = _identity;
            info.StartedUtc = _folder.StartedUtc ?? _startedUtc;
            info.ElapsedMs = (_startedUtc - info.StartedUtc).TotalMilliseconds + _watch.Elapsed.TotalMilliseconds;
            _folder.Finish(info);
        }
    }
}
