using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using System.Threading;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// Computes cross sections: divides the wavefront into ray tubes on the GPU, and sums what the currents that they
    /// paint radiate.
    /// </summary>
    public sealed class CrossSectionTracer : IDisposable
    {
        const int TileCells = 64;          // the pacer counts tiles

        // Elements of the lists, and of the corners of a dispatch times their bounces, for each of 8 GB of memory up to
        // MaxLists: long lists fill a device with large memory.
        const int ListElements = 1 << 20, CornerElements = 1 << 21, MaxLists = 16, MebibytesAList = 8192;

        // Rays of a slice for each of these elements: on a ship there is a tube for every five rays. A slice whose lists become
        // full is traced again in two.
        const int RaysAList = 3 << 20;

        // Error that a cell may have, as a fraction of what a conducting plate of a square wavelength returns: at first a
        // part of the tolerance, within limits; and at least.
        const double PartOfTolerance = 0.25, MinFirstCellError = 1.0 / 64, MaxFirstCellError = 1.0 / 8,
            MinCellError = 1.0 / (1 << 17);

        // Of the marks of all poses of a dispatch: 256 MB.
        const long MaxMarkWords = 1 << 26;

        readonly string _owner;
        readonly TubeKernels _kernels;
        readonly DeviceScene _scene;
        readonly SurfaceBuffers _surfaces = new SurfaceBuffers();
        readonly EdgeBuffers _edges = new EdgeBuffers();
        readonly DeviceBuffer<uint> _output = new DeviceBuffer<uint>("sums of tubes");
        readonly DeviceBuffer<Tube> _tubes = new DeviceBuffer<Tube>("tubes");
        readonly DeviceBuffer<uint> _tubeParts = new DeviceBuffer<uint>("parts of tubes");
        readonly DeviceBuffer<float4> _tubeRates = new DeviceBuffer<float4>("rates of tubes");
        readonly DeviceBuffer<TubeCell> _cells = new DeviceBuffer<TubeCell>("cells of tubes");
        readonly DeviceBuffer<TubeCell> _borders = new DeviceBuffer<TubeCell>("border cells");
        readonly DeviceBuffer<TubeCorner> _corners = new DeviceBuffer<TubeCorner>("corners of cells");
        readonly DeviceBuffer<uint> _marks = new DeviceBuffer<uint>("marks of cells");
        readonly DeviceBuffer<uint4> _links = new DeviceBuffer<uint4>("corners of patches");
        readonly DeviceBuffer<float4> _waveNumbers = new DeviceBuffer<float4>("frequencies");
        readonly SeaKernel _sea;
        readonly SeaLevels _levels;
        readonly DispatchPacer _pacer = new DispatchPacer();
        readonly int _lists = SoftwareDevice.IsInUse ? 1
            : math.clamp(SystemInfo.graphicsMemorySize / MebibytesAList, 1, MaxLists);

        /// <param name="shader">Shaders/Tubes.compute.</param>
        /// <param name="owner">Name of the owner, for messages.</param>
        /// <exception cref="GlintException"><see cref="Check"/> refuses device or shader.</exception>
        public CrossSectionTracer(ComputeShader shader, string owner = nameof(CrossSectionTracer))
        {
            Check(shader, owner);
            _owner = owner;
            _kernels = new TubeKernels(shader);
            _sea = new SeaKernel(shader, owner);
            _levels = new SeaLevels(shader, owner);
            _scene = new DeviceScene(BvhLayout.Binary, owner, long.MaxValue);
        }

        /// <summary>Refuses a device that cannot trace, and another shader.</summary>
        /// <exception cref="GlintException">The message says why, and the way out.</exception>
        public static void Check(ComputeShader shader, string owner) =>
            DeviceCheck.Require(shader, "Tubes", "TubeCells", owner);

        /// <summary>
        /// Error that a cell may have, as a fraction of what a conducting plate of a base cell returns, for tests; 0: what
        /// the tolerance takes.
        /// </summary>
        internal double CellError { get; set; }

        /// <summary>Poses that a GPU traces together at most; a single one fills a software device.</summary>
        public static int PosesOfADispatch => SoftwareDevice.IsInUse ? 1 : TubeKernels.MaxPoses;

        /// <summary>Poses of a dispatch at most, for tests.</summary>
        internal int PosesTogether { get; set; } = PosesOfADispatch;

        /// <summary>Cells of a dispatch, for tests; 0: by the times of earlier dispatches.</summary>
        internal int CellsADispatch { get; set; }

        /// <summary>Traces one pose to its tolerance.</summary>
        /// <inheritdoc cref="Trace(IReadOnlyList{CrossSectionPose}, IProgress{double}, CancellationToken)"/>
        public CrossSectionResult Trace(CrossSectionPose pose, IProgress<double> progress = null,
            CancellationToken cancel = default) => Trace(new[] { pose }, progress, cancel)[0];

        /// <summary>
        /// Traces poses to their tolerance, many in a dispatch on a GPU, which a single one does not fill. The results are
        /// those of single poses, bit for bit.
        /// </summary>
        /// <param name="poses">Those that are alike are traced together (<see cref="CrossSectionPose.IsLike"/>).</param>
        /// <param name="progress">Receives the fraction done, 0 to 1, of each attempt.</param>
        /// <param name="cancel">Cancels while BVHs are built, or after the current slice.</param>
        /// <exception cref="GlintException">The memory does not suffice for the scene.</exception>
        /// <exception cref="OperationCanceledException">The poses were cancelled.</exception>
        public CrossSectionResult[] Trace(IReadOnlyList<CrossSectionPose> poses, IProgress<double> progress = null,
            CancellationToken cancel = default)
        {
            var results = new List<CrossSectionResult>();
            while (results.Count < poses.Count)
            {
                var pose = poses[results.Count];
                SetScene(pose, cancel);
                if (_scene.IsEmpty)
                {
                    results.Add(new CrossSectionResult(pose.Receivers.Length, pose.Samples) { IsMet = true });
                    continue;
                }
                var jobs = JobsOf(poses.Skip(results.Count).TakeWhile((other, i) => i == 0 || pose.IsLike(other)));
                TraceTogether(jobs, progress, cancel);
                results.AddRange(jobs.Select(job => job.Result));
            }
            return results.ToArray();
        }

        // Poses that the kernels' lists and sums hold.
        TubeJob[] JobsOf(IEnumerable<CrossSectionPose> poses)
        {
            var jobs = new List<TubeJob>();
            int words = 0;
            foreach (var pose in poses)
            {
                var job = new TubeJob(pose, GridOf(pose));
                words = Math.Max(words, TubeKernels.MarkWordsOf(job.Grid));
                int most = pose.Scene.Seas.Count > 0 ? 1 : Math.Min(PosesTogether, TubeSums.MaxSlots / TubeSums.SlotsOf(pose));
                if (jobs.Count > 0 && (jobs.Count == most || (jobs.Count + 1L) * words > MaxMarkWords))
                    break;
                jobs.Add(job);
            }
            return jobs.ToArray();
        }

        static int MarkWordsOf(IEnumerable<TubeJob> jobs) => jobs.Max(job => TubeKernels.MarkWordsOf(job.Grid));

        void TraceTogether(TubeJob[] jobs, IProgress<double> progress, CancellationToken cancel)
        {
            var pose = jobs[0].Pose;
            // Before the tubes' buffers are bound: it clears sums of its own.
            var clutter = Clutter(pose, cancel);
            int outputSize = TubeSums.OutputSize(pose, jobs.Length);
            Bind(jobs, outputSize, 1);
            _kernels.SumAll();
            double floor = Math.Max(pose.FloorDbsm ?? CrossSectionFloor.Of(_scene.Min, _scene.Max), FloorOf(clutter));
            TraceEdges(jobs, outputSize, read => AddTo(jobs, job => job.Edges, read), cancel);
            foreach (var job in jobs)
                job.Plan(CellError > 0 ? CellError : FirstCellErrorOf(job));
            while (jobs.Any(job => !job.IsDone))
            {
                double cellError = jobs.Where(job => !job.IsDone).Max(job => job.CellError);
                var now = jobs.Where(job => !job.IsDone && job.CellError == cellError).ToArray();
                TraceCells(jobs, now, outputSize, read => AddTo(jobs, job => job.Sums, read), progress, cancel);
                foreach (var job in now)
                    EndAttempt(job, clutter, floor);
            }
        }

        void AddTo(TubeJob[] jobs, Func<TubeJob, TubeSums> sumsOf, uint[] read)
        {
            for (int i = 0; i < jobs.Length; i++)
                sumsOf(jobs[i]).Add(read, i, jobs.Length, _owner);
        }

        // Ends an attempt, and plans the next one if the error is too large.
        void EndAttempt(TubeJob job, ClutterEcho[] clutter, double floor)
        {
            var result = job.End();
            result.Add(clutter);
            result.FloorDbsm = floor;
            result.WedgesLeftOut = job.Pose.HasEdges ? _edges.LeftOutCount : 0;
            double excess = Excess(result, job.Pose.ToleranceDb, floor);
            result.IsMet = excess <= 1;
            double atLeast = InBaseCells(job, MinCellError);
            job.IsDone = result.IsMet || CellError > 0 || job.CellError <= atLeast;
            if (job.IsDone)
                return;
            // Errors fall with the power 0.6 of that of a cell. Poses are traced together in powers of two.
            double step = Math.Ceiling(Math.Log(math.clamp(1.5 * Math.Pow(excess, 1.6), 2, 64), 2));
            job.Plan(Math.Max(atLeast, job.CellError / Math.Pow(2, step)));
        }

        static double FirstCellErrorOf(TubeJob job) => InBaseCells(job, math.clamp(
            PartOfTolerance * CrossSectionAccuracy.AllowedBy(job.Pose.ToleranceDb), MinFirstCellError, MaxFirstCellError));

        // An error of a plate of a square wavelength as that of a base cell's, if that is larger.
        static double InBaseCells(TubeJob job, double error)
        {
            double wavelengths = Math.Max(1, job.Grid.Side / Signal.Wavelength(job.Pose.Frequencies.Last()));
            return error / (wavelengths * wavelengths);
        }

        // The diffuse echo of the seas: none if the radar does not receive.
        ClutterEcho[] Clutter(CrossSectionPose pose, CancellationToken cancel)
        {
            if (pose.Scene.Seas.Count == 0)
                return null;
            if (!pose.IsMonostatic)
                throw new GlintException($"{_owner}: the clutter of a sea is that which returns to the radar, and this "
                    + "pose has another receiver: switch the sea's clutter off, or leave the receiver out");
            return Enumerable.Range(0, pose.Samples).Select(sample => _sea.Sum(_scene, pose, pose.FrequencyOf(sample),
                pose.TimeOf(sample), ClutterGrid.Whole,
                sea => _levels.Of(pose, sea, pose.FrequencyOf(sample), cancel), null, cancel)[0]).ToArray();
        }

        // No echo need be known better than against the clutter that it is seen in, dBsm: in VV or HH, whichever is more.
        static double FloorOf(ClutterEcho[] clutter) => clutter == null ? double.NegativeInfinity
            : PowerLevel.ToDecibels(clutter.Min(echo => Math.Max(echo.SigmaVV, echo.SigmaHH)));

        /// <summary>Traces a pose again and sums what the parts of the scene contribute to one cross section.</summary>
        /// <param name="result">Of the pose: the same tubes are summed.</param>
        /// <param name="receiver">Its place in the pose.</param>
        /// <param name="frequency">Its place in the pose.</param>
        /// <param name="polarisations">Those of interest.</param>
        /// <param name="progress">Receives the fraction done, 0 to 1.</param>
        /// <param name="cancel">Cancels after the current slice.</param>
        /// <exception cref="GlintException">The memory does not suffice for the scene.</exception>
        /// <exception cref="OperationCanceledException">The pose was cancelled.</exception>
        public CrossSectionContributions Contributions(CrossSectionPose pose, CrossSectionResult result, int receiver,
            int frequency, IReadOnlyList<Polarisation> polarisations, IProgress<double> progress = null,
            CancellationToken cancel = default)
        {
            SetScene(pose, cancel);
            if (_scene.IsEmpty)
                return CrossSectionContributions.None;
            var jobs = new[] { new TubeJob(pose, GridOf(pose)) };
            var parts = _surfaces.Parts;
            int firstPart = TubeSums.OutputSize(pose, 1);
            var sums = new PartSums(parts, firstPart, jobs[0].Edges, receiver, frequency);
            Bind(jobs, sums.OutputSize, ListCapacity);
            _kernels.SumParts(parts, receiver, frequency, firstPart);
            TraceEdges(jobs, sums.OutputSize, sums.Add, cancel);
            jobs[0].Plan(result.CellError);
            TraceCells(jobs, jobs, sums.OutputSize, sums.Add, progress, cancel);
            return sums.ToContributions(polarisations);
        }

        /// <summary>
        /// Sums a pose by uniform points instead of ray tubes, without edges: what tubes are compared with
        /// (glint bench --rcs). Errors are not known.
        /// </summary>
        /// <param name="across">Points along a side of a base cell: <see cref="TubeGrid.SideFor"/>.</param>
        /// <param name="offset">Of the first point of a base cell, 0 to 1 spacings of points.</param>
        /// <inheritdoc cref="Trace(CrossSectionPose, IProgress{double}, CancellationToken)"/>
        public CrossSectionResult TracePoints(CrossSectionPose pose, int across, double2 offset,
            CancellationToken cancel = default)
        {
            SetScene(pose, cancel);
            var job = new TubeJob(pose, GridOf(pose));
            var read = new uint[TubeSums.OutputSize(pose, 1)];
            Bind(new[] { job }, read.Length, 1);
            _kernels.SumAll();
            job.Plan(1);
            job.Begin();
            // The list holds the currents of all bounces.
            int max = ListCapacity / (pose.MaxBounces * pose.Receivers.Length * across * across);
            while (job.Left > 0)
            {
                cancel.ThrowIfCancellationRequested();
                double rays = max;
                int count = job.SliceOf(max, max, ref rays);
                _kernels.Clear(read.Length);
                _kernels.TracePoints(job.Next, count, across, offset);
                _output.ReadBack(read, read.Length);
                job.Sums.Add(read, 0, 1, _owner);
                job.Took(count, TubeSums.RaysOf(read, 0));
            }
            return job.Sums.ToResult();
        }

        // Largest ratio of an error to the one allowed.
        static double Excess(CrossSectionResult result, double toleranceDb, double floorDbsm)
        {
            double excess = 0;
            for (int receiver = 0; receiver < result.S.GetLength(0); receiver++)
                for (int frequency = 0; frequency < result.S.GetLength(1); frequency++)
                    excess = Math.Max(excess, new CrossSectionAccuracy(result.S[receiver, frequency],
                        result.Errors[receiver, frequency], floorDbsm).Excess(toleranceDb));
            return excess;
        }

        void SetScene(CrossSectionPose pose, CancellationToken cancel)
        {
            _scene.Set(pose.Scene, new TraceStatistics(), (mesh, layout) => MeshBvh.Build(mesh, layout, cancel));
            if (_scene.IsEmpty)
                return;
            _scene.RequireOnePage(_owner, "a cross section takes");
            _surfaces.Set(pose.Scene, _scene.Centre, pose.CreaseDegrees, pose.CoefficientFrequency);
            if (pose.HasEdges)
                _edges.Set(pose.Scene, _surfaces.Patches, _surfaces.Parts, _scene.Centre,
                    TubeGrid.EdgePieceFor(pose));
        }

        TubeGrid GridOf(CrossSectionPose pose) =>
            new TubeGrid(pose, TubeGrid.SideFor(pose, _scene.Min, _scene.Max), _scene.Min, _scene.Max);

        void Bind(TubeJob[] jobs, int outputSize, int tubeParts)
        {
            var pose = jobs[0].Pose;
            _kernels.SetScene(_scene, _surfaces);
            _kernels.SetPoses(jobs);
            _kernels.SetUnits(jobs[0].Edges);
            _output.Reserve(outputSize);
            _tubes.Reserve(ListCapacity);
            _tubeParts.Reserve(tubeParts);
            _cells.Reserve(CellCapacity(pose));
            _corners.Reserve(_lists * CornerElements);
            _borders.Reserve(ListCapacity);
            _tubeRates.Reserve(pose.IsMoving ? ListCapacity : 1);
            _waveNumbers.Upload(Enumerable.Range(0, pose.Samples).Select(sample =>
                TubeRounds.WaveNumber(pose.PhaseFrequencyOf(sample), pose.TimeOf(sample))).ToArray());
            _kernels.SetLists(_output, _tubes, _tubeParts, _tubeRates, _cells, _borders, _corners,
                _waveNumbers, CellCapacity(pose));
            int words = MarkWordsOf(jobs), links = TubeKernels.LinksOf(jobs[0].Grid, _surfaces);
            _marks.Reserve((long)jobs.Length * words);
            _links.Reserve((long)jobs.Length * links);
            _kernels.Mark(jobs.Length, words, links, _surfaces, _marks, _links);
        }

        // Traces all cells of some of the poses to an error of each, slice by slice, and hands each slice's output over.
        void TraceCells(TubeJob[] jobs, TubeJob[] now, int outputSize, Action<uint[]> add, IProgress<double> progress,
            CancellationToken cancel)
        {
            var (pose, grid, cellError) = (now[0].Pose, now[0].Grid, now[0].CellError);
            // A division makes a cell's share a quarter; a bisection halves the error of its border. Where curved
            // surfaces focus, a base cell returns up to 64 times what a plate does.
            int maxLevel = (int)Math.Ceiling(0.5 * Math.Log(1.2 / cellError, 2)) + 3;
            int maxBisections = (int)Math.Ceiling(Math.Log(1 / cellError, 2)) + 8;
            _kernels.SetAccuracy(cellError * 2 * grid.Side * grid.Side, maxLevel, maxBisections);
            foreach (var job in now)
                job.Begin();
            var read = new uint[outputSize];
            long max = CellCapacity(pose), all = now.Sum(job => job.Left);
            for (long left = all; left > 0;)
            {
                cancel.ThrowIfCancellationRequested();
                long most = Math.Min(left, max);
                int tiles = _pacer.NextTiles((int)Math.Min(int.MaxValue, (most + TileCells - 1) / TileCells),
                    pose.MaxBounces);
                var slices = SlicesOf(jobs, Math.Min(most, CellsADispatch > 0 ? CellsADispatch : (long)tiles * TileCells));
                int count = slices.Sum(slice => slice.Count);
                var watch = Stopwatch.StartNew();
                _kernels.Clear(read.Length);
                _kernels.Trace(slices, maxLevel + 1, maxBisections);
                _output.ReadBack(read, read.Length);
                _pacer.Took(Math.Max(1, count / TileCells), watch.Elapsed.TotalSeconds);
                if (TubeSums.HasOverflown(read))
                {
                    // A list was full: the slices are traced again in smaller ones.
                    max = Math.Max(1, count / 2);
                    if (count == 1)
                        throw new GlintException($"{_owner}: one cell of the grid has too many parts at this tolerance: "
                            + "ask for a larger one");
                    continue;
                }
                add(read);
                for (int i = 0; i < jobs.Length; i++)
                    if (slices[i].Count > 0)
                        jobs[i].Took(slices[i].Count, TubeSums.RaysOf(read, i));
                left -= count;
                max = Math.Min(CellCapacity(pose), max + max / 2);
                progress?.Report((double)(all - left) / all);
            }
        }

        // The next slice of each pose, cells in all at most.
        (long First, int Count)[] SlicesOf(TubeJob[] jobs, long max)
        {
            var slices = new (long First, int Count)[jobs.Length];
            double rays = (double)_lists * RaysAList;
            int sum = 0;
            for (int i = 0; i < jobs.Length; i++)
            {
                slices[i] = (jobs[i].Next, jobs[i].SliceOf(sum == 0 ? 1 : 0, max - sum, ref rays));
                sum += slices[i].Count;
            }
            return slices;
        }

        int ListCapacity => _lists * ListElements;

        // Cells of a dispatch, whose corners are kept.
        int CellCapacity(CrossSectionPose pose) =>
            _lists * CornerElements / pose.MaxBounces / TubeKernels.BlockCorners * TubeKernels.BlockCells;

        // Traces the edges, as many pieces at a time as the list of tubes holds.
        void TraceEdges(TubeJob[] jobs, int outputSize, Action<uint[]> add, CancellationToken cancel)
        {
            var pose = jobs[0].Pose;
            if (!pose.HasEdges || pose.OnlyBounce != 0)
                return;
            var read = new uint[outputSize];
            // Shadow rays start clear of faces that meet at an edge up to that tolerance.
            double offset = WedgeFinder.RelativeTolerance * math.distance(_scene.Min, _scene.Max);
            int receivers = jobs.Length * pose.Receivers.Length, max = ListCapacity / receivers;
            for (int first = 0; first < _edges.Count; first += max)
            {
                cancel.ThrowIfCancellationRequested();
                _kernels.Clear(read.Length);
                int count = Math.Min(max, _edges.Count - first);
                _kernels.TraceEdges(_edges, first, count, receivers, offset);
                _output.ReadBack(read, read.Length);
                add(read);
            }
        }

        /// <summary>Releases all buffers on the device.</summary>
        public void Dispose()
        {
            _kernels.Dispose();
            _sea.Dispose();
            _levels.Dispose();
            _scene.Dispose();
            _surfaces.Dispose();
            _edges.Dispose();
            _output.Dispose();
            _tubes.Dispose();
            _tubeParts.Dispose();
            _tubeRates.Dispose();
            _cells.Dispose();
            _corners.Dispose();
            _borders.Dispose();
            _marks.Dispose();
            _links.Dispose();
            _waveNumbers.Dispose();
        }
    }
}
