using System;
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
        PoseInFlight _current; // started by the step before

        /// <summary>
        /// Begins or resumes a sweep; nothing is traced before the first <see cref="Step"/>.
        /// </summary>
        /// <param name="setup">Must not change while the sweep runs.</param>
        /// <param name="folder">Receives the rows; null: nothing is written.</param>
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
            _motions = new AxisDrivers(setup);
            if (setup.Plan == SweepPlan.Single)
                return;
            try
            {
                Rehearse();
                if (folder != null)
                    Begin(RunDescription.IdentityOf(setup), shard, resume);
            }
            catch
            {
                _motions.Dispose();
                throw;
            }
        }

        /// <summary>Number of poses of the plan, or of the part.</summary>
        public int Count { get; }

        /// <summary>Number of poses done, including those before a resumption.</summary>
        public int Done { get; private set; }

        /// <summary>
        /// Whether the next pose is gathered, and given to the device, before the row of the current one is made. The
        /// sweep is faster, and after a <see cref="Step"/> the scene shows the next pose. Poses do not overlap while a
        /// script listens to <see cref="RadarController.Traced"/>, or when single rays are kept.
        /// </summary>
        public bool Overlaps { get; set; }

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
            bool isStarted = radar.IsInFlight(_current) && _current.Readback == readback;
            if (!isStarted)
            {
                radar.Abandon(_current);
                _current = Start(0, readback, cancel);
            }
            bool overlaps = Overlaps && radar.MayOverlap(_current) && Done + 1 < Count;
            var next = overlaps ? StartNext(cancel) : null;
            SweepRow row;
            try
            {
                row = new SweepRow(_setup.Plan[_first + Done], radar.FinishTrace(_current, progress, cancel));
                var begin = _watch.Elapsed;
                _folder?.Append(row);
                RowWritten = _watch.Elapsed;
                Writing += RowWritten - begin;
            }
            catch
            {
                // The step that follows starts this pose anew.
                radar.Abandon(next);
                throw;
            }
            Done++;
            _current = next;
            if (IsComplete)
                WriteJson();
            return row;
        }

        /// <summary>Closes results.csv and restores the scene.</summary>
        public void Dispose()
        {
            _setup.Radar.Abandon(_current);
            _folder?.Dispose();
            _motions.Dispose();
        }

        PoseInFlight Start(int ahead, RayReadback readback, CancellationToken cancel)
        {
            _motions.Show(_setup.Plan[_first + Done + ahead]);
            return _setup.Radar.StartTrace(readback, cancel);
        }

        // Null if the next pose cannot start: its own step says why, after the current row is written.
        PoseInFlight StartNext(CancellationToken cancel)
        {
            try
            {
                return Start(1, RayReadback.None, cancel);
            }
            catch (Exception problem) when (problem is GlintException || problem is OperationCanceledException)
            {
                return null;
            }
        }

        void Begin(SweepIdentity identity, SweepShard? shard, bool resume)
        {
            identity.Shard = shard;
            _identity = identity;
            _folder.Begin(identity, _startedUtc);
            if (resume)
                Done = _folder.Resume(Count);
        }

        // The division into rigid groups depends on the motion seen so far. A resumed sweep or a part has not seen
        // earlier poses, so each axis changes once before the first row. Ends at the first pose.
        void Rehearse()
        {
            Gather(0);
            foreach (var axis in SweepAxis.All)
                if (_setup.Plan.FirstChange(axis) is var pose && pose > 0)
                    Gather(pose);
            Gather(0);
        }

        void Gather(int pose)
        {
            _motions.Show(_setup.Plan[pose]);
            _setup.Radar.Gather();
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
