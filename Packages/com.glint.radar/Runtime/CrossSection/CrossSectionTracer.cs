using System;
using System.Linq;
using System.Numerics;
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
        const int ListCapacity = 1 << 20, TubeCapacity = 1 << 20;
        const int MaxLevelLimit = 10, BisectLimit = 14;

        readonly string _owner;
        readonly TubeKernels _kernels;
        readonly DeviceScene _scene;
        readonly SurfaceBuffers _surfaces = new SurfaceBuffers();
        readonly EdgeBuffers _edges = new EdgeBuffers();
        readonly DeviceBuffer<uint> _output = new DeviceBuffer<uint>("sums of tubes");
        readonly DeviceBuffer<Tube> _tubes = new DeviceBuffer<Tube>("tubes");
        readonly DeviceBuffer<TubeCell> _cells = new DeviceBuffer<TubeCell>("cells of tubes");
        readonly DeviceBuffer<TubeCell> _borders = new DeviceBuffer<TubeCell>("border cells");
        readonly DeviceBuffer<uint> _marks = new DeviceBuffer<uint>("marks of cells");
        readonly DeviceBuffer<float4> _waveNumbers = new DeviceBuffer<float4>("frequencies");
        readonly DispatchPacer _pacer = new DispatchPacer();

        /// <param name="shader">Shaders/Tubes.compute.</param>
        /// <param name="owner">Name of the owner, for messages.</param>
        public CrossSectionTracer(ComputeShader shader, string owner = nameof(CrossSectionTracer))
        {
            _owner = owner;
            _kernels = new TubeKernels(shader);
            _scene = new DeviceScene(BvhLayout.Binary, owner, long.MaxValue);
        }

        /// <summary>Bisections of a base cell's side towards a border; for tests.</summary>
        internal int BisectLevel { get; set; } = 6;

        /// <summary>Traces one pose.</summary>
        /// <param name="cancel">Cancels while BVHs are built, or after the current slice.</param>
        public CrossSectionResult Trace(CrossSectionPose pose, IProgress<double> progress = null,
            CancellationToken cancel = default)
        {
            _scene.Set(pose.Scene, new TraceStatistics(), (mesh, layout) => MeshBvh.Build(mesh, layout, cancel));
            var result = new CrossSectionResult(pose.Receivers.Length, pose.Frequencies.Length);
            if (_scene.IsEmpty)
                return result;
            _surfaces.Set(pose.Scene, _scene.Centre, pose.CreaseDegrees, pose.Frequencies.Last());
            double side = TubeGrid.SideFor(pose, _scene.Min, _scene.Max);
            var grid = new TubeGrid(pose, side, _scene.Min, _scene.Max);
            _kernels.SetScene(_scene, _surfaces);
            _kernels.SetPose(pose, grid);
            var sums = new TubeSums(pose, grid);
            double cellError = 0.2 * Math.Pow(2, -BisectLevel);
            int maxLevel = (int)Math.Ceiling(-0.5 * Math.Log(cellError, 2));
            _kernels.SetAccuracy(sums.WaveNumber, cellError, maxLevel, BisectLevel, sums.UnitsPerMetre,
                sums.UnitsPerSquareMetre);
            int words = TubeKernels.FirstSum + TubeKernels.SumWords * pose.Receivers.Length * pose.Frequencies.Length;
            _output.Reserve(words);
            _tubes.Reserve(TubeCapacity);
            _cells.Reserve(ListCapacity);
            _borders.Reserve(ListCapacity);
            _waveNumbers.Upload(pose.Frequencies.Select(frequency => WaveNumber(frequency)).ToArray());
            _kernels.SetLists(_output, _tubes, _cells, _borders, _waveNumbers);
            _marks.Reserve(2 * grid.Count);
            _kernels.Mark(grid, _surfaces, _marks);
            long maxCount = long.MaxValue;
            for (long first = 0; first < grid.Count;)
            {
                cancel.ThrowIfCancellationRequested();
                long left = Math.Min(grid.Count - first, maxCount);
                int tiles = _pacer.NextTiles((int)Math.Min(int.MaxValue, (left + TileCells - 1) / TileCells),
                    pose.MaxBounces);
                int count = (int)Math.Min(left, (long)tiles * TileCells);
                var watch = System.Diagnostics.Stopwatch.StartNew();
                _kernels.Clear(words);
                _kernels.Trace(grid, first, count, maxLevel + 1, BisectLevel);
                var read = new uint[words];
                _output.ReadBack(read, words);
                if (read[3] != 0)
                {
                    if (count <= TileCells)
                        throw new GlintException($"{_owner}: a list of tubes is full with {count} cells");
                    maxCount = count / 2;
                    continue;
                }
                _pacer.Took(tiles, watch.Elapsed.TotalSeconds);
                sums.Add(read);
                first += count;
                progress?.Report((double)first / grid.Count);
            }
            if (pose.HasEdges && pose.OnlyBounce == 0)
                AddEdges(pose, words, sums, result, cancel);
            sums.Fill(result);
            return result;
        }

        void AddEdges(CrossSectionPose pose, int words, TubeSums sums, CrossSectionResult result,
            CancellationToken cancel)
        {
            _edges.Set(pose.Scene, _surfaces.Patches, _scene.Centre, TubeGrid.EdgePieceFor(pose));
            result.WedgesLeftOut = _edges.LeftOutCount;
            // Shadow rays start beyond what lies on an edge.
            double offset = WedgeFinder.RelativeTolerance * math.distance(_scene.Min, _scene.Max);
            int max = TubeCapacity / pose.Receivers.Length;
            var read = new uint[words];
            for (int first = 0; first < _edges.Count; first += max)
            {
                cancel.ThrowIfCancellationRequested();
                _kernels.Clear(words);
                _kernels.TraceEdges(_edges, first, Math.Min(max, _edges.Count - first), offset);
                _output.ReadBack(read, words);
                sums.Add(read);
            }
        }

        /// <summary>Releases all buffers on the device.</summary>
        public void Dispose()
        {
            _kernels.Dispose();
            _scene.Dispose();
            _surfaces.Dispose();
            _edges.Dispose();
            _output.Dispose();
            _tubes.Dispose();
            _cells.Dispose();
            _borders.Dispose();
            _marks.Dispose();
            _waveNumbers.Dispose();
        }

        static float4 WaveNumber(double frequency)
        {
            double turns = 1 / Signal.Wavelength(frequency);
            return new float4((float)(2 * Math.PI * turns), (float)turns, DoubleFloat.Lo(turns), 0);
        }
    }

    // The sums of a pose over its slices.
    sealed class TubeSums
    {
        readonly CrossSectionPose _pose;
        readonly TubeGrid _grid;
        readonly long[] _sums;
        long _tubes, _rays;

        public TubeSums(CrossSectionPose pose, TubeGrid grid)
        {
            (_pose, _grid) = (pose, grid);
            double wavelength = Signal.Wavelength(pose.Frequencies.Last());
            WaveNumber = 2 * Math.PI / wavelength;
            double tube = 2 * Math.Sqrt(Math.PI) * wavelength;
            UnitsPerMetre = Math.Pow(2, 24) / tube;
            UnitsPerSquareMetre = Math.Pow(2, 50) / (tube * tube);
            _sums = new long[pose.Receivers.Length * pose.Frequencies.Length * 11];
        }

        public double WaveNumber { get; }
        public double UnitsPerMetre { get; }
        public double UnitsPerSquareMetre { get; }

        public void Add(uint[] words)
        {
            _tubes += words[0];
            _rays += words[4] + ((long)words[5] << 32);
            for (int i = 0; i < _sums.Length; i++)
            {
                int at = TubeKernels.FirstSum + i / 11 * TubeKernels.SumWords + 2 * (i % 11);
                _sums[i] += (long)((ulong)words[at + 1] << 32 | words[at]);
            }
        }

        public void Fill(CrossSectionResult result)
        {
            result.Tubes = _tubes;
            result.Rays = _rays;
            int at = 0;
            for (int receiver = 0; receiver < _pose.Receivers.Length; receiver++)
                for (int frequency = 0; frequency < _pose.Frequencies.Length; frequency++, at += 11)
                {
                    double k = 2 * Math.PI / Signal.Wavelength(_pose.Frequencies[frequency]);
                    double phase = k * _grid.PhaseOf(_pose, _pose.Receivers[receiver]);
                    var turn = Complex.FromPolarCoordinates(1, phase);
                    Complex Amplitude(int place) =>
                        new Complex(_sums[at + place], _sums[at + place + 1]) / UnitsPerMetre;
                    result.S[receiver, frequency] = turn * new ScatteringMatrix
                    {
                        VV = Amplitude(0), HV = Amplitude(2), VH = Amplitude(4), HH = Amplitude(6)
                    };
                    double bent = Amplitude(8).Magnitude, border = _sums[at + 10] / UnitsPerSquareMetre;
                    result.Errors[receiver, frequency] = Math.Sqrt(border + bent * bent);
                }
        }
    }
}
