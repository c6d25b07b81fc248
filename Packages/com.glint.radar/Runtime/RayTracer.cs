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
        const int TilesToFillAGpu = 100000;

        static readonly ProfilerMarker s_build = new ProfilerMarker("Glint.Build");
        static readonly ProfilerMarker s_trace = new ProfilerMarker("Glint.Trace");

        readonly string _owner;
        readonly TraceKernel _kernel;
        readonly bool _isSoftware;
        readonly DeviceScene _scene;
        readonly DeviceBuffer<uint> _tiles = new DeviceBuffer<uint>("tiles of 64 rays");
        readonly DeviceBuffer<uint4> _starts = new DeviceBuffer<uint4>("tiles of 64 rays");
        readonly DeviceBuffer<uint> _sums = new DeviceBuffer<uint>("sums");
        readonly DeviceBuffer<RayData> _rays = new DeviceBuffer<RayData>("rays kept one by one");
        readonly ExactPass _exact;
        readonly PathPass _paths;
        readonly DispatchPacer _pacer = new DispatchPacer();
        readonly uint[] _zeros = new uint[RaySums.Slots * RaySums.WordsPerSlot],
            _words = new uint[RaySums.Slots * RaySums.WordsPerSlot];
        WorkDone _sceneWork;
        double _buildMs, _uploadMs;

        /// <param name="shader">Shaders/Trace.compute.</param>
        /// <param name="owner">Whose it is, for messages.</param>
        /// <exception cref="GlintException">There is no graphics device, or it cannot run the kernel.</exception>
        public RayTracer(ComputeShader shader, string owner = nameof(RayTracer))
            : this(shader, owner, SoftwareDevice.UsesWideKernels)
        {
        }

        /// <param name="asSoftware">
        /// Trace as suits a software device: another tree and kernel, the same results.
        /// </param>
        /// <param name="mostRowsABank">Rows of trees that one buffer may hold, as if the device took no more.</param>
        internal RayTracer(ComputeShader shader, string owner, bool asSoftware, long mostRowsABank = long.MaxValue)
        {
            _owner = owner;
            _isSoftware = asSoftware;
            _kernel = new TraceKernel(shader, _isSoftware, owner);
            _exact = new ExactPass(_kernel, _sums, _rays);
            _scene = new DeviceScene(_isSoftware ? TreeShape.Wide : TreeShape.Binary, owner, mostRowsABank);
            _paths = new PathPass(_kernel, _scene);
            _sums.Reserve(_zeros.Length);
        }

        /// <summary>
        /// Count the nodes visited and pairs tested: <see cref="WorkDone"/>. Slower, as every segment is searched
        /// from the root of a tree over all instances; for benchmarks.
        /// </summary>
        public bool CountVisits { get; set; }

        /// <summary>Tiles of the next dispatches; 0, except in tests: as the time that they take suggests.</summary>
        internal int TilesADispatch { get; set; }

        /// <summary>Buffers that hold the scene's trees.</summary>
        internal int BankCount => _scene.Banks.Count;

        /// <summary>What may be skipped without changing a result: all, except in tests that show it.</summary>
        internal Shortcuts Shortcuts { get; set; } = Shortcuts.All;

        /// <summary>
        /// Takes the scene to trace from now on. Trees are built for meshes that are new;
        /// a mesh that stays, moved or not, costs nothing.
        /// </summary>
        /// <param name="cancel">Ends the building of trees.</param>
        /// <exception cref="GlintException">The device cannot hold it.</exception>
        /// <exception cref="OperationCanceledException">It was cancelled, and there is no scene.</exception>
        public void SetScene(RadarScene scene, CancellationToken cancel = default)
        {
            var watch = Stopwatch.StartNew();
            _sceneWork = default;
            _buildMs = 0;
            if (_scene.Set(scene, ref _sceneWork, (mesh, shape) => Build(mesh, shape, cancel)))
                _pacer.Reset();
            _uploadMs = watch.Elapsed.TotalMilliseconds - _buildMs;
        }

        /// <summary>Refuses what does not fit, before a scene is gathered or built for it.</summary>
        /// <exception cref="GlintException">
        /// The device cannot hold as many tiles, or this computer as many rays as are to be kept.
        /// </exception>
        public void CheckRoom(in RadarSettings settings, KeptRays keep) => CheckRoom(settings, keep, _owner);

        internal static void CheckRoom(in RadarSettings settings, KeptRays keep, string owner)
        {
            KeptRayList.Refuse(keep, settings, owner);
            long tiles = PictureTiles.CountIn(settings), most = DeviceBuffer<uint>.Most;
            if (tiles > most)
                throw new GlintException($"{owner}: the list of the picture's {tiles} tiles of 64 rays takes "
                    + $"{Text.Mebibytes(tiles * 4.0)}, and {SystemInfo.graphicsDeviceName} holds "
                    + $"{Text.Mebibytes(most * 4.0)} in one buffer: trace a region or fewer rays");
        }

        /// <summary>One pose: dispatches the kernel and sums what comes back.</summary>
        /// <param name="progress">Is told the part that is done, 0 to 1, after each dispatch.</param>
        /// <param name="cancel">Ends the pose after the dispatch in hand.</param>
        /// <exception cref="GlintException">
        /// A setting is out of its range, or the device cannot hold as many rays as are to be kept.
        /// </exception>
        /// <exception cref="OperationCanceledException">The pose was cancelled.</exception>
        public RadarResult Trace(in RadarSettings settings, in RadarView view, KeptRays keep,
            IProgress<double> progress = null, CancellationToken cancel = default)
        {
            if (_scene.Scene == null)
                throw new InvalidOperationException("RayTracer.Trace without a scene: call SetScene first");
            settings.Validate(_owner);
            view.Validate(_owner);
            CheckRoom(settings, keep);
            var result = new RadarResult
            {
                RaysEmitted = settings.RaysEmitted, RaysOfPicture = settings.RayCount, RayArea = view.RayArea(settings),
                Triangles = _scene.Scene.TriangleCount, Work = _sceneWork,
            };
            _sceneWork = default;

            var watch = Stopwatch.StartNew();
            double readBackMs;
            using (s_trace.Auto())
            {
                var kept = new KeptRayList(keep, settings, _owner);
                var tiles = FindTiles(settings, view, keep, ref result.Work);
                TraceTiles(settings, view, tiles, kept, result, progress, cancel);
                double tracedMs = watch.Elapsed.TotalMilliseconds;
                result.Rays = kept.ToArray();
                readBackMs = watch.Elapsed.TotalMilliseconds - tracedMs + kept.ReadBackMs;
            }
            result.Work.BytesOnDevice =
                _scene.Bytes + _tiles.Bytes + _starts.Bytes + _sums.Bytes + _rays.Bytes + _exact.Bytes;
            result.Timings = new Timings
            {
                BuildMs = _buildMs, UploadMs = _uploadMs, TraceMs = watch.Elapsed.TotalMilliseconds,
                ReadBackMs = readBackMs
            };
            return result;
        }

        /// <summary>Pixels of the rays received in the pose last traced, in ascending order.</summary>
        public uint[] ReceivedPixels() => _exact.ReceivedPixels();

        /// <summary>
        /// The ways of single rays, in the order of their pixels in the list.
        /// Every ray is followed in two-float arithmetic.
        /// </summary>
        /// <param name="pixels">x + y * rays across; x from the left, y from the bottom of the whole picture.</param>
        /// <param name="objects">Knows the objects that the scene's triangles belong to; may be null.</param>
        /// <param name="progress">Is told the part that is done, 0 to 1; may be null.</param>
        /// <param name="cancel">Ends the work after the dispatch in hand.</param>
        /// <exception cref="GlintException">A setting is out of its range, or a pixel outside the picture.</exception>
        /// <exception cref="OperationCanceledException">Cancelled.</exception>
        public RayPath[] TracePaths(in RadarSettings settings, in RadarView view, uint[] pixels,
            IHitObjects objects = null, IProgress<double> progress = null, CancellationToken cancel = default)
        {
            if (_scene.Scene == null)
                throw new InvalidOperationException("RayTracer.TracePaths without a scene: call SetScene first");
            settings.Validate(_owner);
            view.Validate(_owner);
            foreach (uint pixel in pixels)
                if (pixel >= settings.RayCount)
                    throw new GlintException($"{_owner}: there is no pixel {pixel} in a picture "
                        + $"of {settings.RaysAcross} x {settings.RaysDown} rays: pixels count from 0, "
                        + "a row after the other");
            var grid = new RayGrid(settings, view, _scene.Low, _scene.High);
            _kernel.SetRadar(settings, view, grid, _scene.Scene.Origin, 0, Shortcuts & ~Shortcuts.Starts);
            return _paths.Follow(settings, view, grid, pixels, objects, progress, cancel);
        }

        /// <summary>Releases all buffers on the device.</summary>
        public void Dispose()
        {
            _paths.Dispose();
            _exact.Dispose();
            _rays.Dispose();
            _sums.Dispose();
            _starts.Dispose();
            _tiles.Dispose();
            _scene.Dispose();
        }

        MeshTree Build(TriangleMesh mesh, TreeShape shape, CancellationToken cancel)
        {
            var watch = Stopwatch.StartNew();
            using (s_build.Auto())
            {
                var tree = MeshTree.Build(mesh, shape, cancel);
                _buildMs += watch.Elapsed.TotalMilliseconds;
                return tree;
            }
        }

        // The tiles to trace, on the device.
        uint[] FindTiles(in RadarSettings settings, in RadarView view, KeptRays keep, ref WorkDone work)
        {
            var picture = new PictureTiles(settings, view);
            // Who keeps all rays wants those that hit nothing as well.
            if (keep == KeptRays.All || (Shortcuts & Shortcuts.Tiles) == 0)
                picture.AddAll();
            else
                _scene.AddTo(picture);
            var tiles = picture.ToArray(_isSoftware);
            work.TilesTraced = tiles.Length;
            work.TilesSkipped = picture.Count - tiles.Length;
            _tiles.Upload(tiles);
            work.BytesUploaded += tiles.Length * (long)_tiles.Stride;
            return tiles;
        }

        void TraceTiles(in RadarSettings settings, in RadarView view, uint[] tiles, KeptRayList kept,
            RadarResult result, IProgress<double> progress, CancellationToken cancel)
        {
            var grid = new RayGrid(settings, view, _scene.Low, _scene.High);
            var sums = new RaySums(grid);
            // A kernel that finds nothing at all takes a software device long to compile, and for nothing.
            if (_scene.IsEmpty && kept.Keep != KeptRays.All)
                tiles = Array.Empty<uint>();
            bool usesStarts = UsesStarts(tiles.Length);
            _kernel.Choose(_scene, CountVisits);
            _kernel.SetRadar(settings, view, grid, _scene.Scene.Origin, sums.LengthUnits,
                usesStarts ? Shortcuts : Shortcuts & ~Shortcuts.Starts);
            _kernel.SetScene(_scene);
            _kernel.SetBuffers(_tiles, _sums);
            _exact.Begin();
            for (int first = 0; first < tiles.Length;)
            {
                cancel.ThrowIfCancellationRequested();
                int left = tiles.Length - first;
                int count = Math.Min(TraceKernel.MostTiles,
                    TilesADispatch > 0 ? Math.Min(left, TilesADispatch) : _pacer.NextTiles(left, settings.MaxBounces));
                count = _exact.Limit(kept.Limit(count, _rays));
                count = (int)Math.Min(count, DeviceBuffer<uint4>.Most / DeviceScene.MostFew);
                var watch = Stopwatch.StartNew();
                FindStarts(usesStarts, first, count, ref result.Work);
                int returning = Dispatch(first, count, sums, kept.Keep, ref result.Work);
                _pacer.Took(count, watch.Elapsed.TotalSeconds);
                _exact.Follow(returning, sums, kept, ref result.Work, cancel);
                kept.AddTiles(_rays, count, ref result.Work);
                first += count;
                progress?.Report((double)first / tiles.Length);
            }
            sums.WriteTo(result);
            if (!CountVisits)
                result.Work.NodesVisited = result.Work.PairsTested = 0; // of some kernels only
            _exact.Estimate(settings, grid, result, cancel);
        }

        // Where the rays of some tiles begin their search.
        void FindStarts(bool usesStarts, int first, int count, ref WorkDone work)
        {
            _starts.Reserve(usesStarts ? (long)count * DeviceScene.MostFew : 1);
            _kernel.SetStarts(_starts);
            if (!usesStarts)
                return;
            _kernel.FindStarts(_scene, _tiles, first, count, _starts);
            work.Dispatches++;
        }

        // Traces some tiles and adds up their sums; returns how many of their rays may be received.
        int Dispatch(int first, int count, RaySums sums, KeptRays keep, ref WorkDone work)
        {
            _sums.Buffer.SetData(_zeros);
            _kernel.Dispatch(first, count, keep, _exact.Returning, _rays);
            _sums.ReadBack(_words, _words.Length);
            work.Dispatches++;
            work.BytesUploaded += _sums.Bytes;
            work.BytesReadBack += _sums.Bytes;
            sums.Add(_words);
            return RaySums.CountReturning(_words);
        }

        // Finding starts pays when it fills the device: a GPU with few tiles spends on it what it saves.
        bool UsesStarts(int tiles) =>
            _scene.HasFewInstances && !CountVisits && (Shortcuts & Shortcuts.Starts) != 0
            && StartsPay(tiles, _isSoftware);

        internal static bool StartsPay(long tiles, bool isSoftware) => isSoftware || tiles >= TilesToFillAGpu;
    }
}
