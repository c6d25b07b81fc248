using System;
using System.Collections.Generic;
using System.Numerics;
using Glint.Core;

namespace Glint.Tests
{
    /// <summary>
    /// A picture defined by a formula in place of a scene: the path length of a ray at any position. It takes the
    /// tracer's part of a sampling estimate.
    /// </summary>
    sealed class SampledWave
    {
        readonly RadarSettings _settings;
        readonly Func<double, double, double> _length;

        /// <param name="length">
        /// Path length in metres at a position in pixels from the picture's left and bottom edge; NaN without a
        /// return.
        /// </param>
        public SampledWave(in RadarSettings settings, Func<double, double, double> length)
        {
            _settings = settings;
            _length = length;
            foreach (uint pixel in Pixels())
                if (IsReceived(pixel, 0.5, 0.5, out double there))
                    Rays.Add(new ReceivedRay { Pixel = pixel, Length = (float)(there - ReferenceLength) });
        }

        /// <summary>
        /// Length subtracted from all path lengths, as the tracer subtracts most of the distance to a far scene.
        /// </summary>
        public double ReferenceLength { get; set; } = 12.3456789;

        /// <summary>One ray through the centre of each pixel.</summary>
        public List<ReceivedRay> Rays { get; } = new List<ReceivedRay>();

        /// <summary>The estimate before any sub-ray is traced.</summary>
        public SamplingEstimate Begin() => new SamplingEstimate(_settings, Rays.ToArray(), Rays.Count, ReferenceLength);

        /// <summary>Sums over the rays, and the estimate.</summary>
        public RadarResult Trace()
        {
            var sums = new RadarSums { RaysOfPicture = _settings.RayCount, RaysEmitted = _settings.RaysEmitted };
            foreach (var ray in Rays)
                if (IsReceived(ray.Pixel, 0.5, 0.5, out double length))
                    sums.AddReceived(Phase(length), Math.Cos(Phase(length)), Math.Sin(Phase(length)));
            var estimate = Begin();
            double[] inPhase = new double[SamplingEstimate.SubGrids],
                quadrature = new double[SamplingEstimate.SubGrids];
            foreach (uint pixel in estimate.PixelsToRefine)
                for (int sub = 0; sub < SamplingEstimate.SubGrids; sub++)
                    if (IsReceived(pixel, (sub % SamplingEstimate.SubRays + 0.5) / SamplingEstimate.SubRays,
                        (sub / SamplingEstimate.SubRays + 0.5) / SamplingEstimate.SubRays, out double length))
                    {
                        inPhase[sub] += Math.Cos(Phase(length));
                        quadrature[sub] += Math.Sin(Phase(length));
                    }
            return new RadarResult(sums, estimate.Finish(new Complex(sums.InPhase, sums.Quadrature), sums.RaysOfPicture,
                inPhase, quadrature));
        }

        IEnumerable<uint> Pixels()
        {
            var region = _settings.Region.IsWhole
                ? new RayRegion { Width = _settings.RaysAcross, Height = _settings.RaysDown }
                : _settings.Region;
            for (int y = region.Bottom; y < region.Bottom + region.Height; y++)
                for (int x = region.Left; x < region.Left + region.Width; x++)
                    yield return (uint)(y * _settings.RaysAcross + x);
        }

        bool IsReceived(uint pixel, double x, double y, out double length)
        {
            length = _length(pixel % _settings.RaysAcross + x, pixel / _settings.RaysAcross + y);
            return !double.IsNaN(length);
        }

        double Phase(double length) => Signal.Phase(length, _settings.Wavelength);
    }
}
