using System.Diagnostics;
using Glint.Core;

namespace Glint
{
    /// <summary>A pose whose work the device has, from <see cref="RayTracer.Start"/> to its result.</summary>
    sealed class PoseInFlight
    {
        public RadarPose Pose;
        public RayReadback Readback;
        public RayGrid Grid;
        public DispatchPlan Plan;
        public ChannelSums Sums;
        public RayReadbackBuffer Rays;
        public TraceStatistics Statistics;

        /// <summary>Received rays so far.</summary>
        public ReceivedRayList Received = new ReceivedRayList();

        /// <summary>The read-back of the current slice; null if nothing is to be traced.</summary>
        public Readback Slice;

        /// <summary>Whether the slice has sub-rays of pixels that the device chose.</summary>
        public bool HasSubRays;

        public readonly Stopwatch Watch = Stopwatch.StartNew();
    }
}
