using System;
using System.Collections.Generic;
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
        // Error that a cell may have, as a fraction of what a conducting plate of a square wavelength returns: at first a
        // part of the tolerance, within limits; and at least.
        const double PartOfTolerance = 0.5, MinFirstCellError = 1.0 / 64, MaxFirstCellError = 1.0 / 8,
            MinCellError = 1.0 / (1 << 17);

        // Distance of shadow rays from the faces at their edge, in the diagonal of the scene's box: 30 times the rounding of
        // float32.
        const double RelativeEdgeOffset = 2e-6;

        // Base cells that a piece of a silhouette is long: what hides less of it from its receiver, or of its shadow from the
        // radar, is found at its middle alone.
        const double SilhouetteCells = 0.5;

        readonly string _owner;
        readonly TubeTracer _tubes;
        readonly DeviceScene _scene;
        readonly SurfaceBuffers _surfaces = new SurfaceBuffers();
        readonly EdgeBuffers _edges = new EdgeBuffers();
        readonly SeaKernel _sea;
        readonly SeaLevels _levels;
        readonly ShipSeaKernel _shipSea;
        SceneAhead _ahead;

        /// <param name="shader">Shaders/Tubes.compute.</param>
        /// <param name="owner">Name of the owner, for messages.</param>
        /// <exception cref="GlintException"><see cref="Check"/> refuses device or shader.</exception>
        public CrossSectionTracer(ComputeShader shader, string owner = nameof(CrossSectionTracer))
        {
            Check(shader, owner);
            _owner = owner;
            _tubes = new TubeTracer(shader, owner);
            _sea = new SeaKernel(shader, owner);
            _levels = new SeaLevels(shader, owner);
            _shipSea = new ShipSeaKernel(shader);
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

        /// <summary>Poses of a dispatch at most, for tests.</summary>
        internal int PosesTogether { get; set; } = PosesOfADispatch;

        /// <summary>Cells of a dispatch, for tests; 0: by the times of earlier dispatches.</summary>
        internal int CellsADispatch { set => _tubes.CellsADispatch = value; }

        /// <summary>Takes what was begun of the scene of the next poses, in their crease angle.</summary>
        internal void Expect(SceneAhead ahead) => _ahead = ahead;

        /// <summary>Poses that are traced together at most; a single one fills a software device.</summary>
        public static int PosesOfADispatch => TubeTracer.MaxPoses;

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
            TubeGrid largest = null;
            foreach (var pose in poses)
            {
                var job = new TubeJob(pose, GridOf(pose));
                if (largest == null || job.Grid.Count > largest.Count)
                    largest = job.Grid;
                int most = pose.Scene.Seas.Count > 0 ? 1
                    : Math.Min(PosesTogether, TubeSums.MaxSlots / TubeSums.SlotsOf(pose));
                if (jobs.Count > 0
                    && (jobs.Count == most || !TubeTracer.FitsTogether(jobs.Count + 1, largest, job.Pose, _surfaces)))
                    break;
                jobs.Add(job);
            }
            return jobs.ToArray();
        }

        void TraceTogether(TubeJob[] jobs, IProgress<double> progress, CancellationToken cancel)
        {
            var pose = jobs[0].Pose;
            // Before the tubes' buffers are bound: it clears sums of its own.
            var clutter = Clutter(pose, cancel);
            var shipSea = clutter == null ? null : _shipSea.Sum(_scene, _surfaces, pose);
            _tubes.SumAll(jobs, _scene, _surfaces, read => AddTo(jobs, job => job.Edges, read));
            double floor = Math.Max(pose.FloorDbsm ?? CrossSectionFloor.Of(pose.Scene, _scene.Min, _scene.Max),
                FloorOf(clutter));
            TraceEdges(jobs, read => AddTo(jobs, job => job.Edges, read), cancel);
            foreach (var job in jobs)
            {
                double cellError = CellError > 0 ? CellError : FirstCellErrorOf(job);
                job.Begin(cellError, cellError);
            }
            while (jobs.Any(job => !job.IsDone))
            {
                cancel.ThrowIfCancellationRequested();
                _tubes.TraceSlice(jobs, read => AddTo(jobs, job => job.Sums, read));
                progress?.Report(jobs.Average(job => job.Fraction));
                foreach (var job in jobs.Where(job => !job.IsDone && job.Left == 0))
                    EndAttempt(job, clutter, shipSea, floor);
            }
        }

        void AddTo(TubeJob[] jobs, Func<TubeJob, TubeSums> sumsOf, uint[] read)
        {
            for (int i = 0; i < jobs.Length; i++)
                sumsOf(jobs[i]).Add(read, i, jobs.Length, _owner);
        }

        // Ends an attempt, and plans the next one if the error is too large.
        void EndAttempt(TubeJob job, ClutterEcho[] clutter, ClutterEcho[] shipSea, double floor)
        {
            var result = job.End();
            result.Add(clutter, shipSea);
            result.FloorDbsm = floor;
            result.WedgesLeftOut = job.Pose.HasEdges ? _edges.LeftOutCount : 0;
            double excess = Excess(result, job.Pose, isCross: false), crossExcess = Excess(result, job.Pose, isCross: true);
            result.IsMet = excess <= 1 && crossExcess <= 1;
            double next = NextCellError(job, job.CellError, excess), nextCross = NextCellError(job, job.CrossCellError, crossExcess);
            job.IsDone = result.IsMet || CellError > 0 || next == job.CellError && nextCross == job.CrossCellError;
            if (!job.IsDone)
                job.Begin(next, nextCross);
        }

        // Errors fall with the power 0.6 of that of a cell.
        static double NextCellError(TubeJob job, double cellError, double excess)
        {
            if (excess <= 1)
                return cellError;
            double step = Math.Ceiling(Math.Log(math.clamp(1.5 * Math.Pow(excess, 1.6), 2, 64), 2));
            return Math.Min(cellError, Math.Max(InBaseCells(job, MinCellError), cellError / Math.Pow(2, step)));
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

        /// <summary>Computes the factors of a pose's seas that have a published level, for later poses too.</summary>
        internal void SetLevels(CrossSectionPose pose)
        {
            foreach (var sea in pose.Scene.Seas)
                _levels.Of(pose, sea, pose.Frequencies[0], default);
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
            var job = new TubeJob(pose, GridOf(pose));
            var sums = new PartSums(_surfaces.Patches.Parts, TubeSums.OutputSize(pose, 1), job.Edges, receiver, frequency);
            _tubes.SumParts(job, _scene, _surfaces, sums, receiver, frequency);
            TraceEdges(new[] { job }, sums.Add, cancel);
            // Attempts before the last one reveal which cells it divides.
            int attempts = result.Attempts.Count;
            for (int attempt = 0; attempt < attempts; attempt++)
            {
                job.Begin(result.Attempts[attempt].CellError, result.Attempts[attempt].CrossCellError);
                while (job.Left > 0)
                {
                    cancel.ThrowIfCancellationRequested();
                    _tubes.TraceSlice(new[] { job }, attempt == attempts - 1 ? sums.Add : (Action<uint[]>)(_ => { }));
                    progress?.Report((attempt + job.Fraction) / attempts);
                }
            }
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
            _tubes.SumAll(new[] { job }, _scene, _surfaces, _ => { });
            job.Begin(1, 1);
            while (job.Left > 0)
            {
                cancel.ThrowIfCancellationRequested();
                _tubes.TracePoints(job, across, offset);
            }
            return job.Sums.ToResult();
        }

        // Largest ratio of an error to the one allowed, of the co-polarised or cross-polarised ones that are asked for.
        static double Excess(CrossSectionResult result, CrossSectionPose pose, bool isCross)
        {
            double excess = 0;
            var polarisations = pose.Polarisations.Where(polarisation => polarisation.IsCross == isCross).ToArray();
            for (int receiver = 0; receiver < result.S.GetLength(0); receiver++)
                for (int sample = 0; sample < result.S.GetLength(1); sample++)
                    excess = Math.Max(excess,
                        result.AccuracyOf(polarisations, receiver, sample).Excess(pose.ToleranceDb));
            return excess;
        }

        void SetScene(CrossSectionPose pose, CancellationToken cancel)
        {
            var ahead = _ahead;
            _ahead = null;
            _scene.Set(pose.Scene, new TraceStatistics(),
                (mesh, layout) => ahead?.BvhOf(mesh, cancel) ?? MeshBvh.Build(mesh, layout, cancel));
            if (_scene.IsEmpty)
                return;
            _scene.RequireOnePage(_owner, "a cross section takes");
            if (ahead != null)
                _surfaces.Patches.Know(pose.Scene, pose.CreaseDegrees, ahead.Patches());
            _surfaces.Set(pose.Scene, _scene.Centre, pose.CreaseDegrees, pose.CoefficientFrequency);
            if (!pose.IsMonostatic)
                _surfaces.Silhouettes.Set(pose.Scene, _surfaces.Patches.OfInstances, _scene.Centre,
                    SilhouetteCells * SideOf(pose));
            if (TubeKernels.HasImages(pose))
                _surfaces.Mirrors.Set(pose.Scene, _surfaces.Patches.OfInstances, _scene.Centre, SideOf(pose));
            if (pose.HasEdges)
                _edges.Set(pose.Scene, _surfaces.Patches.OfInstances, _surfaces.Patches.Parts, _scene.Centre,
                    TubeGrid.EdgePieceFor(pose), ahead, cancel);
        }

        double SideOf(CrossSectionPose pose) => TubeGrid.SideFor(pose, _scene.Min, _scene.Max);

        TubeGrid GridOf(CrossSectionPose pose) => new TubeGrid(pose, SideOf(pose), _scene.Min, _scene.Max);

        void TraceEdges(TubeJob[] jobs, Action<uint[]> add, CancellationToken cancel)
        {
            var pose = jobs[0].Pose;
            if (!pose.HasEdges || pose.OnlyBounce != 0)
                return;
            // Clear of the faces at an edge, which may be apart.
            double offset = 2 * _edges.Gap + RelativeEdgeOffset * math.distance(_scene.Min, _scene.Max);
            _tubes.TraceEdges(jobs, _edges, offset, add, cancel);
        }

        /// <summary>Releases all buffers on the device.</summary>
        public void Dispose()
        {
            _tubes.Dispose();
            _sea.Dispose();
            _levels.Dispose();
            _shipSea.Dispose();
            _scene.Dispose();
            _surfaces.Dispose();
            _edges.Dispose();
        }
    }
}
