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
        // Rays of one dispatch: 96 MiB when all are kept.
        const int MostOfAll = 1 << 21;

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
            if (keep == KeptRays.All
                && (settings.RaysEmitted * (double)s_rayBytes > HostBytes || settings.RaysEmitted > 0x7fffffc7))
                throw TooMany($"all of {settings.RaysEmitted} rays", settings.RaysEmitted * (double)s_rayBytes, owner);
        }

        /// <summary>Tiles that one dispatch may take at most when all rays are kept.</summary>
        public static int MostTiles => (int)Math.Min(DeviceBuffer<RayData>.Most, MostOfAll) / PictureTiles.Rays;

        /// <summary>
        /// As many of the tiles as one dispatch may take for what is kept of them;
        /// makes room for all of their rays if all are kept.
        /// </summary>
        public int Limit(int tiles, DeviceBuffer<RayData> rays)
        {
            if (Keep == KeptRays.All)
                tiles = Math.Min(tiles, MostTiles);
            rays.Reserve(Keep == KeptRays.All ? tiles * PictureTiles.Rays : 1); // a binding must not be empty
            return tiles;
        }

        /// <summary>Reads back the rays of some tiles when all are kept.</summary>
        public void AddTiles(DeviceBuffer<RayData> rays, int tiles, ref WorkDone work)
        {
            if (Keep != KeptRays.All)
                return;
            int count = tiles * PictureTiles.Rays;
            if (_slice.Length < count)
                _slice = new RayData[count];
            ReadBack(rays, _slice, count, ref work);
            Scatter(count);
        }

        /// <summary>Reads back rays that were followed once more, when received ones are kept.</summary>
        /// <exception cref="GlintException">More rays are received than this computer has memory for.</exception>
        public void AddReturning(DeviceBuffer<RayData> rays, int count, ref WorkDone work)
        {
            if (Keep != KeptRays.Received)
                return;
            _receivedCount += count;
            // Once as they come and once in order, with a number each to order them by.
            int bytes = 2 * s_rayBytes + sizeof(uint);
            if (_receivedCount * (double)bytes > HostBytes)
                throw TooMany(Received, _receivedCount * (double)bytes, _owner);
            var part = MakeRays(count, Received);
            ReadBack(rays, part, count, ref work);
            part = Array.FindAll(part, ray => ray.IsReceived);
            _receivedCount += part.Length - count;
            _received.Add(part);
        }

        void ReadBack(DeviceBuffer<RayData> rays, RayData[] into, int count, ref WorkDone work)
        {
            var watch = Stopwatch.StartNew();
            rays.ReadBack(into, count);
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
            new GlintException($"{owner}: keeping {rays} takes {Text.Mebibytes(bytes)}, and this computer has "
                + $"{Text.Mebibytes(HostBytes)}: keep received rays only, or none, or trace a region or fewer rays");

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
                int x = (int)(pixel % (uint)_settings.RaysAcross) - region.Left,
                    y = (int)(pixel / (uint)_settings.RaysAcross) - region.Bottom;
                _all[(long)y * width + x] = _slice[i];
            }
        }
    }
}
