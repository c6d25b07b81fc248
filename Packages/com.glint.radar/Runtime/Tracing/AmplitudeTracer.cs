using System;
using System.Diagnostics;
using System.Linq;
using System.Numerics;
using System.Threading;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// Computes the receiver amplitude of a pose to a tolerance: the integral over the picture of the phasors of the
    /// rays that reach the receiver, by ray tubes that are clipped at the edges of facets and receiver.
    /// </summary>
    public sealed class AmplitudeTracer : IDisposable
    {
        /// <summary>
        /// Normalised amplitude below which the tolerance is relative to this one, so that nulls take no endless work:
        /// that of a tenth of a ray of the published experiment.
        /// </summary>
        public const double Floor = 0.1;

        const int PointCapacity = 1 << 20;

        // A border is found to 2^-level of a base cell: at first, and at most, where float32 has no more places.
        const int FirstBisectLevel = 10, MaxBisectLevel = 14;

        // Maximum relative error of a cell that is not divided, times 2^level.
        const double CellError = 0.2;

        // Cells of which nothing is received are divided up to this level where something may be hidden in them, in the
        // first attempt; in each later one that needs it to the next level.
        const int FirstEmptyLevel = 4;

        // Attempts to find everything, after which the tolerance is not met.
        const int MaxAttempts = 8;

        // Error by something that a neighbour has found on a side of a cell: a third of a cell of the third level.
        const double RevealedError = 0.3 / 64;

        // Units of the sums, per area of a base cell and per its square.
        const double UnitsPerCell = 1 << 24, UnitsPerSquare = 1L << 44;

        // Words of the output, of 64 bits but for the first: Shaders/TubeBindings.hlsl.
        internal const int RevealedCount = 14, Hits = 16, Bounces = 18, Received = 20, Lengths = 22;
        internal const double LengthUnits = 256;
        const int InPhase = TubeKernels.FirstSum, Bent = InPhase + 2 * TubeSums.Bent, Border = InPhase + 2 * TubeSums.Border,
            TooLarge = InPhase + TubeSums.TooLarge;

        readonly string _owner;
        readonly AmplitudeKernels _kernels;
        readonly DeviceScene _scene;
        readonly SurfaceBuffers _surfaces = new SurfaceBuffers();
        readonly TubeLists _lists = new TubeLists();
        readonly DeviceBuffer<uint> _points = new DeviceBuffer<uint>("words of points");
        readonly DeviceBuffer<uint> _revealed = new DeviceBuffer<uint>("parts of cells");
        readonly DeviceBuffer<uint> _revealedByNow = new DeviceBuffer<uint>("parts of cells");
        readonly DispatchPacer _pacer = new DispatchPacer();
        uint[] _revealedWords;

        /// <param name="shader">Shaders/Amplitude.compute.</param>
        /// <param name="owner">Name of the owner, for messages.</param>
        /// <exception cref="GlintException">The shader is missing or another one.</exception>
        public AmplitudeTracer(ComputeShader shader, string owner = nameof(AmplitudeTracer))
        {
            Check(shader, owner);
            _owner = owner;
            _kernels = new AmplitudeKernels(shader);
            _scene = new DeviceScene(BvhLayout.Binary, owner, long.MaxValue);
        }

        /// <summary>Refuses another shader.</summary>
        /// <exception cref="GlintException">The message says what to assign.</exception>
        public static void Check(ComputeShader shader, string owner)
        {
            if (shader == null || !shader.HasKernel("AmplitudePoints"))
                throw new GlintException($"{owner}: a tolerance needs the kernels of ray tubes: assign "
                    + "Packages/com.glint.radar/Shaders/Amplitude.compute to Tube Kernel");
        }

        /// <summary>Rows of base cells of a dispatch, for tests; 0: by the times of earlier dispatches.</summary>
        internal int RowsADispatch { get; set; }

        /// <summary>Tubes, cells of a round and border cells of a dispatch, for tests; before the first pose.</summary>
        internal int ListCapacity { get; set; } = 1 << 18;

        /// <summary>Traces one pose to the tolerance of its settings.</summary>
        /// <param name="progress">Receives the fraction done, 0 to 1, of each attempt.</param>
        /// <param name="cancel">Cancels while BVHs are built, or after the current slice.</param>
        /// <param name="statistics">Figures of the gathering, to which those of the trace are added.</param>
        /// <returns>
        /// A result whose rays are those traced. <see cref="RadarResult.SamplingError"/> is the standard error of the
        /// integration, and <see cref="RadarResult.Undersampled"/> is true if the tolerance was not met.
        /// </returns>
        /// <exception cref="GlintException">A setting is out of its range, or the memory does not suffice.</exception>
        /// <exception cref="OperationCanceledException">The pose was cancelled.</exception>
        public RadarResult Trace(in RadarPose pose, IProgress<double> progress = null,
            CancellationToken cancel = default, TraceStatistics statistics = null)
        {
            var watch = Stopwatch.StartNew();
            statistics ??= new TraceStatistics();
            pose.Settings.Validate(_owner);
            pose.View.Validate(_owner);
            statistics.Triangles = pose.Scene.TriangleCount;
            _scene.Set(pose.Scene, statistics, (mesh, layout) => MeshBvh.Build(mesh, layout, cancel));
            var integral = new AmplitudeSums();
            bool isMet = true;
            double scale = 0, turns = 0;
            var grid = _scene.IsEmpty ? null : new AmplitudeGrid(pose.Settings, pose.View, _scene.Min, _scene.Max);
            if (grid != null && math.all(grid.Count > 0))
            {
                var rays = Bind(pose, grid);
                integral.OriginDepth = rays.OriginDepth;
                turns = (rays.OriginDepth + AmplitudeKernels.ReceiverDepth(pose.View, rays)) / pose.Settings.Wavelength;
                scale = grid.Step.x * grid.Step.y;
                isMet = TraceToTolerance(pose, grid, integral, progress, cancel);
            }
            var timings = statistics.Timings;
            timings.TraceMs = watch.Elapsed.TotalMilliseconds;
            statistics.Timings = timings;
            double error = scale * integral.Error * RadarResult.NormalRays / pose.Settings.RayCount;
            return new RadarResult(integral.ToSums(pose, scale, turns), new SamplingReport(error, null, !isMet), null,
                statistics);
        }

        /// <summary>Releases all buffers on the device.</summary>
        public void Dispose()
        {
            _kernels.Dispose();
            _scene.Dispose();
            _surfaces.Dispose();
            _lists.Dispose();
            _points.Dispose();
            _revealed.Dispose();
            _revealedByNow.Dispose();
        }

        // Repeats the trace, with finer borders and more cells, until the tolerance is met; false if it cannot be.
        bool TraceToTolerance(in RadarPose pose, AmplitudeGrid grid, AmplitudeSums sums, IProgress<double> progress,
            CancellationToken cancel)
        {
            double normalised = grid.Step.x * grid.Step.y * RadarResult.NormalRays / pose.Settings.RayCount;
            double allowed = Math.Pow(10, pose.Settings.ToleranceDb / 20) - 1;
            int level = FirstBisectLevel, emptyLevel = FirstEmptyLevel;
            for (int attempt = 1; ; attempt++)
            {
                TraceTo(level, emptyLevel, pose, grid, sums, progress, cancel);
                double toExcess = CrossSectionAccuracy.Confidence * normalised
                    / (allowed * Math.Max(Floor, normalised * sums.Sum.Magnitude));
                if (toExcess * sums.Error <= 1)
                    return true;
                if (attempt == MaxAttempts)
                    return false;
                if (sums.Revealed > 0)
                {
                    _revealedByNow.ReadBack(_revealedWords, _revealedWords.Length);
                    _revealed.Upload(_revealedWords);
                }
                double excess = toExcess * sums.KnownError;
                if (excess <= 1)
                    continue;
                level = Math.Min(MaxBisectLevel, level + Math.Max(1, (int)Math.Ceiling(Math.Log(excess, 2))));
                emptyLevel++;
            }
        }

        RayGrid Bind(in RadarPose pose, AmplitudeGrid grid)
        {
            _scene.RequireOnePage(_owner, "ray tubes take", ", or leave the tolerance out");
            var settings = pose.Settings;
            // Facets of one plane are one mirror.
            _surfaces.Set(pose.Scene, _scene.Centre, 0, settings.FrequencyHz);
            var rays = new RayGrid(settings, pose.View, _scene.Min, _scene.Max);
            var waveNumber = TubeLists.WaveNumber(settings.FrequencyHz);
            _kernels.SetScene(_scene, _surfaces);
            _kernels.SetPose(pose, rays, grid, waveNumber.x);
            _kernels.SetUnits(UnitsPerCell, UnitsPerSquare);
            _lists.Reserve(OutputSize, ListCapacity, ListCapacity, new[] { waveNumber });
            _points.Reserve((long)PointCapacity * AmplitudeKernels.PointWords(settings.MaxBounces));
            _kernels.Rounds.SetLists(_lists);
            _kernels.SetPoints(_lists.Output, _points, PointCapacity);
            _revealedWords = new uint[AmplitudeKernels.RevealedWords * grid.Count.x * grid.Count.y];
            _revealed.Upload(_revealedWords);
            _revealedByNow.Upload(_revealedWords);
            _kernels.SetRevealed(_revealed, _revealedByNow, _revealedWords.Length);
            return rays;
        }

        static int OutputSize => TubeKernels.FirstSum + TubeKernels.SumWords;

        // Traces all rows, with borders to a level, slice by slice.
        void TraceTo(int level, int emptyLevel, in RadarPose pose, AmplitudeGrid grid, AmplitudeSums sums, IProgress<double> progress,
            CancellationToken cancel)
        {
            double cellError = CellError * Math.Pow(2, -level);
            int maxLevel = (int)Math.Ceiling(-0.5 * Math.Log(cellError, 2));
            _kernels.SetAccuracy(cellError, maxLevel, level + 1);
            sums.Clear();
            var read = new uint[OutputSize];
            int max = grid.Count.y;
            for (int first = 0; first < grid.Count.y;)
            {
                cancel.ThrowIfCancellationRequested();
                int left = Math.Min(grid.Count.y - first, max);
                int rows = RowsADispatch > 0 ? Math.Min(left, RowsADispatch)
                    : _pacer.NextTiles(left, pose.Settings.MaxBounces);
                var watch = Stopwatch.StartNew();
                _kernels.Rounds.Clear(read.Length);
                _kernels.Trace(grid, first, rows, Math.Max(maxLevel, emptyLevel) + 1, level + 1, emptyLevel);
                _lists.Output.ReadBack(read, read.Length);
                _pacer.Took(rows, watch.Elapsed.TotalSeconds);
                if (TubeSums.HasOverflown(read))
                {
                    // A list was full: the slice is traced again in two. What it has found across sides stays marked.
                    sums.AddRevealed(read);
                    if (rows == 1)
                        throw new GlintException($"{_owner}: one row of cells has too many parts at this tolerance: "
                            + "ask for a larger one, or trace a part of the picture");
                    max = rows / 2;
                    continue;
                }
                sums.Add(read, _owner);
                first += rows;
                progress?.Report((double)first / grid.Count.y);
            }
        }

        /// <summary>The sums of a pose over its slices, in areas of a base cell; counts are over all attempts.</summary>
        sealed class AmplitudeSums
        {
            long _inPhase, _quadrature, _bentInPhase, _bentQuadrature, _squares;
            long _rays, _hits, _bounces, _received, _lengths;

            public double OriginDepth { get; set; }

            public Complex Sum => new Complex(_inPhase, _quadrature) / UnitsPerCell;

            /// <summary>Parts of cells in which there is more than the attempt knew.</summary>
            public long Revealed { get; private set; }

            /// <summary>Standard error of what the attempt knew.</summary>
            public double KnownError
            {
                get
                {
                    double bent = new Complex(_bentInPhase, _bentQuadrature).Magnitude / UnitsPerCell;
                    return Math.Sqrt(_squares / UnitsPerSquare + bent * bent);
                }
            }

            public double Error => Math.Sqrt(KnownError * KnownError + Revealed * RevealedError * RevealedError);

            public void Clear() => Revealed = _inPhase = _quadrature = _bentInPhase = _bentQuadrature = _squares = 0;

            public void AddRevealed(uint[] output) => Revealed += output[RevealedCount];

            public void Add(uint[] output, string owner)
            {
                long At(int word) => TubeSums.At(output, word);
                if (output[TooLarge] != 0)
                    throw new GlintException($"{owner}: a part of the amplitude is not finite: "
                        + "the mesh may have coordinates that float32 does not resolve");
                _inPhase += At(InPhase);
                _quadrature += At(InPhase + 2);
                _bentInPhase += At(Bent);
                _bentQuadrature += At(Bent + 2);
                _squares += At(Border);
                AddRevealed(output);
                _rays += TubeSums.RaysOf(output, 0).Sum();
                _hits += At(Hits);
                _bounces += At(Bounces);
                _received += At(Received);
                _lengths += At(Lengths);
            }

            /// <param name="scale">Rays of the picture a base cell.</param>
            /// <param name="turns">Phase that the sums lack, turns.</param>
            public RadarSums ToSums(in RadarPose pose, double scale, double turns)
            {
                var sum = scale * Sum * Complex.FromPolarCoordinates(1, 2 * Math.PI * (turns - Math.Floor(turns)));
                return new RadarSums
                {
                    InPhase = sum.Real, Quadrature = sum.Imaginary, RaysOfPicture = pose.Settings.RayCount,
                    RaysEmitted = _rays, RaysHit = _hits, RaysReceived = _received, Bounces = _bounces,
                    PathLengthMeters = _hits * OriginDepth + _lengths / LengthUnits,
                    RayArea = pose.View.RayArea(pose.Settings), PhaseHistogram = null
                };
            }
        }
    }
}
