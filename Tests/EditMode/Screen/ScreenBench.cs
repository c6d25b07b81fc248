using System;
using System.Linq;
using Glint.Core;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>A radar screen with points around an antenna that stands still.</summary>
    sealed class ScreenBench : IDisposable
    {
        /// <summary>Height of the antenna above the sea.</summary>
        public const double Height = 15;

        public ScreenBench(in ScreenRadar radar, params (double bearing, double range, double section)[] targets)
            : this(radar, null, targets)
        {
        }

        /// <param name="table">Of the antenna's pattern.</param>
        public ScreenBench(in ScreenRadar radar, string table,
            params (double bearing, double range, double section)[] targets)
        {
            Tracer = new ScreenTracer(TestKernels.Screen, "test", radar, table);
            Points = targets.Select(target => Tracer.Geometry.PointOf(
                At(target.bearing, target.range), new double3(0, Height, 0), target.section)).ToArray();
        }

        public ScreenTracer Tracer { get; }

        public ScreenGeometry Geometry => Tracer.Geometry;

        public ScreenReceiver Receiver = ScreenReceiver.Default;

        public ScreenPoint[] Points;

        /// <summary>Of the antenna, where true trails keep their place.</summary>
        public double2 Position;

        /// <summary>True heading of the own ship, turns.</summary>
        public double Heading;

        public OtherRadar[] Others = Array.Empty<OtherRadar>();

        /// <summary>Default radar with fewer spokes and cells.</summary>
        public static ScreenRadar Small(int spokes = 1024, int cells = 256)
        {
            var radar = ScreenRadar.Default;
            (radar.Spokes, radar.Cells) = (spokes, cells);
            return radar;
        }

        /// <summary>A point at the height of the antenna; bearing in degrees.</summary>
        public static double3 At(double bearing, double range) => new double3(
            range * Math.Sin(math.radians(bearing)), Height, range * Math.Cos(math.radians(bearing)));

        /// <summary>One frame, in which the antenna comes to a bearing, in degrees counted on.</summary>
        public void Frame(double bearing)
        {
            Tracer.Begin(bearing / 360);
            Tracer.AddPoints(Points, Points.Length);
            Tracer.AddRain();
            Tracer.SetOtherRadars(Others, Others.Length);
            Tracer.Finish(Receiver, Position, Heading);
        }

        /// <summary>Turns from a bearing to another in frames of some degrees.</summary>
        public void Turn(double from, double to, double step = 100)
        {
            Frame(from);
            for (double at = from + step; at < to; at += step)
                Frame(at);
            Frame(to);
        }

        /// <summary>dB over noise of all spokes and cells.</summary>
        public float[] Levels()
        {
            var levels = new float[Geometry.Radar.Spokes * Geometry.Radar.Cells];
            Tracer.Levels.ReadBack(levels, levels.Length);
            return levels;
        }

        public float2[] Video()
        {
            var video = new float2[Geometry.Radar.Spokes * Geometry.Radar.Cells];
            Tracer.Video.ReadBack(video, video.Length);
            return video;
        }

        public float[] Trails()
        {
            var trails = new float[TrailMap.Side * TrailMap.Side];
            Tracer.Trails.ReadBack(trails, trails.Length);
            return trails;
        }

        public int Element(int spoke, int cell) =>
            (spoke & (Geometry.Radar.Spokes - 1)) * Geometry.Radar.Cells + cell;

        public void Dispose() => Tracer.Dispose();
    }
}
