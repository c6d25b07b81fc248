using System;
using System.Threading;
using Glint.Core;

namespace Glint
{
    /// <summary>
    /// The rays that may be received: listed by the kernel that follows every ray in float32,
    /// followed once more in double-float arithmetic.
    /// </summary>
    sealed class ExactPass : IDisposable
    {
        readonly TraceKernel _kernel;
        readonly SumBuffer _sums;
        readonly DeviceBuffer<RayData> _rays;
        readonly DeviceBuffer<ReceivedRay> _returning = new DeviceBuffer<ReceivedRay>("rays that may be received");
        ReceivedRay[] _received = new ReceivedRay[1024];

        public ExactPass(TraceKernel kernel, SumBuffer sums, DeviceBuffer<RayData> rays)
        {
            _kernel = kernel;
            _sums = sums;
            _rays = rays;
        }

        /// <summary>Filled by the kernel with the rays that may be received.</summary>
        public DeviceBuffer<ReceivedRay> Returning => _returning;

        public long Bytes => _returning.Bytes;

        /// <summary>The received rays of the pose; any order, from the array's start.</summary>
        public ReceivedRay[] Received => _received;

        /// <summary>Their number.</summary>
        public int ReceivedCount { get; private set; }

        /// <summary>Begins a pose.</summary>
        public void Begin() => ReceivedCount = 0;

        /// <summary>Makes room for all rays of some tiles.</summary>
        public void Reserve(int tiles) => _returning.Reserve((long)tiles * PictureTiles.Rays);

        /// <summary>Follows the listed rays once more.</summary>
        public void Follow(int count, ChannelSums sums, KeptRayList kept, TraceStatistics statistics,
            CancellationToken cancel)
        {
            _rays.Reserve(kept.Keep == KeptRays.Received ? Math.Min(count, DispatchPlan.MaxRefinedRays) : 1);
            for (int first = 0; first < count; first += DispatchPlan.MaxRefinedRays)
            {
                cancel.ThrowIfCancellationRequested();
                int some = Math.Min(count - first, DispatchPlan.MaxRefinedRays);
                _sums.Clear(statistics);
                _kernel.DispatchExact(first, some, 1, kept.Keep, _returning, _rays);
                sums.Add(_sums.ReadBack(statistics));
                kept.AddReturning(_rays, some, statistics);
            }
            statistics.RaysFollowedExactly += count;
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

        public void Dispose() => _returning.Dispose();

        // The kernel has replaced each candidate by its pixel and length.
        void AddReceived(int count, TraceStatistics statistics)
        {
            long needed = ReceivedCount + (long)count;
            if (needed > _received.Length)
                Array.Resize(ref _received,
                    (int)Math.Min(0x7fffffc7 / 8, Math.Max(needed, 2L * _received.Length)));
            var part = new ReceivedRay[count];
            _returning.ReadBack(part, count);
            statistics.BytesReadBack += count * (long)_returning.Stride;
            foreach (var ray in part)
                if (ray.Pixel != ReceivedRay.NoPixel)
                    _received[ReceivedCount++] = ray;
        }
    }
}
