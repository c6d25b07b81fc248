using System;
using System.Threading;
using Glint.Core;

namespace Glint
{
    /// <summary>
    /// The refine pass: the float32 kernel lists candidates, and the refine kernel traces them again in double-float
    /// arithmetic.
    /// </summary>
    sealed class RefinePass : IDisposable
    {
        readonly TraceKernel _kernel;
        readonly SumBuffer _sums;
        readonly DeviceBuffer<RayData> _rays;
        readonly DeviceBuffer<ReceivedRay> _candidates = new DeviceBuffer<ReceivedRay>("rays that may be received");
        ReceivedRay[] _received = new ReceivedRay[1024];

        public RefinePass(TraceKernel kernel, SumBuffer sums, DeviceBuffer<RayData> rays)
        {
            _kernel = kernel;
            _sums = sums;
            _rays = rays;
        }

        /// <summary>The candidates, written by the kernel.</summary>
        public DeviceBuffer<ReceivedRay> Candidates => _candidates;

        public long Bytes => _candidates.Bytes;

        /// <summary>The received rays of the pose, unordered, from the array's start.</summary>
        public ReceivedRay[] Received => _received;

        /// <summary>Number of received rays.</summary>
        public int ReceivedCount { get; private set; }

        /// <summary>Begins a pose.</summary>
        public void Begin() => ReceivedCount = 0;

        /// <summary>Ensures the capacity for all rays of some tiles.</summary>
        public void Reserve(int tiles) => _candidates.Reserve((long)tiles * PictureTiles.Rays);

        /// <summary>Traces the candidates again.</summary>
        public void Follow(int count, ChannelSums sums, RayReadbackBuffer readbackBuffer, TraceStatistics statistics,
            CancellationToken cancel)
        {
            _rays.Reserve(
                readbackBuffer.Mode == RayReadback.Received ? Math.Min(count, DispatchPlan.MaxRefinedRays) : 1);
            for (int first = 0; first < count; first += DispatchPlan.MaxRefinedRays)
            {
                cancel.ThrowIfCancellationRequested();
                int some = Math.Min(count - first, DispatchPlan.MaxRefinedRays);
                _sums.Clear(statistics);
                _kernel.DispatchRefine(first, some, 1, readbackBuffer.Mode, _candidates, _rays);
                sums.Add(_sums.ReadBack(statistics));
                readbackBuffer.AddCandidates(_rays, some, statistics);
            }
            statistics.RaysRefined += count;
            AddReceived(count, statistics);
        }

        /// <summary>Pixels of the pose's received rays, in ascending order.</summary>
        public uint[] ReceivedPixels()
        {
            var pixels = new uint[ReceivedCount];
            for (int i = 0; i < pixels.Length; i++)
                pixels[i] = _received[i].Pixel;
            Array.Sort(pixels);
            return pixels;
        }

        public void Dispose() => _candidates.Dispose();

        // The kernel has replaced each candidate by its pixel and length.
        void AddReceived(int count, TraceStatistics statistics)
        {
            long needed = ReceivedCount + (long)count;
            if (needed > _received.Length)
                Array.Resize(ref _received,
                    (int)Math.Min(0x7fffffc7 / 8, Math.Max(needed, 2L * _received.Length)));
            var part = new ReceivedRay[count];
            _candidates.ReadBack(part, count);
            statistics.BytesReadBack += count * (long)_candidates.Stride;
            foreach (var ray in part)
                if (ray.Pixel != ReceivedRay.NoPixel)
                    _received[ReceivedCount++] = ray;
        }
    }
}
