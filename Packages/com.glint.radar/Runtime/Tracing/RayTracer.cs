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
    /// Traces a radar's rays through a scene's triangles on the GPU. It owns the buffers and knows no GameObjects:
    /// a test can make one from a kernel and an array of triangles.
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
        /// <param name="owner">Whose it is, for messages.</param>
        /// <exception cref="GlintException">There is no graphics device, or it cannot run the kernel.</exception>
        public RayTracer(ComputeShader shader, string owner = nameof(RayTracer))
            : this(shader, owner, SoftwareDevice.UsesWideKernels)
        {
        }

        /// <param name="asSoftware">
        /// Trace as suits a software device: another BVH and kernel, the same results.
        /// </param>
        /// <param name="maxRowsPerPage">Rows of BVHs that one buffer may hold, as if the device took no more.</param>
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

        /// <summary>
        /// Count the nodes visited and pairs tested: <see cref="TraceStatistics"/>.
        /// Slower, as every segment is searched from the root of a BVH over all instances; for benchmarks.
        /// </summary>
        public bool CountVisits { get; set; }

        /// <summary>Tiles of the next dispatches; 0, except in tests: as the time that they take suggests.</summary>
        internal int TilesADispatch { get; set; }

        /// <summary>Buffers that hold the scene's BVHs.</summary>
        internal int PageCount => _scene.Pages.Count;

        /// <summary>What may be skipped without changing a result: all, except in tests that show it.</summary>
        internal Culling Culling { get; set; } = Culling.All;

        /// <summary>One pose: builds BVHs that are missing, traces slice by slice, and sums what is received.</summary>
        /// <param name="readback">Which rays the result carries one by one.</param>
        /// <param name="progress">Is told the part that is done, 0 to 1, after each slice.</param>
        /// <param name="cancel">Ends the pose while BVHs are built, or after the slice in hand.</param>
        /// <exception cref="GlintException">
        /// A setting is out of its range, or the device cannot hold the scene or the rays that are to be kept.
        /// </exception>
        /// <exception cref="OperationCanceledException">The pose was cancelled.</exception>
        public RadarResult Trace(in RadarPose pose, RayReadback readback, IProgress<double> progress = null,
            CancellationToken cancel = default)
        {
            Validate(pose);
            DispatchPlan.Check(pose.Settings, readback, _owner);
            var statistics = new TraceStatistics { Triangles = pose.Scene.TriangleCount };
            SetScene(pose.Scene, statistics, cancel);

            var watch = Stopwatch.StartNew();
            using (s_trace.Auto())
            {
                var grid = new RayGrid(pose.Settings, pose.View, _scene.Min, _scene.Max);
                var sums = new ChannelSums(grid);
                var readbackBuffer = new RayReadbackBuffer(readback, pose.Settings, _owner);
                var plan = UploadTiles(pose, readback, statistics);
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
        /// The paths of single rays, in the order of their pixels in the list.
        /// Every ray is followed in double-float arithmetic.
        /// </summary>
        /// <param name="pixels">x + y * rays across; x from the left, y from the bottom of the whole picture.</param>
        /// <param name="progress">Is told the part that is done, 0 to 1; may be null.</param>
        /// <param name="cancel">Ends the work after the dispatch in hand.</param>
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
                        + "pixels count from 0, a row after the other");
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

        // BVHs are built for meshes that are new; a mesh that stays, moved or not, costs nothing.
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
            statistics.Timings =
                new Timings { BuildMs = buildMs, UploadMs = watch.Elapsed.TotalMilliseconds - buildMs };
        }

        // Brings the tiles to trace to the device.
        DispatchPlan UploadTiles(in RadarPose pose, RayReadback readback, TraceStatistics statistics)
        {
            var picture = new PictureTiles(pose.Settings, pose.View);
            // All rays include those that hit nothing.
            if (readback == RayReadback.All || (Culling & Culling.Tiles) == 0)
                picture.AddAll();
            else
                _scene.AddTo(picture);
            // A kernel that finds nothing at all takes a software device long to compile, and for nothing.
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

        // Returns how many of the slice's rays may be received.
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
