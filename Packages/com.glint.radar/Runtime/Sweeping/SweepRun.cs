using System;
using System.Diagnostics;
using System.Threading;
using Glint.Core;

namespace Glint
{
    /// <summary>
    /// A sweep pose by pose: shows the pose, traces, and writes the row.
    /// Disposing puts everything back that was moved. Unity's play mode takes one step a frame,
    /// the commands take them in a row.
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

        /// <summary>
        /// Begins a sweep, or goes on with one; nothing is traced before the first <see cref="Step"/>.
        /// </summary>
        /// <param name="setup">What the sweep is of; not to be changed while it runs.</param>
        /// <param name="folder">Takes the rows; null to write nothing.</param>
        /// <param name="shard">The part to do; null: all of it.</param>
        /// <param name="resume">Goes on where the same sweep was ended in the folder.</param>
        /// <exception cref="GlintException">
        /// An axis has nothing that it could move, or not so: the sea has no such snapshot,
        /// the radar cannot be moved about the target. Or another sweep is in the folder.
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

        /// <summary>Poses to trace: those of the plan, or of the part.</summary>
        public int Count { get; }

        /// <summary>Poses traced so far, those before a resumption included.</summary>
        public int Done { get; private set; }

        /// <summary>True when every pose is traced.</summary>
        public bool IsComplete => Done == Count;

        /// <summary>Traces the next pose and writes its row; after the last one results.json.</summary>
        /// <param name="progress">Told how much of the pose is done, 0 to 1; may be null.</param>
        /// <param name="cancel">Ends the pose.</param>
        /// <param name="readback">Which rays the row's result carries.</param>
        /// <exception cref="GlintException">
        /// The pose cannot be traced or its row not be written; the rows before are kept.
        /// </exception>
        /// <exception cref="OperationCanceledException">
        /// The pose was cancelled; the rows before are kept, and the next step traces it again.
        /// </exception>
        public SweepRow Step(IProgress<double> progress = null, CancellationToken cancel = default,
            RayReadback readback = RayReadback.None)
        {
            var pose = _setup.Plan[_first + Done];
            _motions.Show(pose);
            var row = new SweepRow(pose, _setup.Radar.Trace(readback, progress, cancel));
            _folder?.Append(row);
            Done++;
            if (IsComplete)
                WriteJson();
            return row;
        }

        /// <summary>Closes results.csv and puts back what was moved.</summary>
        public void Dispose()
        {
            _folder?.Dispose();
            _motions.Dispose();
        }

        void Begin(SweepIdentity identity, SweepShard? shard, bool resume)
        {
            identity.Shard = shard;
            _identity = identity;
            _folder.Begin(identity, _startedUtc);
            if (resume)
                Done = _folder.Resume(Count);
        }

        // How a scene is divided depends on what was seen to change. So that no row depends on the rows before it,
        // which a resumed sweep or a part of one has not, everything changes once before the first row.
        // Ends at the first pose.
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
