using System;
using System.Numerics;
using System.Threading;
using Glint.Core;

namespace Glint
{
    /// <summary>Estimates the sampling error of a pose by sub-rays around received rays.</summary>
    sealed class SamplingPass : IDisposable
    {
        // Maximum pixels of a dispatch.
        const int MaxPixels = DispatchPlan.MaxRefinedRays / SamplingEstimate.SubGrids;

        readonly TraceKernel _kernel;
        readonly SumBuffer _sums;
        readonly DeviceBuffer<RayData> _rays;
        readonly DeviceBuffer<ReceivedRay> _pixels = new DeviceBuffer<ReceivedRay>("pixels to refine");

        public SamplingPass(TraceKernel kernel, SumBuffer sums, DeviceBuffer<RayData> rays)
        {
            _kernel = kernel;
            _sums = sums;
            _rays = rays;
        }

        public long Bytes => _pixels.Bytes;

        /// <summary>Estimates the error of a traced pose.</summary>
        /// <param name="received">Received rays in the first <paramref name="count"/> elements.</param>
        /// <param name="referenceLength">Metres to add to each of their lengths.</param>
        /// <param name="sums">The pose's sums.</param>
        public SamplingReport Estimate(in RadarSettings settings, ReceivedRay[] received, int count,
            double referenceLength, RadarSums sums, TraceStatistics statistics, CancellationToken cancel)
        {
            var estimate = new SamplingEstimate(settings, received, count, referenceLength);
            var pixels = estimate.PixelsToRefine;
            double[] inPhase = new double[SamplingEstimate.SubGrids],
                quadrature = new double[SamplingEstimate.SubGrids];
            var list = new ReceivedRay[Math.Min(pixels.Length, MaxPixels)];
            for (int first = 0; first < pixels.Length; first += MaxPixels)
            {
                cancel.ThrowIfCancellationRequested();
                int some = Math.Min(pixels.Length - first, MaxPixels);
                for (int i = 0; i < some; i++)
                    list[i].Pixel = pixels[first + i];
                _pixels.Upload(list);
                statistics.BytesUploaded += list.Length * (long)_pixels.Stride;
                _sums.Clear(statistics);
                _kernel.DispatchRefine(0, some, SamplingEstimate.SubRays, RayReadback.None, _pixels, _rays);
                ChannelSums.AddPhasors(_sums.ReadBack(statistics), inPhase, quadrature);
            }
            statistics.SubRays = pixels.Length * (long)SamplingEstimate.SubGrids;
            return estimate.Finish(new Complex(sums.InPhase, sums.Quadrature), sums.RaysOfPicture, inPhase, quadrature);
        }

        public void Dispose() => _pixels.Dispose();
    }
}
