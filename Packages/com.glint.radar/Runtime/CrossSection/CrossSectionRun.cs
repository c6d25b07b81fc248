using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using Glint.Core;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// Cross sections, row by row. One trace gives the rows of up to 16 receivers, of neighbouring
    /// frequencies (<see cref="FrequencyGroups"/>) and of neighbouring looks of an image (<see cref="LookGroups"/>).
    /// </summary>
    public sealed class CrossSectionRun : IDisposable
    {
        readonly CrossSectionSetup _setup;
        readonly ResultsFolder _folder;
        readonly CrossSectionTracer _tracer;
        readonly FrequencyGroups _groups;
        readonly LookGroups _looks;
        readonly RadarScene _turningScene;
        readonly int _posesTogether;
        readonly DateTime _startedUtc = DateTime.UtcNow;
        readonly Stopwatch _watch = Stopwatch.StartNew();
        readonly SweepIdentity _identity;

        // Rows that are written, and not returned yet.
        readonly Queue<CrossSectionRow> _ready = new Queue<CrossSectionRow>();

        // Traces of the current direction and of later ones, by their first frequency and first receiver.
        readonly Dictionary<(int Pose, int, int), (CrossSectionPose, CrossSectionResult)> _traces =
            new Dictionary<(int, int, int), (CrossSectionPose, CrossSectionResult)>();

        /// <summary>Begins or resumes a run; nothing is traced before the first <see cref="Step"/>.</summary>
        /// <param name="setup">Must not change while the run lasts.</param>
        /// <param name="shader">Shaders/Tubes.compute.</param>
        /// <param name="folder">
        /// Receives the rows, and is released with the run, also if it is refused; null: nothing is written.
        /// </param>
        /// <param name="shard">The part of the rows to compute; null: all.</param>
        /// <param name="resume">Resumes the same run in the folder.</param>
        /// <param name="posesTogether">
        /// Directions that a step may trace at most, the row's own and later ones
        /// (<see cref="CrossSectionTracer.PosesOfADispatch"/>): faster on a GPU, but steps are of unequal length.
        /// </param>
        /// <exception cref="GlintException">
        /// The setup cannot be computed, or the folder holds another run.
        /// </exception>
        public CrossSectionRun(CrossSectionSetup setup, ComputeShader shader, ResultsFolder folder = null,
            SweepShard? shard = null, bool resume = false, int posesTogether = 1)
        {
            (_setup, _folder) = (setup, folder);
            try
            {
                string subject = setup.Subject ?? setup.ScenePath ?? "the scene";
                var ahead = setup.TakeAhead();
                setup.Validate(subject);
                int rows = setup.Plan.Count;
                First = shard?.First(rows) ?? 0;
                Count = (shard?.End(rows) ?? rows) - First;
                _groups = new FrequencyGroups(setup.Plan.Frequencies, setup.UsedMaterials(), setup.MaxCoefficientError);
                _looks = setup.Looks;
                if (_looks.Looks > 1)
                    _turningScene = setup.Scene.MovingBy(LookGroups.TurnAbout(setup.PhaseCentre));
                if (folder != null)
                {
                    _identity = CrossSectionDescription.IdentityOf(setup);
                    _identity.Shard = shard;
                    folder.Begin(_identity, _startedUtc);
                    if (resume)
                        Done = folder.Resume(Count, ProblemOf);
                }
                _tracer = new CrossSectionTracer(shader, subject);
                _tracer.Expect(ahead);
            }
            catch
            {
                _folder?.Dispose();
                throw;
            }
            _posesTogether = posesTogether;
        }

        /// <summary>Number of the first row in the plan.</summary>
        public int First { get; }

        /// <summary>Number of rows of the run, or of the part.</summary>
        public int Count { get; }

        /// <summary>Number of rows done, including those before a resumption.</summary>
        public int Done { get; private set; }

        /// <summary>Number of poses traced, without contributions and what was done before a resumption.</summary>
        public int Traces { get; private set; }

        /// <summary>True if all rows are done.</summary>
        public bool IsComplete => Done == Count;

        /// <summary>
        /// Computes and writes the next row, with others of its direction, which later steps return; after the last row
        /// it writes the other files.
        /// </summary>
        /// <param name="progress">Receives the fraction of the trace done, 0 to 1; may be null.</param>
        /// <param name="cancel">Cancels the trace.</param>
        /// <exception cref="GlintException">
        /// The row cannot be computed or written; earlier rows are kept.
        /// </exception>
        /// <exception cref="OperationCanceledException">The trace was cancelled; earlier rows are kept.</exception>
        public CrossSectionRow Step(IProgress<double> progress = null, CancellationToken cancel = default)
        {
            if (_ready.Count == 0)
                Compute(progress, cancel);
            var row = _ready.Dequeue();
            Done++;
            if (IsComplete)
                WriteOtherFiles();
            return row;
        }

        // A row that is not what the plan has in its place was changed.
        string ProblemOf(int number, StoredRow row)
        {
            string problem = _setup.Plan.ProblemOf(First + number, row);
            return problem == null && _setup.HasContributions
                ? CrossSectionContributions.ProblemOf(row.Contributions, _setup.ObjectNames.Count)
                : problem;
        }

        // The next row, and with it those that are traced already: they are written at once. A row with contributions takes
        // a trace of its own, and is written alone.
        void Compute(IProgress<double> progress, CancellationToken cancel)
        {
            int first = First + Done, end = first + 1;
            if (!_traces.ContainsKey(TraceOf(_setup.Plan[first])))
                TraceFrom(first, progress, cancel);
            while (end < First + Count && !_setup.HasContributions && _traces.ContainsKey(TraceOf(_setup.Plan[end])))
                end++;
            var rows = new CrossSectionRow[end - first];
            if (rows.Length == 1)
                rows[0] = RowOf(_setup.Plan[first], progress, cancel);
            else
                Parallel.For(0, rows.Length, i => rows[i] = RowOf(_setup.Plan[first + i], progress, cancel));
            _folder?.Append(rows);
            foreach (var row in rows)
                _ready.Enqueue(row);
        }

        /// <summary>Releases the device's buffers and the folder.</summary>
        public void Dispose()
        {
            _tracer.Dispose();
            _folder?.Dispose();
        }

        // The trace that a row is of.
        (int Pose, int Frequency, int Receiver) TraceOf(in PlannedCrossSection planned) => (
            _looks.FirstOf(planned.Pose), _groups.FirstOf(planned.FrequencyIndex),
            planned.Receiver / TubeKernels.MaxReceivers * TubeKernels.MaxReceivers);

        // Traces a row, and the rows of the same frequencies and receivers in later directions.
        void TraceFrom(int row, IProgress<double> progress, CancellationToken cancel)
        {
            var (pose, frequency, receiver) = TraceOf(_setup.Plan[row]);
            foreach (var done in _traces.Keys.Where(key => key.Pose < pose).ToArray())
                _traces.Remove(done);
            var keys = new List<(int, int, int)>();
            var poses = new List<CrossSectionPose>();
            for (; row < First + Count && poses.Count < _posesTogether; row++)
            {
                var planned = _setup.Plan[row];
                if (TraceOf(planned) != (pose, frequency, receiver))
                    continue;
                keys.Add((pose, frequency, receiver));
                pose += _looks.Looks;
                poses.Add(PoseOf(row, planned, frequency, receiver));
            }
            var results = Trace(poses, progress, cancel);
            for (int i = 0; i < results.Length; i++)
                _traces.Add(keys[i], (poses[i], results[i]));
            Traces += results.Length;
        }

        // A pose that fails must not take earlier rows with it.
        CrossSectionResult[] Trace(List<CrossSectionPose> poses, IProgress<double> progress, CancellationToken cancel)
        {
            try
            {
                return _tracer.Trace(poses, progress, cancel);
            }
            catch (GlintException) when (poses.Count > 1)
            {
                return new[] { _tracer.Trace(poses[0], progress, cancel) };
            }
        }

        CrossSectionPose PoseOf(int row, in PlannedCrossSection planned, int frequency, int receiver)
        {
            var plan = _setup.Plan;
            int receivers = Math.Min(TubeKernels.MaxReceivers, plan.Receivers - receiver);
            int first = row - planned.Receiver;
            var aspects = Enumerable.Range(receiver, receivers).Select(i => plan[first + i].ReceiverAspect).ToArray();
            var frequencies = plan.Frequencies.Where((_, i) => _groups.FirstOf(i) == frequency).ToArray();
            return _looks.Looks == 1
                ? _setup.PoseOf(planned, aspects, frequencies)
                : MiddleOf(planned, frequencies);
        }

        // The pose of the looks that share the trace of one.
        CrossSectionPose MiddleOf(PlannedCrossSection planned, double[] frequencies)
        {
            planned.AzimuthDegrees = _looks.MiddleOf(planned.Pose);
            var pose = _setup.PoseOf(planned, new[] { planned.Radar }, frequencies);
            (pose.Scene, pose.Times, pose.WaveFactors) = (_turningScene, _looks.Times, _looks.Factors);
            return pose;
        }

        CrossSectionRow RowOf(in PlannedCrossSection planned, IProgress<double> progress, CancellationToken cancel)
        {
            var key = TraceOf(planned);
            var (pose, trace) = _traces[key];
            int receiver = planned.Receiver - key.Receiver, frequency = planned.FrequencyIndex - key.Frequency;
            // There are several looks of a trace, or several pulses.
            int sample = pose.SampleOf(planned.Pulse + planned.Pose - key.Pose, frequency);
            return new CrossSectionRow(planned, trace.S[receiver, sample], _setup.Polarisations)
            {
                Error = trace.Errors[receiver, sample], CrossError = trace.CrossErrors[receiver, sample],
                FloorDbsm = trace.FloorDbsm,
                ToleranceDb = _setup.ToleranceDb, Radius = _setup.Radius,
                CoarseShare = _setup.Quality.Share(Signal.Wavelength(planned.Frequency)),
                Tubes = trace.Tubes, Rays = trace.Rays, Bounces = trace.Bounces,
                Contributions = _setup.HasContributions
                    ? _tracer.Contributions(pose, trace, receiver, frequency, _setup.Polarisations, progress, cancel)
                    : null
            };
        }

        void WriteOtherFiles()
        {
            if (_folder == null)
                return;
            var info = CrossSectionDescription.Of(_setup);
            info.Sweep = _identity;
            info.Backproject = _setup.Backproject;
            info.StartedUtc = _folder.StartedUtc ?? _startedUtc;
            info.ElapsedMs = (_startedUtc - info.StartedUtc).TotalMilliseconds + _watch.Elapsed.TotalMilliseconds;
            // A driver takes long to release large buffers.
            _folder.Finish(info, _tracer.Dispose);
        }
    }
}
