using System;
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

        /// <summary>Of ray tubes, once it is traced with others.</summary>
        public RadarResult Result;

        /// <summary>Received rays so far.</summary>
        public ReceivedRayList Received = new ReceivedRayList();

        /// <summary>The read-back of the current slice; null if nothing is to be traced.</summary>
        public Readback Slice;

        /// <summary>Number of the kernels' inputs that were set for it.</summary>
        public int Inputs;

        /// <summary>
        /// Capacity that the slice has for candidates with known triangles: that of the list is the next pose's once it is
        /// started.
        /// </summary>
        public int KnownCapacity;

        /// <summary>Whether the slice has sub-rays of pixels that the device chose.</summary>
        public bool HasSubRays;

        /// <summary>Hash of its meshes and their transforms.</summary>
        public ulong Content;

        /// <summary>When the pose started, and when its current slice was dispatched, by the tracer's clock.</summary>
        public TimeSpan Started, Dispatched;

        /// <summary>Time spent so far on dispatches, on read-backs of slices, and on sums.</summary>
        public TimeSpan Dispatching, ReadingBack, Finishing;
    }
}
