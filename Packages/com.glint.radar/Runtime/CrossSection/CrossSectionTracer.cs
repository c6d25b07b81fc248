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
        const int ListElements = 1 << 20, CornerElements = 1 << 21, MaxLists = 8, MebibytesAList = 8192;

        // Rays of a slice for each of these elements, which leave the lists half empty.
        const int RaysAList = 3 << 18;

        // Error that a cell may have, as a fraction of what a conducting plate of a base cell returns: at first, and at
        // least.
        const double FirstCellError = 1.0 / 64, MinCellError = 1.0 / (1 << 17);

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

        /// <summary>Cells of a dispatch, for tests; 0: by the times of earlier dispatches.</summary>
        internal int CellsADispatch { get; set; }

        /// <summary>Traces one pose to its tolerance.</summary>
        /// <param name="progress">Receives the fraction done, 0 to 1, of each attempt.</param>
        /// <param name="cancel">Cancels while BVHs are built, or after the current slice.</param>
        /// <exception cref="GlintException">The memory does not suffice for the scene.</exception>
        /// <exception cref="OperationCanceledException">The pose was cancelled.</exception>
        public CrossSectionResult Trace(CrossSectionPose pose, IProgress<double> progress = null,
            CancellationToken cancel = default)
        {
            SetScene(pose, cancel);
            if (_scene.IsEmpty)
                return new CrossSectionResult(pose.Receivers.Length, pose.Samples) { IsMet = true };
            var grid = GridOf(pose);
            var edges = new TubeSums(pose, grid);
            // Before the tubes' buffers are bound: it clears sums of its own.
            var clutter = Clutter(pose, cancel);
            Bind(pose, grid, edges, TubeSums.OutputSize(pose), 1);
            _kernels.SumAll();
            double floor =
                Math.Max(pose.FloorDbsm ?? CrossSectionFloor.Of(_scene.Min, _scene.Max), FloorOf(clutter));
            // The same for every attempt.
            TraceEdges(pose, TubeSums.OutputSize(pose), read => edges.Add(read, _owner), cancel);
            long rays = 0;
            var forecast = NewForecast();
            for (double cellError = CellError > 0 ? CellError : FirstCellError; ;)
            {
                var sums = new TubeSums(pose, grid);
                TraceCells(cellError, pose, grid, forecast, TubeSums.OutputSize(pose), read => sums.Add(read, _owner),
                    progress, cancel);
                sums.Add(edges);
                var result = sums.ToResult();
                result.Add(clutter);
                result.CellError = cellError;
                result.Rays = (rays += result.Rays) + edges.Rays;
                result.FloorDbsm = floor;
                result.WedgesLeftOut = pose.HasEdges ? _edges.LeftOutCount : 0;
                double excess = Excess(result, pose.ToleranceDb, floor);
                result.IsMet = excess <= 1;
                if (result.IsMet || CellError > 0 || cellError <= MinCellError)
                    return result;
                cellError = Math.Max(MinCellError, cellError / math.clamp(2 * excess, 2, 64));
            }
        }

        // The diffuse echo of the seas: none if the radar does not receive.
        ClutterEcho[] Clutter(CrossSectionPose pose, CancellationToken cancel)
        {
            if (pose.Scene.Seas.Count == 0)
                return null;
            if (pose.Receivers.Length != 1 || !pose.Receivers[0].ToRadar.Equals(pose.Radar.ToRadar))
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
            var grid = GridOf(pose);
            var units = new TubeSums(pose, grid);
            var parts = _surfaces.Parts;
            var sums = new PartSums(parts, TubeSums.OutputSize(pose), units, receiver, frequency);
            Bind(pose, grid, units, sums.OutputSize, ListCapacity);
            _kernels.SumParts(parts, receiver, frequency, TubeSums.OutputSize(pose));
            TraceEdges(pose, sums.OutputSize, sums.Add, cancel);
            TraceCells(result.CellError, pose, grid, NewForecast(), sums.OutputSize, sums.Add, progress, cancel);
            return sums.ToContributions(polarisations);
        }

        /// <summary>
        /// Sums a pose by uniform points instead of ray tubes, without edges: what tubes are compared with
        /// (glint bench --rcs). Errors are not known.
        /// </summary>
        /// <param name="across">Points along a side of a base cell: <see cref="TubeGrid.SideFor"/>.</param>
        /// <param name="offset">Of the first point of a base cell, 0 to 1 spacings of points.</param>
        /// <inheritdoc cref="Trace"/>
        public CrossSectionResult TracePoints(CrossSectionPose pose, int across, double2 offset,
            CancellationToken cancel = default)
        {
            SetScene(pose, cancel);
            var grid = GridOf(pose);
            var sums = new TubeSums(pose, grid);
            Bind(pose, grid, sums, TubeSums.OutputSize(pose), 1);
            _kernels.SumAll();
            var read = new uint[TubeSums.OutputSize(pose)];
            // The list holds the currents of all bounces.
            int max = ListCapacity / (pose.MaxBounces * pose.Receivers.Length * across * across);
            for (long first = 0; first < grid.Count;)
            {
                cancel.ThrowIfCancellationRequested();
                int count = RowsOf(first, (int)Math.Min(max, grid.Count - first), grid.Cells.x);
                _kernels.Clear(read.Length);
                _kernels.TracePoints(grid, first, count, across, offset);
                _output.ReadBack(read, read.Length);
                sums.Add(read, _owner);
                first += count;
            }
            return sums.ToResult();
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
            _surfaces.Set(pose.Scene, _scene.Centre, pose.CreaseDegrees, pose.Frequencies.Last());
            if (pose.HasEdges)
                _edges.Set(pose.Scene, _surfaces.Patches, _surfaces.Parts, _scene.Centre,
                    TubeGrid.EdgePieceFor(pose));
        }

        TubeGrid GridOf(CrossSectionPose pose) =>
            new TubeGrid(pose, TubeGrid.SideFor(pose, _scene.Min, _scene.Max), _scene.Min, _scene.Max);

        void Bind(CrossSectionPose pose, TubeGrid grid, TubeSums units, int outputSize, int tubeParts)
        {
            _kernels.SetScene(_scene, _surfaces);
            _kernels.SetPose(pose, grid);
            _kernels.SetUnits(units);
            _output.Reserve(outputSize);
            _tubes.Reserve(ListCapacity);
            _tubeParts.Reserve(tubeParts);
            _cells.Reserve(CellCapacity(pose));
            _corners.Reserve(_lists * CornerElements);
            _borders.Reserve(ListCapacity);
            _tubeRates.Reserve(pose.IsMoving ? ListCapacity : 1);
            _waveNumbers.Upload(Enumerable.Range(0, pose.Samples).Select(sample =>
                TubeRounds.WaveNumber(pose.FrequencyOf(sample), pose.TimeOf(sample))).ToArray());
            _kernels.SetLists(_output, _tubes, _tubeParts, _tubeRates, _cells, _borders, _corners,
                _waveNumbers, CellCapacity(pose));
            _marks.Reserve(TubeKernels.MarkWordsOf(grid));
            _links.Reserve(Math.Max(1, TubeKernels.VertexLinks * _surfaces.VertexCount));
            _kernels.Mark(grid, _surfaces, _marks, _links);
        }

        // Traces all cells to an error of each, slice by slice, and hands each slice's output over.
        void TraceCells(double cellError, CrossSectionPose pose, TubeGrid grid, SliceForecast forecast, int outputSize,
            Action<uint[]> add, IProgress<double> progress, CancellationToken cancel)
        {
            // A division makes a cell's share a quarter; a bisection halves the error of its border. Where curved
            // surfaces focus, a base cell returns up to 64 times what a plate does.
            int maxLevel = (int)Math.Ceiling(0.5 * Math.Log(1.2 / cellError, 2)) + 3;
            int maxBisections = (int)Math.Ceiling(Math.Log(1 / cellError, 2)) + 8;
            _kernels.SetAccuracy(cellError * 2 * grid.Side * grid.Side, maxLevel, maxBisections);
            forecast.Begin(cellError);
            var read = new uint[outputSize];
            long max = CellCapacity(pose);
            for (long first = 0; first < grid.Count;)
            {
                cancel.ThrowIfCancellationRequested();
                long left = forecast.CellsFrom(first, Math.Min(grid.Count - first, max));
                int tiles = _pacer.NextTiles((int)Math.Min(int.MaxValue, (left + TileCells - 1) / TileCells),
                    pose.MaxBounces);
                int count = (int)Math.Min(left, CellsADispatch > 0 ? CellsADispatch : (long)tiles * TileCells);
                count = RowsOf(first, count, grid.Cells.x);
                var watch = Stopwatch.StartNew();
                _kernels.Clear(read.Length);
                _kernels.Trace(grid, first, count, maxLevel + 1, maxBisections);
                _output.ReadBack(read, read.Length);
                _pacer.Took(Math.Max(1, count / TileCells), watch.Elapsed.TotalSeconds);
                if (TubeSums.HasOverflown(read))
                {
                    // A list was full: the slice is traced again in two.
                    max = Math.Max(1, count / 2);
                    if (count == 1)
                        throw new GlintException($"{_owner}: one cell of the grid has too many parts at this tolerance: "
                            + "ask for a larger one");
                    continue;
                }
                add(read);
                forecast.Took(first, count, TubeSums.RaysOf(read));
                first += count;
                max = Math.Min(CellCapacity(pose), max + max / 2);
                progress?.Report((double)first / grid.Count);
            }
        }

        SliceForecast NewForecast() => new SliceForecast((long)_lists * RaysAList);

        int ListCapacity => _lists * ListElements;

        // Cells of a dispatch, whose corners are kept.
        int CellCapacity(CrossSectionPose pose) =>
            _lists * CornerElements / pose.MaxBounces / TubeKernels.BlockCorners * TubeKernels.BlockCells;

        // Of a number of cells those that make whole rows, or a part of the row begun.
        static int RowsOf(long first, int count, int across)
        {
            int left = across - (int)(first % across);
            return left < across || count < across ? Math.Min(count, left) : count / across * across;
        }

        // Traces the edges, as many pieces at a time as the list of tubes holds.
        void TraceEdges(CrossSectionPose pose, int outputSize, Action<uint[]> add, CancellationToken cancel)
        {
            if (!pose.HasEdges || pose.OnlyBounce != 0)
                return;
            var read = new uint[outputSize];
            // Shadow rays start clear of faces that meet at an edge up to that tolerance.
            double offset = WedgeFinder.RelativeTolerance * math.distance(_scene.Min, _scene.Max);
            int max = ListCapacity / pose.Receivers.Length;
            for (int first = 0; first < _edges.Count; first += max)
            {
                cancel.ThrowIfCancellationRequested();
                _kernels.Clear(read.Length);
                int count = Math.Min(max, _edges.Count - first);
                _kernels.TraceEdges(_edges, first, count, pose.Receivers.Length, offset);
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
