using System;
using System.Diagnostics;
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
        readonly DeviceBuffer<uint> _tiles = new DeviceBuffer<uint>("tiles of 64 rays");
        readonly DeviceBuffer<uint4> _entryPoints = new DeviceBuffer<uint4>("tiles of 64 rays");
        readonly DeviceBuffer<RayData> _rays = new DeviceBuffer<RayData>("rays kept one by one");
        readonly SumBuffer _sums;
        readonly RefinePass _refine;
        readonly SamplingPass _sampling;
        readonly PathPass _paths;
        readonly DispatchPacer _pacer = new DispatchPacer();

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
            _sums = new SumBuffer(owner);
            _refine = new RefinePass(_kernel, _sums, _rays);
            _sampling = new SamplingPass(_kernel, _sums, _rays);
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

        /// <summary>Rays a triangle after which a BVH gets horizons; fewer in tests.</summary>
        internal long HorizonRaysATriangle { get; set; } = 256;

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
            CancellationToken cancel = default, TraceStatistics statistics = null)
        {
            Validate(pose);
            DispatchPlan.Check(pose.Settings, readback, _owner);
            statistics ??= new TraceStatistics();
            statistics.Triangles = pose.Scene.TriangleCount;
            SetScene(pose.Scene, statistics, cancel);

            var watch = Stopwatch.StartNew();
            using (s_trace.Auto())
            {
                var grid = new RayGrid(pose.Settings, pose.View, _scene.Min, _scene.Max);
                var sums = new ChannelSums(grid);
                var readbackBuffer = new RayReadbackBuffer(readback, pose.Settings, _owner);
                var plan = UploadTiles(pose, readback, statistics);
                if (!_isSoftware && (Culling & Culling.Horizons) != 0)
                    _scene.FindHorizons(_kernel, statistics.TilesTraced * PictureTiles.Rays, HorizonRaysATriangle,
                        statistics);
                Bind(pose, grid, sums.LengthUnits, plan.UsesEntryPoints);
                _refine.Begin();
                while (plan.Next())
                {
                    cancel.ThrowIfCancellationRequested();
                    FindEntryPoints(plan, statistics);
                    int candidates = TraceSlice(plan, sums, readbackBuffer, statistics);
                    plan.Traced();
                    _refine.Follow(candidates, sums, readbackBuffer, statistics, cancel);
                    readbackBuffer.AddTiles(_rays, plan.Count, statistics);
                    progress?.Report(plan.Done);
                }

                var total = sums.ToSums(pose.Settings, pose.View);
                SamplingReport? sampling = pose.Settings.SkipSamplingError
                    ? (SamplingReport?)null
                    : _sampling.Estimate(pose.Settings, _refine.Received, _refine.ReceivedCount, 2 * grid.OriginDepth,
                        total, statistics, cancel);
                var rays = readbackBuffer.ToArray();
                Complete(statistics, sums, watch.Elapsed.TotalMilliseconds, readbackBuffer.ReadBackMs);
                return new RadarResult(total, sampling, rays, statistics);
            }
        }

        /// <summary>Pixels of the rays received in the pose last traced, in ascending order.</summary>
        public uint[] ReceivedPixels() => _refine.ReceivedPixels();

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
            SetScene(pose.Scene, new TraceStatistics(), cancel);
            var grid = new RayGrid(settings, pose.View, _scene.Min, _scene.Max);
            _kernel.SetRadar(settings, pose.View, grid, pose.Scene.Origin, 0, Culling & ~Culling.EntryPoints);
            return _paths.Follow(pose, grid, pixels, progress, cancel);
        }

        /// <summary>Releases all buffers on the device.</summary>
        public void Dispose()
        {
            _paths.Dispose();
            _sampling.Dispose();
            _refine.Dispose();
            _rays.Dispose();
            _sums.Dispose();
            _entryPoints.Dispose();
            _tiles.Dispose();
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

        // Uploads the list of tiles to trace.
        DispatchPlan UploadTiles(in RadarPose pose, RayReadback readback, TraceStatistics statistics)
        {
            var picture = new PictureTiles(pose.Settings, pose.View);
            // Reading back all rays includes misses.
            if (readback == RayReadback.All || (Culling & Culling.Tiles) == 0)
                picture.AddAll();
            else
                _scene.AddTo(picture);
            // An empty scene needs no kernel, whose compilation is slow on a software device.
            var tiles =
                _scene.IsEmpty && readback != RayReadback.All ? Array.Empty<uint>() : picture.ToArray(_isSoftware);
            statistics.TilesTraced = tiles.Length;
            statistics.TilesSkipped = picture.Count - tiles.Length;
            _tiles.Upload(tiles);
            statistics.BytesUploaded += tiles.Length * (long)_tiles.Stride;
            bool usesEntryPoints = _scene.HasInlineInstances && !CountVisits && (Culling & Culling.EntryPoints) != 0
                && DispatchPlan.EntryPointsPay(tiles.Length, _isSoftware);
            return new DispatchPlan(pose.Settings, readback, tiles.Length, usesEntryPoints, _pacer, TilesADispatch);
        }

        void Bind(in RadarPose pose, RayGrid grid, float lengthUnits, bool usesEntryPoints)
        {
            _kernel.Choose(_scene, CountVisits);
            _kernel.SetRadar(pose.Settings, pose.View, grid, pose.Scene.Origin, lengthUnits,
                usesEntryPoints ? Culling : Culling & ~Culling.EntryPoints);
            _kernel.SetScene(_scene);
            _kernel.SetBuffers(_tiles, _sums.Buffer);
        }

        void FindEntryPoints(DispatchPlan plan, TraceStatistics statistics)
        {
            _entryPoints.Reserve(plan.UsesEntryPoints ? (long)plan.Count * DeviceScene.MaxInlineInstances : 1);
            _kernel.SetEntryPoints(_entryPoints);
            if (!plan.UsesEntryPoints)
                return;
            _kernel.FindEntryPoints(_scene, _tiles, plan.First, plan.Count, _entryPoints);
            statistics.Dispatches++;
        }

        // Returns the number of candidates.
        int TraceSlice(DispatchPlan plan, ChannelSums sums, RayReadbackBuffer readback, TraceStatistics statistics)
        {
            _refine.Reserve(plan.Count);
            readback.Reserve(_rays, plan.Count);
            _sums.Clear(statistics);
            _kernel.Dispatch(plan.First, plan.Count, readback.Mode, _refine.Candidates, _rays);
            var words = _sums.ReadBack(statistics);
            sums.Add(words);
            return ChannelSums.CandidatesOf(words);
        }

        void Complete(TraceStatistics statistics, ChannelSums sums, double traceMs, double readBackMs)
        {
            if (CountVisits)
                (statistics.NodesVisited, statistics.PairsTested) =
                    (sums.Units(Channel.Nodes), sums.Units(Channel.Pairs));
            statistics.BytesOnDevice = _scene.Bytes + _tiles.Bytes + _entryPoints.Bytes
                + _sums.Buffer.Bytes + _rays.Bytes
                + _refine.Bytes + _sampling.Bytes;
            var timings = statistics.Timings;
            (timings.TraceMs, timings.ReadBackMs) = (traceMs, readBackMs);
            statistics.Timings = timings;
        }
    }
}
