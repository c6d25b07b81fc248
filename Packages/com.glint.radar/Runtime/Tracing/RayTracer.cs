using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Numerics;
using System.Threading;
using Glint.Core;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// Traces a radar's rays through a scene's triangles on the GPU. It owns the buffers and has no GameObjects: a test
    /// can make one from a kernel and an array of triangles.
    /// </summary>
    public sealed class RayTracer : IDisposable
    {
        static readonly ProfilerMarker s_build = new ProfilerMarker("Glint.Build");
        static readonly ProfilerMarker s_trace = new ProfilerMarker("Glint.Trace");

        readonly string _owner;
        readonly TraceKernel _kernel;
        readonly bool _isSoftware;
        readonly DeviceScene _scene;
        readonly DeviceBuffer<uint> _cells = new DeviceBuffer<uint>("cells of tiles");
        readonly DeviceBuffer<uint4> _entryPoints = new DeviceBuffer<uint4>("entry points of cells");
        readonly SliceOutput _output;
        readonly SlicePass _slices;
        readonly PathPass _paths;
        readonly DispatchPacer _pacer = new DispatchPacer();
        readonly List<PoseInFlight> _inFlight = new List<PoseInFlight>();
        readonly Stopwatch _clock = Stopwatch.StartNew();
        TimeSpan _lastFinished;
        bool _neededLists; // by the pose finished last, without rays kept
        ReceivedRayList _received = new ReceivedRayList();

        /// <param name="shader">Shaders/Trace.compute.</param>
        /// <param name="owner">Name of the owner, for messages.</param>
        /// <exception cref="GlintException">There is no graphics device, or it cannot run the kernel.</exception>
        public RayTracer(ComputeShader shader, string owner = nameof(RayTracer))
            : this(shader, owner, SoftwareDevice.UsesWideKernels)
        {
        }

        /// <param name="asSoftware">
        /// Use the BVH layout and kernels for software devices, with the same results.
        /// </param>
        /// <param name="maxRowsPerPage">Limit of rows of one page, in addition to the device's.</param>
        internal RayTracer(ComputeShader shader, string owner, bool asSoftware, long maxRowsPerPage = long.MaxValue)
        {
            _owner = owner;
            _isSoftware = asSoftware;
            _kernel = new TraceKernel(shader, _isSoftware, owner);
            _output = new SliceOutput(owner);
            _slices = new SlicePass(_kernel, new StageKernels(shader), _output);
            if (!SlicePass.IsIndirect)
                UnityEngine.Debug.LogWarning($"{owner}: {SystemInfo.graphicsDeviceName} does not count its own work "
                    + "(no indirect dispatch): a pose takes four round trips to the device instead of one");
            _scene = new DeviceScene(_isSoftware ? BvhLayout.Wide : BvhLayout.Binary, owner, maxRowsPerPage);
            _paths = new PathPass(_kernel, _scene);
        }

        /// <summary>Refuses a shader or device that cannot trace.</summary>
        /// <inheritdoc cref="RayTracer(ComputeShader, string)"/>
        public static void Check(ComputeShader shader, string owner) =>
            _ = new TraceKernel(shader, SoftwareDevice.UsesWideKernels, owner);

        /// <summary>
        /// Counts the nodes visited and pairs tested: <see cref="TraceStatistics"/>. Slower, as every segment starts at
        /// the root of an instance BVH; for benchmarks.
        /// </summary>
        public bool CountVisits { get; set; }

        /// <summary>Tiles of a dispatch, for tests; 0: by the times of earlier dispatches.</summary>
        internal int TilesADispatch { get; set; }

        /// <summary>Number of pages of the scene's BVHs.</summary>
        internal int PageCount => _scene.Pages.Count;

        /// <summary>Enabled culling: all, except in tests.</summary>
        public Culling Culling { get; set; } = Culling.All;

        /// <summary>Traces one pose: builds missing BVHs, traces slice by slice, and sums received rays.</summary>
        /// <param name="readback">Rays that the result carries.</param>
        /// <param name="progress">Receives the fraction done, 0 to 1, after each slice.</param>
        /// <param name="cancel">Cancels while BVHs are built, or after the current slice.</param>
        /// <param name="statistics">Figures of the gathering, to which those of the trace are added.</param>
        /// <exception cref="GlintException">
        /// A setting is out of its range, or the memory does not suffice for the scene or the rays read back.
        /// </exception>
        /// <exception cref="OperationCanceledException">The pose was cancelled.</exception>
        public RadarResult Trace(in RadarPose pose, RayReadback readback, IProgress<double> progress = null,
            CancellationToken cancel = default, TraceStatistics statistics = null) =>
            Finish(Start(pose, readback, cancel, statistics), progress, cancel);

        /// <summary>
        /// Begins a pose: builds missing BVHs and dispatches the first slice. The next pose may start before this one
        /// is finished.
        /// </summary>
        /// <inheritdoc cref="Trace"/>
        internal PoseInFlight Start(in RadarPose pose, RayReadback readback, CancellationToken cancel = default,
            TraceStatistics statistics = null)
        {
            Validate(pose);
            DispatchPlan.Check(pose.Settings, readback, _owner);
            statistics ??= new TraceStatistics();
            statistics.Triangles = pose.Scene.TriangleCount;
            int inputs = ++_kernel.Inputs;
            SetScene(pose.Scene, statistics, cancel);
            using (s_trace.Auto())
            {
                if (_output.IsTooSmall(_received.Count))
                {
                    Wait();
                    _output.Grow(_received.Count);
                }
                var grid = new RayGrid(pose.Settings, pose.View, _scene.Min, _scene.Max);
                var inFlight = new PoseInFlight
                {
                    Started = _clock.Elapsed, Inputs = inputs,
                    Pose = pose, Readback = readback, Grid = grid, Sums = new ChannelSums(grid),
                    Rays = new RayReadbackBuffer(readback, pose.Settings, _owner),
                    Plan = UploadTiles(pose, readback, statistics), Statistics = statistics
                };
                Bind(inFlight);
                inFlight.Dispatching = _clock.Elapsed - inFlight.Started;
                if (inFlight.Plan.Next())
                    Dispatch(inFlight);
                _inFlight.Add(inFlight);
                return inFlight;
            }
        }

        /// <summary>Finishes a pose: reads back its slices, and dispatches those after the first.</summary>
        /// <inheritdoc cref="Trace"/>
        internal RadarResult Finish(PoseInFlight inFlight, IProgress<double> progress = null,
            CancellationToken cancel = default)
        {
            _inFlight.Remove(inFlight);
            var (begin, dispatching) = (_clock.Elapsed, inFlight.Dispatching);
            using (s_trace.Auto())
            {
                var (pose, statistics) = (inFlight.Pose, inFlight.Statistics);
                uint[] words = null;
                for (bool more = inFlight.Slice != null; more; more = inFlight.Plan.Next())
                {
                    cancel.ThrowIfCancellationRequested();
                    if (words != null)
                        Dispatch(inFlight);
                    words = WordsOf(inFlight, inFlight.Slice);
                    bool needsLists = NeedsLists(inFlight, CountsOf(inFlight, words));
                    _neededLists = needsLists && inFlight.Readback == RayReadback.None;
                    // Another pose, of any tracer, has set the kernels' inputs since.
                    if (needsLists && inFlight.Inputs != _kernel.Inputs)
                        return Trace(pose, inFlight.Readback, progress, cancel, statistics);
                    inFlight.Plan.Traced(SecondsSince(inFlight.Dispatched));
                    words = AddSlice(inFlight, words, cancel);
                    progress?.Report(inFlight.Plan.Done);
                }

                var total = inFlight.Sums.ToSums(pose.Settings, pose.View);
                var sampling = EstimateSampling(inFlight, total, words, cancel);
                var rays = inFlight.Rays.ToArray();
                inFlight.Finishing =
                    _clock.Elapsed - begin - (inFlight.Dispatching - dispatching) - inFlight.ReadingBack;
                Complete(inFlight);
                _lastFinished = _clock.Elapsed;
                _received = inFlight.Received;
                return new RadarResult(total, sampling, rays, statistics);
            }
        }

        /// <summary>Gives up a pose that will not be finished.</summary>
        internal void Abandon(PoseInFlight inFlight)
        {
            if (_inFlight.Remove(inFlight))
                inFlight.Slice?.Complete();
        }

        /// <summary>Whether a pose was started and not finished, and the tracer's buffers are those of its start.</summary>
        internal bool IsInFlight(PoseInFlight inFlight) => _inFlight.Contains(inFlight);

        /// <summary>
        /// Whether the next pose may start before this one is finished: it needs no more than its read-back, nor did
        /// the pose finished last.
        /// </summary>
        internal bool MayOverlap(PoseInFlight inFlight) => inFlight.Readback == RayReadback.None
            && (inFlight.Slice == null || inFlight.Plan.IsWhole) && !_neededLists;

        /// <summary>Pixels of the rays received in the pose last traced, in ascending order.</summary>
        public uint[] ReceivedPixels() => _received.Pixels();

        /// <summary>
        /// Traces the paths of single rays in double-float arithmetic, in the order of the given pixels.
        /// </summary>
        /// <param name="pixels">x + y * rays across; x from the left, y from the bottom of the whole picture.</param>
        /// <param name="progress">Receives the fraction done, 0 to 1; may be null.</param>
        /// <param name="cancel">Cancels after the current dispatch.</param>
        /// <exception cref="GlintException">A setting is out of its range, or a pixel outside the picture.</exception>
        /// <exception cref="OperationCanceledException">Cancelled.</exception>
        public RayPath[] TracePaths(in RadarPose pose, uint[] pixels, IProgress<double> progress = null,
            CancellationToken cancel = default)
        {
            Validate(pose);
            var settings = pose.Settings;
            foreach (uint pixel in pixels)
                if (pixel >= settings.RayCount)
                    throw new GlintException($"{_owner}: there is no pixel {pixel} in a picture of "
                        + $"{settings.RaysAcross} x {settings.RaysDown} rays: "
                        + "pixels count from 0, row by row");
            _kernel.Inputs++;
            SetScene(pose.Scene, new TraceStatistics(), cancel);
            var grid = new RayGrid(settings, pose.View, _scene.Min, _scene.Max);
            _kernel.SetRadar(settings, pose.View, grid, pose.Scene.Origin, 0, Culling & ~Culling.EntryPoints);
            return _paths.Follow(pose, grid, pixels, progress, cancel);
        }

        /// <summary>Releases all buffers on the device.</summary>
        public void Dispose()
        {
            Wait();
            _inFlight.Clear();
            _paths.Dispose();
            _slices.Dispose();
            _output.Dispose();
            _entryPoints.Dispose();
            _cells.Dispose();
            _scene.Dispose();
        }

        void Validate(in RadarPose pose)
        {
            if (pose.Scene == null)
                throw new ArgumentException("RayTracer: the pose has no scene");
            pose.Settings.Validate(_owner);
            pose.View.Validate(_owner);
        }

        // Builds BVHs for new meshes; an unchanged mesh, moved or not, costs nothing.
        void SetScene(RadarScene scene, TraceStatistics statistics, CancellationToken cancel)
        {
            var watch = Stopwatch.StartNew();
            double buildMs = 0;
            MeshBvh Build(TriangleMesh mesh, BvhLayout layout)
            {
                var building = Stopwatch.StartNew();
                using (s_build.Auto())
                {
                    var bvh = MeshBvh.Build(mesh, layout, cancel);
                    buildMs += building.Elapsed.TotalMilliseconds;
                    return bvh;
                }
            }
            if (_scene.Set(scene, statistics, Build))
                _pacer.Reset();
            var timings = statistics.Timings;
            (timings.BuildMs, timings.UploadMs) = (buildMs, watch.Elapsed.TotalMilliseconds - buildMs);
            statistics.Timings = timings;
        }

        // Uploads the cells of the tiles to trace.
        DispatchPlan UploadTiles(in RadarPose pose, RayReadback readback, TraceStatistics statistics)
        {
            var picture = new PictureTiles(pose.Settings, pose.View);
            // Reading back all rays includes misses. Otherwise an empty scene needs no kernel, whose compilation is
            // slow on a software device.
            if (readback == RayReadback.All || (Culling & Culling.Tiles) == 0 && !_scene.IsEmpty)
                picture.AddAll();
            else
                _scene.AddTo(picture);
            var cells = picture.ToCells(_isSoftware);
            statistics.TilesTraced = cells.TilesInRegion;
            statistics.TilesSkipped = picture.Count - cells.TilesInRegion;
            _cells.Upload(cells.Corners);
            _kernel.SetCellSize(cells.Size);
            statistics.BytesUploaded += cells.Corners.Length * (long)_cells.Stride;
            bool usesEntryPoints = _scene.HasInlineInstances && !CountVisits && (Culling & Culling.EntryPoints) != 0
                && DispatchPlan.EntryPointsPay(cells.TileCount, _isSoftware);
            return new DispatchPlan(pose.Settings, readback, cells, usesEntryPoints, _pacer, TilesADispatch);
        }

        void Bind(PoseInFlight inFlight)
        {
            var pose = inFlight.Pose;
            _kernel.Choose(_scene, CountVisits);
            _kernel.SetRadar(pose.Settings, pose.View, inFlight.Grid, pose.Scene.Origin, inFlight.Sums.LengthUnits,
                inFlight.Plan.UsesEntryPoints ? Culling : Culling & ~Culling.EntryPoints);
            _kernel.SetScene(_scene);
        }

        // Dispatches the plan's slice, and requests what it leaves.
        void Dispatch(PoseInFlight inFlight)
        {
            var (plan, statistics, settings) = (inFlight.Plan, inFlight.Statistics, inFlight.Pose.Settings);
            var begin = _clock.Elapsed;
            inFlight.HasSubRays =
                plan.IsWhole && !settings.SkipSamplingError && SlicePass.CanChooseSubRays(settings);
            _slices.Begin(settings, _cells, plan.Count, inFlight.Readback, inFlight.HasSubRays);
            inFlight.KnownCapacity = _slices.Candidates.KnownCapacity;
            FindEntryPoints(plan, statistics);
            _slices.TraceTiles(plan.First, plan.Count, statistics);
            if (inFlight.HasSubRays)
                _slices.ChooseAndTraceSubRays(statistics);
            inFlight.Slice = _output.Request(statistics);
            inFlight.Dispatched = _clock.Elapsed;
            inFlight.Dispatching += inFlight.Dispatched - begin;
        }

        uint[] WordsOf(PoseInFlight inFlight, Readback slice)
        {
            var begin = _clock.Elapsed;
            slice.Wait();
            inFlight.ReadingBack += _clock.Elapsed - begin;
            return _output.WordsOf(slice);
        }

        // Waits for all poses in flight, before a buffer that is read back is released.
        void Wait()
        {
            foreach (var inFlight in _inFlight)
                inFlight.Slice?.Complete();
        }

        // Time that a pose or slice took by itself: it begins at the end of the one before.
        double SecondsSince(TimeSpan start) =>
            (_clock.Elapsed - (start > _lastFinished ? start : _lastFinished)).TotalSeconds;

        static WorkCounts CountsOf(PoseInFlight inFlight, uint[] words) => new WorkCounts(words, inFlight.KnownCapacity);

        // Whether more is to be read from, or dispatched with, the slice's lists on the device.
        bool NeedsLists(PoseInFlight inFlight, WorkCounts counts) =>
            !inFlight.Plan.IsWhole || inFlight.Readback != RayReadback.None || counts.Received > _output.Capacity
            || CandidateList.FirstSearched(counts.Known, counts.Searched) < counts.Searched
            || !inFlight.Pose.Settings.SkipSamplingError && !HasAllSubRays(inFlight, counts);

        bool HasAllSubRays(PoseInFlight inFlight, WorkCounts counts) =>
            inFlight.HasSubRays && counts.Chosen <= SlicePass.MaxChosen
            && _slices.Candidates.Threads(counts.Known, counts.Searched) < CandidateList.MaxRefined;

        // Adds the slice to the pose. Returns its words after the last of its dispatches.
        uint[] AddSlice(PoseInFlight inFlight, uint[] words, CancellationToken cancel)
        {
            var statistics = inFlight.Statistics;
            var counts = CountsOf(inFlight, words);
            inFlight.Rays.AddReceived(_slices.Rays, counts.Received, statistics);
            int done = CandidateList.FirstSearched(counts.Known, counts.Searched);
            for (; done < counts.Searched; done += CandidateList.MaxRefined)
            {
                cancel.ThrowIfCancellationRequested();
                int received = counts.Received;
                _slices.RefineRest(done, counts.Searched - done, received, statistics);
                words = WordsOf(inFlight, _output.Request(statistics));
                counts = CountsOf(inFlight, words);
                inFlight.Rays.AddReceived(_slices.Rays, counts.Received - received, statistics);
            }
            inFlight.Rays.AddTiles(_slices.Rays, inFlight.Plan.Count, statistics);
            inFlight.Sums.Add(words);
            if (counts.Received <= _output.Capacity)
                inFlight.Received.Add(words, counts.Received);
            else
                inFlight.Received.Add(_slices.ReadReceived(counts, statistics));
            statistics.RaysRefined += counts.Known + counts.Searched;
            return words;
        }

        // Estimates the sampling error by sub-rays: those of the slice, or of pixels chosen here.
        SamplingReport? EstimateSampling(PoseInFlight inFlight, RadarSums total, uint[] words, CancellationToken cancel)
        {
            var (settings, statistics) = (inFlight.Pose.Settings, inFlight.Statistics);
            cancel.ThrowIfCancellationRequested();
            if (settings.SkipSamplingError)
                return null;
            var counts = words == null ? default : CountsOf(inFlight, words);
            bool areTraced = words != null && HasAllSubRays(inFlight, counts);
            var estimate = new SamplingEstimate(settings, inFlight.Received.Rays, inFlight.Received.Count,
                2 * inFlight.Grid.OriginDepth, areTraced);
            var pixels = estimate.PixelsToRefine;
            double[] inPhase = new double[SamplingEstimate.SubGrids],
                quadrature = new double[SamplingEstimate.SubGrids];
            if (areTraced)
                ChannelSums.AddSubRays(words, inPhase, quadrature);
            else
                for (int first = 0; first < pixels.Length; first += SlicePass.MaxChosen)
                {
                    cancel.ThrowIfCancellationRequested();
                    _slices.TraceSubRays(pixels, first, Math.Min(pixels.Length - first, SlicePass.MaxChosen),
                        statistics);
                    ChannelSums.AddSubRays(WordsOf(inFlight, _output.Request(statistics)), inPhase, quadrature);
                }
            statistics.SubRays = (areTraced ? counts.Chosen : pixels.Length) * (long)SamplingEstimate.SubGrids;
            return estimate.Finish(new Complex(total.InPhase, total.Quadrature), total.RaysOfPicture, inPhase,
                quadrature);
        }

        void FindEntryPoints(DispatchPlan plan, TraceStatistics statistics)
        {
            _entryPoints.Reserve(plan.UsesEntryPoints ? (long)plan.Cells * DeviceScene.MaxInlineInstances : 1);
            _kernel.SetEntryPoints(_entryPoints);
            if (!plan.UsesEntryPoints)
                return;
            _kernel.FindEntryPoints(_scene, _cells, plan, _entryPoints);
            statistics.Dispatches++;
        }

        void Complete(PoseInFlight inFlight)
        {
            var statistics = inFlight.Statistics;
            if (CountVisits)
                (statistics.NodesVisited, statistics.PairsTested) =
                    (inFlight.Sums.Units(Channel.Nodes), inFlight.Sums.Units(Channel.Pairs));
            statistics.BytesOnDevice = _scene.Bytes + _cells.Bytes + _entryPoints.Bytes + _output.Buffer.Bytes
                + _slices.BytesOnDevice;
            var timings = statistics.Timings;
            (timings.TraceMs, timings.ReadBackMs) =
                (1000 * SecondsSince(inFlight.Started), inFlight.Rays.ReadBackMs);
            (timings.DispatchMs, timings.WaitMs, timings.FinishMs) = (inFlight.Dispatching.TotalMilliseconds,
                inFlight.ReadingBack.TotalMilliseconds, inFlight.Finishing.TotalMilliseconds);
            statistics.Timings = timings;
        }
    }
}
