using System;
using System.Threading;
using Glint.Core;

namespace Glint
{
    /// <summary>
    /// The rays that may be received: listed by the kernel that follows every ray in float32,
    /// followed once more in two-float arithmetic, and then looked at more closely for the sampling error.
    /// </summary>
    sealed class ExactPass : IDisposable
    {
        // Rays of a dispatch: a millisecond on a GPU, where a launch lasts as long as its longest ray;
        // one to six seconds on a software device.
        public const int MostRays = 1 << 18;

        const uint NoPixel = uint.MaxValue;

        readonly TraceKernel _kernel;
        readonly DeviceBuffer<uint> _sums;
        readonly DeviceBuffer<RayData> _rays;
        readonly DeviceBuffer<ReceivedRay> _returning = new DeviceBuffer<ReceivedRay>("rays that may be received");
        readonly uint[] _words = new uint[RaySums.Slots * RaySums.WordsPerSlot];
        ReceivedRay[] _received = new ReceivedRay[1024];
        int _count;

        public ExactPass(TraceKernel kernel, DeviceBuffer<uint> sums, DeviceBuffer<RayData> rays)
        {
            _kernel = kernel;
            _sums = sums;
            _rays = rays;
        }

        /// <summary>Where the kernel lists the rays that may be received.</summary>
        public DeviceBuffer<ReceivedRay> Returning => _returning;

        public long Bytes => _returning.Bytes;

        /// <summary>Begins a pose.</summary>
        public void Begin() => _count = 0;

        /// <summary>Tiles that one dispatch may take at most.</summary>
        public static int MostTiles => (int)Math.Min(int.MaxValue, DeviceBuffer<ReceivedRay>.Most / PictureTiles.Rays);

        /// <summary>As many of the tiles as one dispatch may take, and room for all their rays.</summary>
        public int Limit(int tiles)
        {
            tiles = Math.Min(tiles, MostTiles);
            _returning.Reserve((long)tiles * PictureTiles.Rays);
            return tiles;
        }

        /// <summary>Follows the listed rays once more.</summary>
        public void Follow(int count, RaySums sums, KeptRayList kept, ref WorkDone work, CancellationToken cancel)
        {
            _rays.Reserve(kept.Keep == KeptRays.Received ? Math.Min(count, MostRays) : 1);
            for (int first = 0; first < count; first += MostRays)
            {
                cancel.ThrowIfCancellationRequested();
                int some = Math.Min(count - first, MostRays);
                sums.Add(Dispatch(first, some, 1, kept.Keep, ref work));
                kept.AddReturning(_rays, some, ref work);
            }
            work.RaysFollowedExactly += count;
            AddReceived(count, ref work);
        }

        /// <summary>What the received rays tell of the sampling error; traces smaller rays around them.</summary>
        public void Estimate(in RadarSettings settings, RayGrid grid, RadarResult result, CancellationToken cancel)
        {
            var estimate = new SamplingEstimate(settings, _received, _count, 2 * grid.StartDepth);
            var pixels = estimate.PixelsToRefine;
            double[] inPhase = new double[SamplingEstimate.SubGrids],
                quadrature = new double[SamplingEstimate.SubGrids];
            const int most = MostRays / SamplingEstimate.SubGrids;
            var list = new ReceivedRay[Math.Min(pixels.Length, most)];
            for (int first = 0; first < pixels.Length; first += most)
            {
                cancel.ThrowIfCancellationRequested();
                int count = Math.Min(pixels.Length - first, most);
                for (int i = 0; i < count; i++)
                    list[i].Pixel = pixels[first + i];
                _returning.Upload(list);
                result.Work.BytesUploaded += list.Length * (long)_returning.Stride;
                RaySums.AddPhasors(Dispatch(0, count, SamplingEstimate.SubRays, KeptRays.None, ref result.Work),
                    inPhase, quadrature);
            }
            result.Work.SubRays = pixels.Length * (long)SamplingEstimate.SubGrids;
            estimate.Finish(inPhase, quadrature, result);
        }

        /// <summary>Pixels of the pose's received rays, in ascending order.</summary>
        public uint[] ReceivedPixels()
        {
            var pixels = new uint[_count];
            for (int i = 0; i < _count; i++)
                pixels[i] = _received[i].Pixel;
            Array.Sort(pixels);
            return pixels;
        }

        public void Dispose() => _returning.Dispose();

        uint[] Dispatch(int first, int count, int subRays, KeptRays keep, ref WorkDone work)
        {
            Array.Clear(_words, 0, _words.Length);
            _sums.Buffer.SetData(_words);
            _kernel.DispatchExact(first, count, subRays, keep, _returning, _rays);
            _sums.ReadBack(_words, _words.Length);
            work.Dispatches++;
            work.BytesUploaded += _sums.Bytes;
            work.BytesReadBack += _sums.Bytes;
            return _words;
        }

        // The kernel has put pixel and length where each ray was listed.
        void AddReceived(int count, ref WorkDone work)
        {
            if (_count + (long)count > _received.Length)
                Array.Resize(ref _received,
                    (int)Math.Min(0x7fffffc7 / 8, Math.Max(_count + (long)count, 2L * _received.Length)));
            var part = new ReceivedRay[count];
            _returning.ReadBack(part, count);
            work.BytesReadBack += count * (long)_returning.Stride;
            foreach (var ray in part)
                if (ray.Pixel != NoPixel)
                    _received[_count++] = ray;
        }
    }
}
