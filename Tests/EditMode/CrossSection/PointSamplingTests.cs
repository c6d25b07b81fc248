using System;
using System.Linq;
using System.Numerics;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>Cross sections by uniform points, which ray tubes are compared with.</summary>
    public sealed class PointSamplingTests : CrossSectionFixture
    {
        const double Width = 0.3, Height = 0.2, TenGigahertz = 1e10;

        static readonly double Wavelength = Signal.Wavelength(TenGigahertz);

        // 16 grids of 2 x 2 points a cell, each shifted by a quarter of its spacing, have the points of 8 x 8.
        [Test, Timeout(60000)]
        public void TracePoints_OfInterleavedGrids_AreOnAverageThoseOfTheFineGrid()
        {
            var corner = CrossSectionTargets.Trihedral(0.2, CrossSectionTargets.TrihedralFace.Square);
            var pose = PoseOf(corner, 40, 30);
            var fine = Tracer.TracePoints(pose, 8, 0.5);
            var coarse = Enumerable.Range(0, 16).Select(i =>
                Tracer.TracePoints(pose, 2, new double2(i % 4 + 0.5, i / 4 + 0.5) / 4)).ToArray();
            Assert.That(coarse.Sum(result => result.Rays), Is.EqualTo(fine.Rays));
            var mean = coarse.Aggregate(Complex.Zero, (sum, result) => sum + result.S[0, 0].VV / coarse.Length);
            // Each current is rounded to 2^-24 of a tube of a square wavelength.
            double unit = 2 * Math.Sqrt(Math.PI) * Wavelength * Math.Pow(2, -24);
            Assert.That((mean - fine.S[0, 0].VV).Magnitude, Is.LessThan(unit * Math.Sqrt(fine.Tubes)));
            Assert.That((coarse[0].S[0, 0].VV - mean).Magnitude, Is.GreaterThan(1e-3 * mean.Magnitude),
                "a coarse grid alone has another sum");
        }

        // 4 pi A^2 / lambda^2. The number of points on the plate is off by some of the 500 along its border, of 17,000.
        [Test, Timeout(60000)]
        public void TracePoints_OfAFacingPlate_HaveItsClosedForm()
        {
            var s = Tracer.TracePoints(PoseOf(CrossSectionTargets.Plate(Width, Height), 0, 0), 16, 0.3).S[0, 0];
            double expected = 2 * Math.Sqrt(Math.PI) * Width * Height / Wavelength;
            Assert.That(s.VV.Magnitude, Is.EqualTo(expected).Within(0.005 * expected));
            Assert.That(s.HH.Magnitude, Is.EqualTo(expected).Within(0.005 * expected));
        }

        // The error by a border of length P in a grid of n points a wavelength: (pi / 3) P lambda / n^3 square metres.
        [Test, Timeout(60000)]
        public void TracePoints_OfATurnedPlate_AreThoseOfTubes([Values(10, 25, 50)] double azimuth)
        {
            const int across = 32;
            var pose = PoseOf(CrossSectionTargets.Plate(Width, Height), azimuth, 15);
            var tubes = Tracer.Trace(pose).S[0, 0];
            var points = Tracer.TracePoints(pose, across, new double2(0.2, 0.7)).S[0, 0];
            double border = 2 * (Width + Height),
                deviation = Math.Sqrt(Math.PI / 3 * border * Wavelength / Math.Pow(across, 3));
            Assert.That((points.VV - tubes.VV).Magnitude, Is.LessThan(3 * deviation));
            Assert.That((points.HH - tubes.HH).Magnitude, Is.LessThan(3 * deviation));
        }

        // The plate's normal is +x, the side of azimuth -90.
        static CrossSectionPose PoseOf(TriangleMesh mesh, double azimuth, double elevation)
        {
            var radar = RadarAspect.At(azimuth - 90, elevation);
            return new CrossSectionPose
            {
                Scene = new RadarScene(mesh), Radar = radar, Receivers = new[] { radar },
                Frequencies = new[] { TenGigahertz }, HasEdges = false, ToleranceDb = 0.01
            };
        }
    }
}
