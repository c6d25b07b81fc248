using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using System.Threading;
using Glint.Core;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// Cross sections, row by row. One trace gives the rows of up to 16 receivers in the far field and of neighbouring
    /// frequencies (<see cref="FrequencyGroups"/>).
    /// </summary>
    public sealed class CrossSectionRun : IDisposable
    {
        readonly CrossSectionSetup _setup;
        readonly ResultsFolder _folder;
        readonly CrossSectionTracer _tracer;
        readonly int _first;
        readonly FrequencyGroups _groups;
        readonly int _receiversOfTrace;
        readonly DateTime _startedUtc = DateTime.UtcNow;
        readonly Stopwatch _watch = Stopwatch.StartNew();
        readonly SweepIdentity _identity;

        // Traces of the current direction, by their first frequency and first receiver.
        readonly Dictionary<(int, int), (CrossSectionPose, CrossSectionResult)> _traces =
            new Dictionary<(int, int), (CrossSectionPose, CrossSectionResult)>();

        int _pose = -1;

        /// <summary>Begins or resumes a run; nothing is traced before the first <see cref="Step"/>.</summary>
        /// <param name="setup">Must not change while the run lasts.</param>
        /// <param name="shader">Shaders/Tubes.compute.</param>
        /// <param name="folder">Receives the rows; null: nothing is written.</param>
        /// <param name="shard">The part of the rows to compute; null: all.</param>
        /// <param name="resume">Resumes the same run in the folder.</param>
        /// <exception cref="GlintException">
        /// The setup cannot be computed, or the folder holds another run.
        /// </exception>
        public CrossSectionRun(CrossSectionSetup setup, ComputeShader shader, ResultsFolder folder = null,
            SweepShard? shard = null, bool resume = false)
        {
            (_setup, _folder) = (setup, folder);
            string subject = setup.Subject ?? setup.ScenePath ?? "the scene";
            setup.Validate(subject);
            int rows = setup.Plan.Count;
            _first = shard?.First(rows) ?? 0;
            Count = (shard?.End(rows) ?? rows) - _first;
            _groups = new FrequencyGroups(setup.Plan.Frequencies, setup.UsedMaterials(), setup.MaxCoefficientError);
            _receiversOfTrace = double.IsPositiveInfinity(setup.Range) ? TubeKernels.MaxReceivers : 1;
            if (folder != null)
            {
                _identity = CrossSectionDescription.IdentityOf(setup);
                _identity.Shard = shard;
                folder.Begin(_identity, _startedUtc);
                if (resume)
                    Done = folder.Resume(Count);
            }
            _tracer = new CrossSectionTracer(shader, subject);
        }

        /// <summary>Number of rows of the run, or of the part.</summary>
        public int Count { get; }

        /// <summary>Number of rows done, including those before a resumption.</summary>
        public int Done { get; private set; }

        /// <summary>Number of poses traced, without contributions and what was done before a resumption.</summary>
        public int Traces { get; private set; }

        /// <summary>True if all rows are done.</summary>
        public bool IsComplete => Done == Count;

        /// <summary>Computes and writes the next row; after the last row it writes the other files.</summary>
        /// <param name="progress">Receives the fraction of the trace done, 0 to 1; may be null.</param>
        /// <param name="cancel">Cancels the trace.</param>
        /// <exception cref="GlintException">
        /// The row cannot be computed or written; earlier rows are kept.
        /// </exception>
        /// <exception cref="OperationCanceledException">The trace was cancelled; earlier rows are kept.</exception>
        public CrossSectionRow Step(IProgress<double> progress = null, CancellationToken cancel = default)
        {
            var planned = _setup.Plan[_first + Done];
            if (planned.Pose != _pose)
                _traces.Clear();
            _pose = planned.Pose;
            int frequency = _groups.FirstOf(planned.FrequencyIndex);
            int receiver = planned.Receiver / _receiversOfTrace * _receiversOfTrace;
            if (!_traces.TryGetValue((frequency, receiver), out var traced))
            {
                var made = PoseOf(planned, frequency, receiver);
                _traces.Add((frequency, receiver), traced = (made, _tracer.Trace(made, progress, cancel)));
                Traces++;
            }
            var (pose, trace) = traced;
            var row = RowOf(planned, trace, planned.Receiver - receiver,
                pose.SampleOf(planned.Pulse, planned.FrequencyIndex - frequency));
            if (_setup.HasContributions)
                row.Contributions = _tracer.Contributions(pose, trace, planned.Receiver - receiver,
                    planned.FrequencyIndex - frequency, _setup.Polarisations, progress, cancel);
            _folder?.Append(row);
            Done++;
            if (IsComplete)
                WriteOtherFiles();
            return row;
        }

        /// <summary>Releases the device's buffers and the folder.</summary>
        public void Dispose()
        {
            _tracer.Dispose();
            _folder?.Dispose();
        }

        CrossSectionPose PoseOf(in PlannedCrossSection planned, int frequency, int receiver)
        {
            var plan = _setup.Plan;
            int receivers = Math.Min(_receiversOfTrace, plan.Receivers - receiver);
            int row = _first + Done - planned.Receiver;
            var aspects = Enumerable.Range(receiver, receivers).Select(i => plan[row + i].ReceiverAspect).ToArray();
            var frequencies = plan.Frequencies.Where((_, i) => _groups.FirstOf(i) == frequency).ToArray();
            return _setup.PoseOf(planned, aspects, frequencies);
        }

        CrossSectionRow RowOf(in PlannedCrossSection planned, CrossSectionResult trace, int receiver, int sample) =>
            new CrossSectionRow(planned, trace.S[receiver, sample], _setup.Polarisations)
            {
                Error = trace.Errors[receiver, sample], FloorDbsm = _setup.FloorDbsm,
                ToleranceDb = _setup.ToleranceDb, Radius = _setup.Radius,
                CoarseShare = _setup.Quality.Share(Signal.Wavelength(planned.Frequency)),
                Tubes = trace.Tubes, Rays = trace.Rays
            };

        void WriteOtherFiles()
        {
            if (_folder == null)
                return;
            var info = CrossSectionDescription.Of(_setup);
            info.Sweep = _identity;
            info.Backproject = _setup.Backproject;
            info.StartedUtc = _folder.StartedUtc ?? _startedUtc;
            info.ElapsedMs = (_startedUtc - info.StartedUtc).TotalMilliseconds + _watch.Elapsed.TotalMilliseconds;
            _folder.Finish(info);
        }
    }
}
