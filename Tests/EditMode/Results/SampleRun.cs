using System;
using Glint.Core;

namespace Glint.Tests
{
    /// <summary>Rows and a run with values that are easy to distinguish in a file.</summary>
    static class SampleRun
    {
        public static SweepRow Row(double angle, double inPhase = 3, double quadrature = -4, long[] histogram = null) =>
            new SweepRow(new SweepPose(angle), new RadarResult(new RadarSums
            {
                InPhase = inPhase,
                Quadrature = quadrature,
                RaysOfPicture = 4147200,
                RaysEmitted = 2073600,
                RaysHit = 900,
                RaysReceived = 300,
                Bounces = 1200,
                PathLengthMeters = 41.25,
                RayArea = 0.0625,
                PhaseHistogram = histogram ?? new long[Signal.PhaseBins]
            }, new SamplingReport(0.25, 0.125, true), null, new TraceStatistics
            {
                Timings = new Timings { GatherMs = 1, BuildMs = 2, UploadMs = 4, TraceMs = 8.5, ReadBackMs = 0.5 }
            }));

        public static SweepRow Miss(double angle, long[] histogram = null) => new SweepRow(new SweepPose(angle),
            new RadarResult(new RadarSums { RaysEmitted = 100, PhaseHistogram = histogram },
                new SamplingReport(0, 0, false)));

        public static RunInfo Info()
        {
            var info = new RunInfo
            {
                ScenePath = "Packages/com.glint.scenes/\"quoted\"\\\u00e5.unity",
                TargetName = "Corner Reflector",
                Objects = 3,
                Triangles = 36,
                DeviceName = "llvmpipe",
                GraphicsApi = "Vulkan",
                GlintVersion = "0.1.0",
                UnityVersion = "6000.0.78f1",
                StartedUtc = new DateTime(2025, 3, 4, 15, 6, 7, DateTimeKind.Utc),
                ElapsedMs = 1234.5
            };
            info.Settings.Add(new RunSetting("frequency", 10e9, "Hz"));
            info.Settings.Add(new RunSetting("receiver_reference", "camera"));
            return info;
        }
    }
}
