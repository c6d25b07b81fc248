using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Runtime.InteropServices;
using Glint.Core;
using UnityEngine;

namespace Glint
{
    /// <summary>The rays that a pose keeps one by one, as they come back dispatch by dispatch.</summary>
    sealed class KeptRayList
    {
        // As many received rays as most scenes return; tiles that return more are traced once again with room for all.
        const int FirstCapacity = 65536;

        // Rays of one dispatch: 96 MiB when all are kept, at most 768 MiB when all are received.
        const int MostOfAll = 1 << 21, MostReceived = 1 << 24;

        static readonly int s_rayBytes = Marshal.SizeOf<RayData>();

        readonly string _owner;
        readonly RadarSettings _settings;
        readonly List<RayData[]> _received = new List<RayData[]>();
        readonly RayData[] _all;
        RayData[] _slice = Array.Empty<RayData>();
        long _receivedCount;

        /// <exception cref="GlintException">All rays are to be kept, and this computer has not the memory.</exception>
        public KeptRayList(KeptRays keep, in RadarSettings settings, string owner)
        {
            Keep = keep;
            _settings = settings;
            _owner = owner;
            if (keep == KeptRays.All)
                _all = MakeRays(settings.RaysEmitted, $"all of {settings.RaysEmitted} rays");
        }

        public KeptRays Keep { get; }

        /// <summary>Time taken by reading back, milliseconds.</summary>
        public double ReadBackMs { get; private set; }

        /// <summary>Refuses to keep more rays than this computer has memory for.</summary>
        /// <exception cref="GlintException">It has not as much.</exception>
        public static void Refuse(KeptRays keep, in RadarSettings settings, string owner)
        {
            if (keep == KeptRays.All && (settings.RaysEmitted * (double)s_rayBytes > HostBytes || settings.RaysEmitted > 0x7fffffc7))
                throw TooMany($"all of {settings.RaysEmitted} rays", settings.RaysEmitted * (double)s_rayBytes, owner);
        }

        /// <summary>As many of the tiles as one dispatch may take for what is kept of them; makes room on the device.</summary>
        public int Limit(int tiles, DeviceBuffer<RayData> rays)
        {
            if (Keep == KeptRays.None)
            {
                rays.Reserve(1); // a binding must not be empty
                return tiles;
            }
            long most = Math.Min(DeviceBuffer<RayData>.Most, Keep == KeptRays.All ? MostOfAll : MostReceived);
            tiles = (int)Math.Min(tiles, most / PictureTiles.Rays);
            rays.Reserve(Keep == KeptRays.All ? tiles * PictureTiles.Rays : FirstCapacity);
            return tiles;
        }

        /// <summary>True if more rays were received than there is room for.</summary>
        public bool Wants(uint[] sums, DeviceBuffer<RayData> rays) => Keep == KeptRays.Received && RaySums.CountKept(sums) > rays.Capacity;

        /// <summary>Reads back what a dispatch kept.</summary>
        /// <exception cref="GlintException">More rays are received than this computer has memory for.</exception>
        public void Add(DeviceBuffer<RayData> rays, uint[] sums, int tiles, ref WorkDone work)
        {
            int count = Keep == KeptRays.All ? tiles * PictureTiles.Rays : Keep == KeptRays.Received ? (int)RaySums.CountKept(sums) : 0;
            if (count == 0)
                return;
            var watch = Stopwatch.StartNew();
            if (Keep == KeptRays.All)
            {
                if (_slice.Length < count)
                    _slice = new RayData[count];
                rays.ReadBack(_slice, count);
                Scatter(count);
            }
            else
            {
                _receivedCount += count;
                // Once as they come and once in order, with a number each to order them by.
                int bytes = 2 * s_rayBytes + sizeof(uint);
                if (_receivedCount * (double)bytes > HostBytes)
                    throw TooMany(Received, _receivedCount * (double)bytes, _owner);
                var part = MakeRays(count, Received);
                rays.ReadBack(part, count);
                _received.Add(part);
            }
            work.BytesReadBack += (long)count * s_rayBytes;
            ReadBackMs += watch.Elapsed.TotalMilliseconds;
        }

        /// <summary>The rays in order of their pixel.</summary>
        public RayData[] ToArray()
        {
            if (Keep == KeptRays.All)
                return _all;
            var rays = MakeRays(_receivedCount, Received);
            int at = 0;
            foreach (var part in _received)
            {
                part.CopyTo(rays, at);
                at += part.Length;
            }
            _received.Clear();
            var pixels = new uint[rays.Length];
            for (int i = 0; i < rays.Length; i++)
                pixels[i] = rays[i].Pixel;
            // They come in the order in which the GPU was done with them.
            Array.Sort(pixels, rays);
            return rays;
        }

        static double HostBytes => SystemInfo.systemMemorySize * 1048576.0;

        string Received => $"{_receivedCount} received rays";

        static GlintException TooMany(string rays, double bytes, string owner) =>
            new GlintException($"{owner}: keeping {rays} takes {Text.Mebibytes(bytes)}, and this computer has {Text.Mebibytes(HostBytes)}: keep received rays only, or none, or trace a region or fewer rays");

        RayData[] MakeRays(long count, string what)
        {
            try
            {
                return new RayData[count];
            }
            catch (OutOfMemoryException)
            {
                throw TooMany(what, count * (double)s_rayBytes, _owner);
            }
        }

        void Scatter(int count)
        {
            var region = _settings.Region;
            int width = region.IsWhole ? _settings.RaysAcross : region.Width;
            for (int i = 0; i < count; i++)
            {
                uint pixel = _slice[i].Pixel;
                if (pixel == uint.MaxValue)
                    continue; // beside the picture
                int x = (int)(pixel % (uint)_settings.RaysAcross) - region.Left, y = (int)(pixel / (uint)_settings.RaysAcross) - region.Bottom;
                _all[(long)y * width + x] = _slice[i];
            }
        }
    }
}
