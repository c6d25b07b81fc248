using System;
using Glint.Core;
using Unity.Mathematics;

namespace Glint
{
    /// <summary>
    /// Rays that the refine pass follows: first those whose triangles float32 knows, then those to search. Their number
    /// is on the device (<see cref="WorkCounts"/>).
    /// </summary>
    sealed class CandidateList : IDisposable
    {
        // Maximum number of those with known triangles.
        const int MaxKnown = 1 << 17;

        /// <summary>
        /// Threads of those to search if each has several: SPREAD_THREADS in Shaders/Constants.hlsl.
        /// </summary>
        public const int SpreadThreads = 1 << 15;

        // Threads of a wave on most GPUs.
        const int GpuWave = 32;

        /// <summary>Maximum number of candidates of a dispatch: MAX_REFINED in Shaders/Constants.hlsl.</summary>
        public const int MaxRefined = DispatchPlan.MaxRefinedRays;

        /// <summary>
        /// Those to search begin a group of as many threads: CANDIDATE_PADDING in Shaders/Constants.hlsl.
        /// </summary>
        public const int Padding = 64;

        /// <param name="isSoftware">For a software device, which has no threads to spare.</param>
        public CandidateList(bool isSoftware) => MaxSpread = isSoftware ? 1 : GpuWave;

        /// <summary>Maximum number of threads of a candidate to search.</summary>
        public int MaxSpread { get; }

        public DeviceBuffer<ReceivedRay> Rays { get; } = new DeviceBuffer<ReceivedRay>("rays that may be received");

        /// <summary>The triangles that they meet.</summary>
        public DeviceBuffer<uint2> Met { get; } = new DeviceBuffer<uint2>("triangles of rays that may be received");

        /// <summary>Capacity for those with known triangles, from the list's start.</summary>
        public int KnownCapacity { get; private set; }

        public long Bytes => Rays.Bytes + Met.Bytes;

        /// <summary>Ensures the capacity for some rays, all of which may be candidates.</summary>
        public void Reserve(long rays, int maxBounces)
        {
            KnownCapacity = KnownOf(rays);
            Rays.Reserve(KnownCapacity + rays);
            Met.Reserve(MetOf(rays, maxBounces));
        }

        /// <summary>Maximum number of rays whose candidates one buffer holds.</summary>
        public static long MaxRays => DeviceBuffer<ReceivedRay>.MaxCount - MaxKnown;

        /// <summary>Bytes for as many rays.</summary>
        public static double BytesFor(long rays, int maxBounces) =>
            8.0 * (KnownOf(rays) + rays) + 8.0 * MetOf(rays, maxBounces);

        /// <summary>Of the candidates to search those that the first dispatch takes.</summary>
        /// <param name="known">At most the capacity that the list had for them.</param>
        public static int FirstSearched(int known, int searched) => Math.Min(searched, MaxRefined - Padded(known));

        /// <summary>Threads of the first dispatch.</summary>
        /// <param name="known">At most the capacity that the list had for them.</param>
        public int Threads(int known, int searched) =>
            Padded(known) + FirstSearched(known, searched)
            * Math.Max(1, Math.Min(MaxSpread, SpreadThreads / Math.Max(1, searched)));

        static int KnownOf(long rays) => (int)Math.Min(rays, MaxKnown);

        // As many of those to search have some known triangles.
        static long MetOf(long rays, int maxBounces) => 2L * KnownOf(rays) * maxBounces;

        static int Padded(int known) => (known + Padding - 1) / Padding * Padding;

        public void Dispose()
        {
            Rays.Dispose();
            Met.Dispose();
        }
    }

    /// <summary>Byte offsets of the indirect dispatches' numbers of groups.</summary>
    static class SliceArguments
    {
        public const uint Refine = 0, SubRays = 12, RefineSubRays = 24;

        /// <summary>32-bit numbers in all.</summary>
        public const int Count = 9;
    }
}
