using System;
using System.Diagnostics;
using System.Linq;
using System.Threading;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>Traces the cells of poses slice by slice on the GPU, and owns the lists that this takes.</summary>
    sealed class TubeTracer : IDisposable
    {
        const int TileCells = 64;          // the pacer counts tiles

        // Elements of the lists, and of the corners of a dispatch times their bounces, for each of 4 GB of memory up to
        // MaxLists. They take 0.75 GB. Long slices are faster: each waits for its slowest rays in each round.
        const int ListElements = 1 << 20, CornerElements = 3 << 20, MaxLists = 20, MebibytesAList = 4096;

        // Rays of a slice for each of these elements: on a ship there is a tube for every five rays, and forecasts are
        // wrong by a factor of two. A slice whose lists become full is traced again in two.
        const int RaysAList = 2 << 20;

        // A device takes a tenth of a second for the longest lists: they begin as long as the number of poses needs, and are
        // doubled after so many slices that left cells.
        const int PosesAList = 8, SlicesAFactor = 8;

        // Of the marks and links of all poses of a dispatch, for each of these lists: 64 and 128 MB.
        const long MarkWordsAList = 1 << 24, LinksAList = 1 << 23;

        readonly string _owner;
        readonly TubeKernels _kernels;
        readonly TubeLists _lists = new TubeLists();
        readonly DeviceBuffer<uint> _tubeParts = new DeviceBuffer<uint>("parts of tubes");
        readonly DeviceBuffer<float4> _tubeExtras = new DeviceBuffer<float4>("rates and changes of tubes");
        readonly DeviceBuffer<uint> _marks = new DeviceBuffer<uint>("marks of cells");
        readonly DeviceBuffer<uint4> _links = new DeviceBuffer<uint4>("corners of patches");
        readonly DispatchPacer _pacer = new DispatchPacer();
        Action _bind;
        int _factor = 1, _slicesOfFactor;
        double _maxRays;                   // of a slice, by their forecast
        uint[] _read;

        /// <param name="shader">Shaders/Tubes.compute.</param>
        /// <param name="owner">Name of the owner, for messages.</param>
        public TubeTracer(ComputeShader shader, string owner) => (_owner, _kernels) = (owner, new TubeKernels(shader));

        /// <summary>
        /// Poses that a GPU traces together at most: as many as fill its lists. A single one fills a software device.
        /// </summary>
        public static int MaxPoses => SoftwareDevice.IsInUse ? 1
            : Math.Min(PosesAList * (1 + ListFactor), TubeKernels.MaxPoses);

        static int ListFactor => SoftwareDevice.IsInUse ? 1
            : math.clamp((int)Math.Min(SystemInfo.graphicsMemorySize / MebibytesAList,
                Math.Min(DeviceBuffer<Tube>.MaxCount, DeviceBuffer<TubeCell>.MaxCount / 2) / ListElements), 1, MaxLists);

        /// <summary>Cells of a dispatch, for tests; 0: by the times of earlier dispatches.</summary>
        public int CellsADispatch { get; set; }

        // Tubes, border cells and rays beside outlines.
        int Capacity => _factor * ListElements;

        double RaysASlice => (double)_factor * RaysAList;

        // Times their bounces.
        int Corners => (int)Math.Min(_factor * CornerElements, DeviceBuffer<TubeCorner>.MaxCount);

        /// <summary>
        /// Whether the marks and links of poses with a grid fit, and a dispatch has a thread for all that is marked.
        /// </summary>
        /// <param name="pose">One of them: they are alike.</param>
        public static bool FitsTogether(int poses, TubeGrid largest, CrossSectionPose pose, SurfaceBuffers surfaces) =>
            poses * TubeKernels.MarkWordsOf(largest) <= ListFactor * MarkWordsAList
            && (long)poses * (TubeKernels.LinksOf(largest, surfaces) + TubeKernels.LineLinksOf(pose, surfaces))
                <= Math.Min(DeviceBuffer<uint4>.MaxCount, ListFactor * LinksAList)
            && (long)poses * surfaces.MarkedCount <= KernelCalls.MaxThreads;

        /// <summary>Sets the poses, which are alike, and what is summed: S.</summary>
        /// <param name="add">Receives the output of the rays that find shadows of receivers, and images of outlines.</param>
        /// <inheritdoc cref="Bind"/>
        public void SumAll(TubeJob[] jobs, DeviceScene scene, SurfaceBuffers surfaces, Action<uint[]> add)
        {
            _factor = Math.Min(ListFactor, Math.Max(_factor, 1 + (jobs.Length - 1) / PosesAList));
            _slicesOfFactor = 0;
            _bind = () =>
            {
                Bind(jobs, scene, surfaces, TubeSums.OutputSize(jobs[0].Pose, jobs.Length), () => 1);
                _kernels.SumAll();
            };
            _bind();
            if (!jobs[0].Pose.IsMonostatic || TubeKernels.HasImages(jobs[0].Pose))
            {
                _lists.Output.ReadBack(_read, _read.Length);
                add(_read);
            }
            _kernels.ClearRevealed(jobs.Length);
        }

        /// <summary>Sets a pose, and what is summed: the parts of S at one receiver and frequency.</summary>
        /// <inheritdoc cref="Bind"/>
        public void SumParts(TubeJob job, DeviceScene scene, SurfaceBuffers surfaces, PartSums sums, int receiver,
            int frequency)
        {
            _slicesOfFactor = 0;
            _bind = () =>
            {
                Bind(new[] { job }, scene, surfaces, sums.OutputSize, () => Capacity);
                _kernels.SumParts(surfaces.Patches.Parts, receiver, frequency, TubeSums.OutputSize(job.Pose, 1));
            };
            _bind();
            _kernels.ClearRevealed(1);
        }

        /// <exception cref="GlintException">The device's memory does not suffice.</exception>
        void Bind(TubeJob[] jobs, DeviceScene scene, SurfaceBuffers surfaces, int outputSize,
            Func<int> tubeParts)
        {
            var pose = jobs[0].Pose;
            _kernels.SetScene(scene, surfaces);
            _kernels.SetPoses(jobs);
            _kernels.SetUnits(jobs[0].Edges);
            _read = new uint[outputSize];
            _maxRays = RaysASlice;
            _lists.Reserve(outputSize, Capacity, CellCapacity(pose), Enumerable.Range(0, pose.Samples).Select(sample =>
                TubeLists.WaveNumber(pose.PhaseFrequencyOf(sample), pose.TimeOf(sample))));
            _lists.ReserveRays(Corners, CornerCapacity(pose));
            _tubeParts.Reserve(tubeParts());
            _tubeExtras.Reserve(pose.IsFar && !pose.IsMoving ? 1 : (long)TubeKernels.ExtraRowsOf(pose) * Capacity);
            _kernels.SetLists(_lists, _tubeParts, _tubeExtras);
            long words = jobs.Max(job => TubeKernels.MarkWordsOf(job.Grid));
            int lines = TubeKernels.LineLinksOf(pose, surfaces);
            int links = TubeKernels.LinksOf(jobs[0].Grid, surfaces) + lines;
            _marks.Reserve(jobs.Length * words);
            _links.Reserve((long)jobs.Length * links);
            _kernels.BindRevealed(jobs.Length);
            _kernels.Mark(jobs.Length, (int)words, links, lines, surfaces, _marks, _links);
            _kernels.Clear(_read.Length);
            if (TubeKernels.HasImages(pose))
                _kernels.MarkImages(jobs.Length, scene, surfaces.Mirrors);
            if (!pose.IsMonostatic)
            {
                _kernels.MarkShadows(jobs.Length * pose.Receivers.Length, scene, surfaces.Silhouettes);
            }
        }

        // Corners of a round, of which what they meet is kept.
        int CornerCapacity(CrossSectionPose pose) => Corners / pose.MaxBounces;

        // Cells of a round after that of the base cells.
        int CellCapacity(CrossSectionPose pose) => CornerCapacity(pose) / TubeKernels.BlockCorners * TubeKernels.BlockCells;

        /// <summary>
        /// Traces the next cells of all poses and hands the output over. If a list becomes full, nothing is handed over, and
        /// the next slice is smaller. A pose of which a single cell fills a list keeps the result of the attempt before.
        /// </summary>
        /// <exception cref="GlintException">A single cell of a first attempt has too many parts.</exception>
        public void TraceSlice(TubeJob[] jobs, Action<uint[]> add)
        {
            GrowLists();
            var pose = jobs[0].Pose;
            long most = Math.Min(jobs.Sum(job => job.Left), CornerCapacity(pose));
            int tiles = _pacer.NextTiles((int)Math.Min(int.MaxValue, (most + TileCells - 1) / TileCells), pose.MaxBounces);
            double raysLeft = _maxRays;
            var slices = SlicesOf(jobs, Math.Min(most, CellsADispatch > 0 ? CellsADispatch : (long)tiles * TileCells),
                ref raysLeft);
            int count = slices.Sum(slice => slice.Count);
            var watch = Stopwatch.StartNew();
            _kernels.Clear(_read.Length);
            _kernels.Trace(jobs, slices);
            _lists.Output.ReadBack(_read, _read.Length);
            _pacer.Took(Math.Max(1, count / TileCells), watch.Elapsed.TotalSeconds);
            if (TubeSums.HasOverflown(_read))
            {
                _maxRays = (_maxRays - raysLeft) / 2;
                if (count == 1 && !jobs[Array.FindIndex(slices, slice => slice.Count > 0)].GiveUp())
                    throw new GlintException($"{_owner}: one cell of the grid has too many parts at this tolerance: "
                        + "ask for a larger one");
                return;
            }
            add(_read);
            for (int i = 0; i < jobs.Length; i++)
                if (slices[i].Count > 0)
                    jobs[i].Took(slices[i].Count, TubeSums.RaysOf(_read, i));
            _maxRays = Math.Min(RaysASlice, 1.5 * _maxRays);
            _slicesOfFactor += jobs.Any(job => job.Left > 0) ? 1 : 0;
        }

        void GrowLists()
        {
            if (_slicesOfFactor < SlicesAFactor || _factor >= ListFactor)
                return;
            _factor = Math.Min(ListFactor, 2 * _factor);
            _slicesOfFactor = 0;
            _bind();
        }

        // The next slice of each pose, cells and rays in all at most.
        (long First, int Count)[] SlicesOf(TubeJob[] jobs, long max, ref double rays)
        {
            var slices = new (long First, int Count)[jobs.Length];
            int sum = 0;
            long corners = CornerCapacity(jobs[0].Pose);
            for (int i = 0; i < jobs.Length; i++)
            {
                long most = Math.Min(max - sum, jobs[i].CellsWithin(corners));
                slices[i] = (jobs[i].Next, jobs[i].SliceOf(sum == 0 ? 1 : 0, Math.Max(0, most), ref rays));
                sum += slices[i].Count;
                corners -= TubeKernels.CornersOf(slices[i].Count, jobs[i].Grid.Cells.x);
            }
            return slices;
        }

        /// <summary>Traces the edges, as many pieces at a time as the list of tubes holds, and hands each output over.</summary>
        /// <param name="offset">Of shadow rays, which start clear of the faces that meet at an edge, metres.</param>
        public void TraceEdges(TubeJob[] jobs, EdgeBuffers edges, double offset, Action<uint[]> add, CancellationToken cancel)
        {
            int receivers = jobs.Length * jobs[0].Pose.Receivers.Length, max = Capacity / receivers;
            for (int first = 0; first < edges.Count; first += max)
            {
                cancel.ThrowIfCancellationRequested();
                _kernels.Clear(_read.Length);
                _kernels.TraceEdges(edges, first, Math.Min(max, edges.Count - first), receivers, offset);
                _lists.Output.ReadBack(_read, _read.Length);
                add(_read);
            }
        }

        /// <summary>Sums the next cells of a pose by uniform points.</summary>
        /// <inheritdoc cref="CrossSectionTracer.TracePoints"/>
        public void TracePoints(TubeJob job, int across, double2 offset)
        {
            // The list holds the currents of all bounces.
            int max = Capacity / (job.Pose.MaxBounces * job.Pose.Receivers.Length * across * across);
            double rays = max;
            int count = job.SliceOf(max, max, ref rays);
            _kernels.Clear(_read.Length);
            _kernels.TracePoints(job, count, across, offset);
            _lists.Output.ReadBack(_read, _read.Length);
            job.Sums.Add(_read, 0, 1, _owner);
            job.Took(count, TubeSums.RaysOf(_read, 0));
        }

        /// <summary>Releases all buffers on the device.</summary>
        public void Dispose()
        {
            _kernels.Dispose();
            _lists.Dispose();
            _tubeParts.Dispose();
            _tubeExtras.Dispose();
            _marks.Dispose();
            _links.Dispose();
        }
    }
}
