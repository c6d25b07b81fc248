using System;
using System.Collections.Generic;
using System.Diagnostics;
using Glint.Core;
using UnityEngine;

namespace Glint
{
    /// <summary>The rays that a pose keeps one by one, as they come back dispatch by dispatch.</summary>
    sealed class KeptRayList
    {
        readonly RadarSettings _settings;
        readonly List<RayData[]> _received = new List<RayData[]>();
        readonly RayData[] _all;

        KeptRayList(KeptRays keep, in RadarSettings settings, RayData[] all)
        {
            Keep = keep;
            _settings = settings;
            _all = all;
        }

        public KeptRays Keep { get; }

        /// <summary>Time taken by reading back, milliseconds.</summary>
        public double ReadBackMs { get; private set; }

        /// <exception cref="GlintException">All rays are to be kept, and this computer has not the memory.</exception>
        public static KeptRayList For(KeptRays keep, in RadarSettings settings, string owner)
        {
            if (keep != KeptRays.All)
                return new KeptRayList(keep, settings, null);
            double bytes = settings.RaysEmitted * (double)RayBytes;
            double held = SystemInfo.systemMemorySize * 1048576.0;
            if (bytes > held || settings.RaysEmitted > 0x7fffffc7)
                throw new GlintException($"{owner}: keeping all of {settings.RaysEmitted} rays takes {Text.Mebibytes(bytes)}, and this computer has {Text.Mebibytes(held)}: keep received rays only, or trace a region or fewer rays");
            return new KeptRayList(keep, settings, new RayData[settings.RaysEmitted]);
        }

        /// <summary>As many of the tiles as there is room for on the device, which is made as large as need be.</summary>
        public int Limit(int tiles, DeviceBuffer<RayData> rays)
        {
            if (Keep != KeptRays.All)
                return tiles;
            tiles = (int)Math.Min(tiles, DeviceBuffer<RayData>.Most / PictureTiles.Rays);
            rays.Reserve((long)tiles * PictureTiles.Rays);
            return tiles;
        }

        /// <summary>True if more rays were received than there is room for.</summary>
        public bool Wants(uint[] sums, DeviceBuffer<RayData> rays) => Keep == KeptRays.Received && RaySums.CountKept(sums) > rays.Capacity;

        /// <summary>Reads back what a dispatch kept.</summary>
        public void Add(DeviceBuffer<RayData> rays, uint[] sums, int tiles, ref WorkDone work)
        {
            int count = Keep == KeptRays.All ? tiles * PictureTiles.Rays : Keep == KeptRays.Received ? (int)RaySums.CountKept(sums) : 0;
            if (count == 0)
                return;
            var watch = Stopwatch.StartNew();
            var read = new RayData[count];
            rays.ReadBack(read, count);
            work.BytesReadBack += (long)count * rays.Stride;
            if (Keep == KeptRays.All)
                Scatter(read);
            else
                _received.Add(read);
            ReadBackMs += watch.Elapsed.TotalMilliseconds;
        }

        /// <summary>The rays in order of their pixel.</summary>
        public RayData[] ToArray()
        {
            if (Keep == KeptRays.All)
                return _all;
            int count = 0;
            foreach (var part in _received)
                count += part.Length;
            var rays = new RayData[count];
            var pixels = new uint[count];
            int at = 0;
            foreach (var part in _received)
            {
                part.CopyTo(rays, at);
                at += part.Length;
            }
            for (int i = 0; i < count; i++)
                pixels[i] = rays[i].Pixel;
            // They come in the order in which the GPU was done with them.
            Array.Sort(pixels, rays);
            return rays;
        }

        static int RayBytes => System.Runtime.InteropServices.Marshal.SizeOf<RayData>();

        void Scatter(RayData[] rays)
        {
            var region = _settings.Region;
            int width = region.IsWhole ? _settings.RaysAcross : region.Width;
            foreach (var ray in rays)
            {
                if (ray.Pixel == uint.MaxValue)
                    continue; // beside the picture
                int x = (int)(ray.Pixel % (uint)_settings.RaysAcross) - region.Left, y = (int)(ray.Pixel / (uint)_settings.RaysAcross) - region.Bottom;
                _all[(long)y * width + x] = ray;
            }
        }
    }
}
