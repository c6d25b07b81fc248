using System;
using System.Runtime.InteropServices;
using Glint.Core;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// The kernels of a slice and the work lists between them, which stay on the device: candidates, refine pass,
    /// pixels with sub-rays, their candidates and refine pass.
    /// </summary>
    sealed class SlicePass : IDisposable
    {
        /// <summary>
        /// Maximum pixels whose sub-rays are traced together: MAX_CHOSEN in Shaders/Constants.hlsl.
        /// </summary>
        public const int MaxChosen = 16000;

        // Words written at a time into a new buffer.
        const int ClearedWords = 1 << 20;

        readonly TraceKernel _kernel;
        readonly StageKernels _stages;
        readonly CandidateList _candidates, _subRays;
        readonly DeviceBuffer<RayData> _rays = new DeviceBuffer<RayData>("rays kept one by one");
        readonly DeviceBuffer<uint> _chosen = new DeviceBuffer<uint>("pixels with sub-rays");
        readonly DeviceBuffer<uint> _lengths = new DeviceBuffer<uint>("lengths of received rays");
        readonly SliceOutput _output;
        GraphicsBuffer _arguments;

        public SlicePass(TraceKernel kernel, StageKernels stages, SliceOutput output)
        {
            (_kernel, _stages, _output) = (kernel, stages, output);
            _candidates = new CandidateList(kernel.IsWide);
            _subRays = new CandidateList(kernel.IsWide);
            _chosen.Reserve(1);
            if (IsIndirect)
                // Direct3D 11 has no structured argument buffers.
                _arguments = new GraphicsBuffer(GraphicsBuffer.Target.IndirectArguments | GraphicsBuffer.Target.Raw,
                    SliceArguments.Count, sizeof(uint));
        }

        /// <summary>Whether the device counts its own work; else each list costs a round trip.</summary>
        public static bool IsIndirect => SystemInfo.supportsIndirectArgumentsBuffer;

        /// <summary>The candidates of the slice.</summary>
        public CandidateList Candidates => _candidates;

        /// <summary>The rays kept one by one.</summary>
        public DeviceBuffer<RayData> Rays => _rays;

        public long BytesOnDevice => _candidates.Bytes + _subRays.Bytes + _rays.Bytes + _chosen.Bytes + _lengths.Bytes
            + SliceArguments.Count * sizeof(uint);

        /// <summary>Prepares the buffers for a slice.</summary>
        /// <param name="choosesSubRays">The device chooses the pixels with sub-rays after this slice.</param>
        public void Begin(in RadarSettings settings, DeviceBuffer<uint> cells, int tileCount, RayReadback readback,
            bool choosesSubRays)
        {
            long rays = (long)tileCount * PictureTiles.Rays, pixels = PixelsWithSubRays(settings);
            _candidates.Reserve(rays, settings.MaxBounces);
            _rays.Reserve(RaysReadBack(rays, readback));
            if (choosesSubRays)
                ReserveLengths(settings.RaysEmitted);
            _chosen.Reserve(pixels);
            _subRays.Reserve(pixels * SamplingEstimate.SubGrids, settings.MaxBounces);
            _kernel.SetLists(_candidates, _subRays);
            _stages.SetLists(_candidates, _subRays);
            _kernel.SetBuffers(cells, _output, _rays, _chosen, choosesSubRays ? _lengths : null, readback);
            _stages.Set(settings, _kernel.TraceGroup, _kernel.RefineGroup);
            _stages.ClearSums(_output.Buffer);
        }

        /// <summary>Bytes on the device for a pose.</summary>
        /// <param name="rays">Rays of its largest slice.</param>
        public static double Bytes(in RadarSettings settings, long rays, RayReadback readback)
        {
            long pixels = PixelsWithSubRays(settings);
            bool hasLengths = !settings.SkipSamplingError && CanChooseSubRays(settings);
            return CandidateList.BytesFor(rays, settings.MaxBounces)
                + CandidateList.BytesFor(pixels * SamplingEstimate.SubGrids, settings.MaxBounces)
                + RaysReadBack(rays, readback) * (double)Marshal.SizeOf<RayData>()
                + (pixels + (hasLengths ? settings.RaysEmitted : 0)) * (double)sizeof(uint);
        }

        /// <summary>Whether one buffer can hold the length of every ray.</summary>
        public static bool CanChooseSubRays(in RadarSettings settings) =>
            IsIndirect && settings.RaysEmitted <= DeviceBuffer<uint>.MaxCount;

        /// <summary>Traces the rays of some tiles and follows the candidates.</summary>
        public void TraceTiles(int firstTile, int count, TraceStatistics statistics)
        {
            _kernel.TraceTiles(firstTile, count, _candidates);
            statistics.Dispatches += 2;
            Refine(_candidates, areSubRays: false, statistics);
        }

        /// <summary>Follows candidates that the first dispatch left.</summary>
        /// <param name="first">The candidates to search before it are done.</param>
        /// <param name="count">Number of the others.</param>
        /// <param name="firstReceived">Rays received so far.</param>
        public void RefineRest(int first, int count, int firstReceived, TraceStatistics statistics)
        {
            _kernel.Refine(_candidates, areSubRays: false, _arguments, Math.Min(count, CandidateList.MaxRefined), first,
                firstReceived);
            statistics.Dispatches++;
        }

        /// <summary>Chooses pixels for sub-rays on the device, and traces these.</summary>
        public void ChooseAndTraceSubRays(TraceStatistics statistics)
        {
            _stages.ChooseSubRays(_output.Buffer, _candidates, _lengths, _chosen, _arguments);
            _stages.CountGroups(_output.Buffer, _arguments);
            _kernel.TraceSubRays(_subRays, _arguments);
            statistics.Dispatches += 4;
            Refine(_subRays, areSubRays: true, statistics);
            _stages.ForgetLengths(_output.Buffer, _candidates, _lengths, _arguments);
        }

        /// <summary>Traces the sub-rays of given pixels, a slice of its own.</summary>
        /// <param name="pixels">At most <see cref="MaxChosen"/>.</param>
        public void TraceSubRays(uint[] pixels, int first, int count, TraceStatistics statistics)
        {
            _stages.ClearSums(_output.Buffer);
            _output.SetChosen(count);
            _chosen.Write(pixels, first, 0, count);
            statistics.BytesUploaded += (count + 1L) * sizeof(uint);
            _kernel.TraceSubRays(_subRays, _arguments, count);
            statistics.Dispatches += 2;
            Refine(_subRays, areSubRays: true, statistics);
        }

        /// <summary>The received rays of a slice if the output's list does not hold all.</summary>
        public ReceivedRay[] ReadReceived(WorkCounts counts, TraceStatistics statistics)
        {
            int capacity = _candidates.KnownCapacity, known = Math.Min(counts.Known, capacity), count = 0;
            var candidates = new ReceivedRay[capacity + counts.Searched];
            _candidates.Rays.ReadBack(candidates, candidates.Length);
            statistics.RoundTrips++;
            statistics.BytesReadBack += candidates.Length * (long)_candidates.Rays.Stride;
            for (int i = 0; i < candidates.Length; i++)
                if ((i < known || i >= capacity) && candidates[i].Pixel != ReceivedRay.NoPixel)
                    candidates[count++] = candidates[i];
            Array.Resize(ref candidates, count);
            return candidates;
        }

        public void Dispose()
        {
            _candidates.Dispose();
            _subRays.Dispose();
            _rays.Dispose();
            _chosen.Dispose();
            _lengths.Dispose();
            _arguments?.Dispose();
            _arguments = null;
        }

        static long PixelsWithSubRays(in RadarSettings settings) =>
            settings.SkipSamplingError ? 1 : Math.Min(settings.RaysEmitted, MaxChosen);

        // A binding must not be empty.
        static long RaysReadBack(long rays, RayReadback readback) =>
            readback == RayReadback.All ? rays
            : readback == RayReadback.Received ? Math.Min(rays, CandidateList.MaxRefined)
            : 1;

        void Refine(CandidateList candidates, bool areSubRays, TraceStatistics statistics)
        {
            statistics.Dispatches++;
            if (IsIndirect)
            {
                _stages.CountGroups(_output.Buffer, _arguments);
                statistics.Dispatches++;
                _kernel.Refine(candidates, areSubRays, _arguments);
                return;
            }
            var counts = _output.ReadCounts(statistics);
            var (known, searched) = areSubRays ? (counts.SubKnown, counts.SubSearched) : (counts.Known, counts.Searched);
            _kernel.Refine(candidates, areSubRays, null,
                candidates.Threads(Math.Min(known, candidates.KnownCapacity), searched));
        }

        // The lengths of a new buffer are unknown.
        void ReserveLengths(long rays)
        {
            if (rays <= _lengths.Capacity)
                return;
            _lengths.Reserve(rays);
            var none = new uint[Math.Min(rays, ClearedWords)];
            Array.Fill(none, ReceivedRay.NoLength);
            for (long first = 0; first < rays; first += none.Length)
                _lengths.Write(none, 0, (int)first, (int)Math.Min(none.Length, rays - first));
        }
    }
}
