using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Runtime.InteropServices;
using Glint.Core;
using Unity.Mathematics;
using UnityEngine;

namespace Glint
{
    /// <summary>The single rays read back from the dispatches of a pose.</summary>
    sealed class RayReadbackBuffer
    {
        static readonly int s_rayBytes = Marshal.SizeOf<RayData>();

        readonly string _owner;
        readonly RadarSettings _settings;
        readonly List<RayData[]> _received = new List<RayData[]>();
        readonly RayData[] _all;
        RayData[] _slice = Array.Empty<RayData>();
        long _receivedCount;

        /// <exception cref="GlintException">This computer's memory does not suffice for all rays.</exception>
        public RayReadbackBuffer(RayReadback readback, in RadarSettings settings, string owner)
        {
            Mode = readback;
            _settings = settings;
            _owner = owner;
            if (readback == RayReadback.All)
                _all = MakeRays(settings.RaysEmitted, $"all of {settings.RaysEmitted} rays");
        }

        public RayReadback Mode { get; }

        /// <summary>Time of reading back and sorting, milliseconds.</summary>
        public double ReadBackMs { get; private set; }

        /// <summary>Refuses to read back more rays than this computer can hold.</summary>
        /// <exception cref="GlintException">The memory does not suffice.</exception>
        public static void Refuse(RayReadback readback, in RadarSettings settings, string owner)
        {
            if (readback == RayReadback.All
                && (settings.RaysEmitted * (double)s_rayBytes > HostBytes || settings.RaysEmitted > 0x7fffffc7))
                throw TooMany($"all of {settings.RaysEmitted} rays", settings.RaysEmitted * (double)s_rayBytes, owner);
        }

        /// <summary>Reads back the rays of some tiles if all are read back.</summary>
        public void AddTiles(DeviceBuffer<RayData> rays, int tiles, TraceStatistics statistics)
        {
            if (Mode != RayReadback.All)
                return;
            int count = tiles * PictureTiles.Rays;
            if (_slice.Length < count)
                _slice = new RayData[count];
            ReadBack(rays, _slice, count, statistics);
            Scatter(count);
        }

        /// <summary>Reads back the received rays of a dispatch if these are read back.</summary>
        /// <exception cref="GlintException">This computer's memory does not suffice for the received rays.</exception>
        public void AddReceived(DeviceBuffer<RayData> rays, int count, TraceStatistics statistics)
        {
            if (Mode != RayReadback.Received || count == 0)
                return;
            _receivedCount += count;
            // Two copies, unsorted and sorted, and a sort key each.
            int bytes = 2 * s_rayBytes + sizeof(uint);
            if (_receivedCount * (double)bytes > HostBytes)
                throw TooMany(Received, _receivedCount * (double)bytes, _owner);
            var part = MakeRays(count, Received);
            ReadBack(rays, part, count, statistics);
            _received.Add(part);
        }

        void ReadBack(DeviceBuffer<RayData> rays, RayData[] into, int count, TraceStatistics statistics)
        {
            var watch = Stopwatch.StartNew();
            rays.ReadBack(into, count);
            statistics.RoundTrips++;
            statistics.BytesReadBack += (long)count * s_rayBytes;
            ReadBackMs += watch.Elapsed.TotalMilliseconds;
        }

        /// <summary>The rays in order of their pixel.</summary>
        public RayData[] ToArray()
        {
            if (Mode == RayReadback.All)
                return _all;
            var watch = Stopwatch.StartNew();
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
            // The GPU writes them in any order.
            Array.Sort(pixels, rays);
            ReadBackMs += watch.Elapsed.TotalMilliseconds;
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
            var region = _settings.TracedRegion;
            for (int i = 0; i < count; i++)
            {
                uint pixel = _slice[i].Pixel;
                if (pixel == ReceivedRay.NoPixel)
                    continue; // outside the picture
                var at = _settings.PositionOf(pixel) - new int2(region.Left, region.Bottom);
                _all[(long)at.y * region.Width + at.x] = _slice[i];
            }
        }
    }
}
