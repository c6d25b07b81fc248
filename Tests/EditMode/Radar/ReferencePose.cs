using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Threading.Tasks;
using Glint.Core;
using Glint.Reference;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>
    /// A pose by the reference tracer with the estimate of its sampling error, and the converged pose.
    /// </summary>
    sealed class ReferencePose
    {
        // Sub-rays across and down a pixel that received a ray, or is next to one that did.
        const int Many = 16;

        readonly RadarSettings _settings;
        readonly ReferenceTracer _referenceTracer;
        readonly Dictionary<uint, double> _received; // lengths by pixel

        public ReferencePose(RadarScene scene, in RadarSettings settings, in RadarView view)
        {
            _settings = settings;
            _referenceTracer = new ReferenceTracer(new RadarPose(scene, settings, view));
            var region = RegionOf(settings);
            var pixels = Enumerable.Range(0, region.Width * region.Height).Select(i => (uint)(
                (region.Bottom + i / region.Width) * _settings.RaysAcross + region.Left + i % region.Width)).ToArray();
            var rays = new ReferenceRay[pixels.Length];
            Parallel.For(0, pixels.Length, i => rays[i] = RayThrough(pixels[i], 0, 1));
            _received = Enumerable.Range(0, pixels.Length).Where(i => rays[i].Received)
                .ToDictionary(i => pixels[i], i => rays[i].PathLength);
        }

        /// <summary>Sums over one ray for each pixel, with the estimate.</summary>
        public RadarResult Trace()
        {
            double reference = _received.Count > 0 ? _received.Values.Min() : 0;
            var rays = _received.Select(
                ray => new ReceivedRay { Pixel = ray.Key, Length = (float)(ray.Value - reference) }).ToArray();
            var estimate = new SamplingEstimate(_settings, rays, rays.Length, reference);
            var sums = Sums(estimate.PixelsToRefine, SamplingEstimate.SubRays);
            Complex sum = _received.Values.Aggregate(Complex.Zero, (before, length) => before + Phasor(length));
            var total = new RadarSums
            {
                RaysOfPicture = _settings.RayCount, RaysReceived = rays.Length, InPhase = sum.Real,
                Quadrature = sum.Imaginary
            };
            return new RadarResult(total, estimate.Finish(sum, _settings.RayCount,
                Array.ConvertAll(sums, part => part.Real), Array.ConvertAll(sums, part => part.Imaginary)));
        }

        /// <summary>Normalised amplitude.</summary>
        public double ConvergedAmplitude()
        {
            var region = RegionOf(_settings);
            var pixels = new HashSet<uint>();
            foreach (uint pixel in _received.Keys)
                for (long y = Math.Max(region.Bottom, pixel / _settings.RaysAcross - 1);
                    y <= Math.Min(region.Bottom + region.Height - 1, pixel / _settings.RaysAcross + 1); y++)
                    for (long x = Math.Max(region.Left, pixel % _settings.RaysAcross - 1);
                        x <= Math.Min(region.Left + region.Width - 1, pixel % _settings.RaysAcross + 1); x++)
                        pixels.Add((uint)(y * _settings.RaysAcross + x));
            Complex sum = Sums(pixels.ToArray(), Many).Aggregate(Complex.Add);
            return sum.Magnitude / (Many * Many) * RadarResult.NormalRays / _settings.RayCount;
        }

        /// <summary>The same picture, traced only where rays return and a little around it.</summary>
        public static RadarSettings RegionOfReturns(RadarScene scene, RadarSettings settings, in RadarView view)
        {
            const int margin = 4;
            var pose = new ReferencePose(scene, settings, view);
            int[] columns = pose._received.Keys.Select(pixel => (int)(pixel % pose._settings.RaysAcross)).ToArray(),
                rows = pose._received.Keys.Select(pixel => (int)(pixel / pose._settings.RaysAcross)).ToArray();
            settings.Region = new RayRegion
            {
                Left = columns.Min() - margin, Bottom = rows.Min() - margin,
                Width = columns.Max() - columns.Min() + 2 * margin, Height = rows.Max() - rows.Min() + 2 * margin
            };
            return settings;
        }

        /// <summary>Five scenes in several poses.</summary>
        public static IEnumerable<ReferencePose> Sample()
        {
            const int poses = 6;
            var settings = TestRadar.Settings();
            var random = new System.Random(4);
            double Next() => random.NextDouble();
            var body = new SeaAndShip(1, 1000, 20000).Ship;
            var waves = TestMeshes.Sea(40, 40);
            for (int i = 0; i < poses; i++)
            {
                double3 corner = 40 * normalize(double3(0.6 + Next(), 0.6 + Next(), 0.6 + Next()));
                yield return new ReferencePose(new RadarScene(TestRadar.Trihedral(0, 2)), settings,
                    TestRadar.LookAt(corner, 0.5, fov: 3));

                double turn = radians(1.5 * Next());
                yield return new ReferencePose(new RadarScene(TestRadar.FacingPlate(2 + (float)Next(), 0)), settings,
                    TestRadar.LookAt(30 * double3(sin(turn), 0.01, -cos(turn)), 0, fov: 6));

                var dihedral = TestRadar.Join(TestRadar.Plate(float3(-2, 0, 0), float3(4, 0, 0), float3(0, 0, -3)),
                    TestRadar.Plate(float3(-2, 0, 0), float3(4, 0, 0), float3(0, 3, 0)));
                double up = radians(25 + 35 * Next());
                yield return new ReferencePose(new RadarScene(dihedral), settings,
                    TestRadar.LookAt(30 * double3(0.03 * Next(), sin(up), -cos(up)), double3(0, 0.5, -0.5), fov: 8));

                double side = 2 * PI_DBL * Next();
                yield return new ReferencePose(new RadarScene(body), settings,
                    TestRadar.LookAt(50 * double3(cos(side), 0.17, sin(side)), double3(0, 3, 0), fov: 10));

                yield return new ReferencePose(new RadarScene(waves), settings,
                    TestRadar.LookAt(double3(10 + 3 * Next(), 30, 10 + 3 * Next()), double3(10, 0, 10.1), fov: 8));
            }
        }

        static RayRegion RegionOf(in RadarSettings settings) => settings.Region.IsWhole
            ? new RayRegion { Width = settings.RaysAcross, Height = settings.RaysDown }
            : settings.Region;

        // Sums over pixels, by the sub-ray's number in its pixel.
        Complex[] Sums(uint[] pixels, int across)
        {
            var sums = new Complex[across * across];
            Parallel.For(0, sums.Length, sub =>
            {
                foreach (uint pixel in pixels)
                {
                    var ray = RayThrough(pixel, sub, across);
                    if (ray.Received)
                        sums[sub] += Phasor(ray.PathLength);
                }
            });
            return sums;
        }

        ReferenceRay RayThrough(uint pixel, int sub, int across) => _referenceTracer.Trace(
            pixel % _settings.RaysAcross + (sub % across + 0.5) / across - 0.5,
            pixel / _settings.RaysAcross + (sub / across + 0.5) / across - 0.5);

        Complex Phasor(double length) => Complex.FromPolarCoordinates(1, Signal.Phase(length, _settings.Wavelength));
    }
}
