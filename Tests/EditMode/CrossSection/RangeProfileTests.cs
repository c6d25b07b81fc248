using System;
using System.Linq;
using System.Numerics;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>Responses of the kernels over a band and their range profiles, beside closed forms.</summary>
    [Category("Slow")]
    public sealed class RangeProfileTests : CrossSectionFixture
    {
        // Metres and hertz.
        const double C = 299792458, Centre = 10e9, Wavelength = C / Centre;

        /// <summary>4 pi a^4 / (3 lambda^2) on the axis, at the corner's range.</summary>
        [Test, Timeout(60000)]
        public void Trihedral_OnItsAxis_IsAPointOfItsCrossSection([Values(12.3, -5.1)] double range,
            [Values("taylor", "none")] string window)
        {
            const double edge = 0.6;
            var axis = PublishedRow.Aspect(Math.Acos(1 / Math.Sqrt(3)) * 180 / Math.PI, 45);
            var pose = PoseOf(CrossSectionTargets.Trihedral(edge, CrossSectionTargets.TrihedralFace.Triangular), axis,
                range);
            var band = Sample(pose, 300e6, 96);
            var profile = ProfileOf(pose, band, window, out var transform, 32);
            var (cell, level) = PointEchoes.Peak(profile);
            double bin = band.RangeResolution;
            Assert.That(transform.RangeOf(cell), Is.EqualTo(range).Within(0.1 * bin));
            double expected = 4 * Math.PI * Math.Pow(edge, 4) / (3 * Wavelength * Wavelength);
            Assert.That(level, Is.EqualTo(10 * Math.Log10(expected)).Within(0.1));
            int inside = profile.Count(each => each > level - 10 * Math.Log10(2));
            Assert.That(inside * transform.CellSize / bin, Is.EqualTo(Window.Named(window).Width(0.5)).Within(0.1));
            // The highest sidelobe.
            int peak = (int)Math.Round(cell), end = peak;
            while (profile[end + 1] < profile[end])
                end++;
            double sidelobe = profile.Skip(end).Max() - level;
            Assert.That(sidelobe, Is.EqualTo(Window.Named(window).SidelobeDb).Within(0.5));
        }

        /// <summary>
        /// A plate of 10 m at 45 degrees: S = -j sqrt(4 pi) A / lambda cos(theta) sinc(k w sin(theta)), by physical
        /// optics, at each frequency.
        /// </summary>
        [Test, Timeout(60000)]
        public void Plate_Of10MetresAt45Degrees_HasItsClosedFormAtEachFrequency()
        {
            const double width = 10, height = 10;
            var pose = PoseOf(CrossSectionTargets.Plate(width, height), PublishedRow.Aspect(90, 45), 0);
            var band = Sample(pose, 300e6, 128);
            var s = Tracer.Trace(pose).S;
            double error = 0, highest = 0;
            for (int n = 0; n < band.Count; n++)
            {
                double k = 2 * Math.PI * band.Frequency(n) / C, x = k * width * Math.Sqrt(0.5),
                    expected = Math.Sqrt(4 * Math.PI) * width * height * k / (2 * Math.PI) * Math.Sqrt(0.5)
                        * Math.Sin(x) / x;
                highest = Math.Max(highest, expected * expected);
                foreach (var measured in new[] { s[0, n].VV, s[0, n].HH })
                    error = Math.Max(error, Power(measured - new Complex(0, -expected)));
            }
            Assert.That(10 * Math.Log10(error / highest), Is.LessThan(-60));
        }

        /// <summary>
        /// The double bounce of a dihedral is a point at its edge, whatever the aspect: both ways have twice the edge's
        /// length. Its aperture is 2 a b sin(phi), phi from the nearer face.
        /// </summary>
        [Test, Timeout(60000)]
        public void Dihedral_FromAnyAspect_IsAPointAtItsEdge([Values(25, 45, 58)] double phi)
        {
            const double a = 1.5, b = 0.3, range = 7.77;
            var pose = PoseOf(CrossSectionTargets.Dihedral(a, b), PublishedRow.Aspect(90, phi), range);
            var band = Sample(pose, 300e6, 64);
            var (cell, level) = PointEchoes.Peak(ProfileOf(pose, band, "taylor", out var transform));
            Assert.That(transform.RangeOf(cell), Is.EqualTo(range).Within(0.1 * band.RangeResolution));
            double aperture = 2 * a * b * Math.Sin(math.radians(Math.Min(phi, 90 - phi)));
            Assert.That(level, Is.EqualTo(Dbsm(aperture)).Within(0.1));
        }

        /// <summary>
        /// A ray that enters between two parallel walls w apart, under 45 degrees, and meets their end wall at depth D,
        /// returns if it meets n walls, n odd: it turns back about the image of the edge at (n + 1) w / 2 beside the
        /// first wall. Where D is 3 w / 4, half of the opening returns after one wall; where D is 7 w / 4, after three.
        /// </summary>
        [TestCase(0.75, 1)]
        [TestCase(1.75, 3)]
        [Timeout(60000)]
        public void ParallelWalls_WithAnEnd_HaveAGhostAtTheImageOfTheirEdge(double depth, int walls)
        {
            const double width = 1, height = 0.5;
            var pose = PoseOf(Channel(width, height, depth), RadarAspect.At(45, 0), 0);
            var band = Sample(pose, 600e6, 64);
            var profile = ProfileOf(pose, band, "taylor", out var transform);
            var (cell, level) = PointEchoes.Peak(profile);
            double expected = (depth + (walls + 1) / 2 * width) * Math.Sqrt(0.5);
            Assert.That(transform.RangeOf(cell), Is.EqualTo(expected).Within(0.1 * band.RangeResolution));
            Assert.That(level, Is.EqualTo(Dbsm(0.5 * width * Math.Sqrt(0.5) * height)).Within(0.1));
        }

        /// <summary>A plate of 0.2 m hides the middle of one of 0.4 m half a metre behind.</summary>
        [Test, Timeout(60000)]
        public void Plates_BehindEachOther_AreTwoPointsOfTheirVisibleAreas()
        {
            var pose = PoseOf(CrossSectionTargets.HiddenPlate(0.2, 0.4, 0.5), PublishedRow.Aspect(90, 0), 0);
            var band = Sample(pose, 1500e6, 64);
            var profile = ProfileOf(pose, band, "blackman", out var transform);
            double LevelAt(double range) => Enumerable.Range(0, profile.Length)
                .Where(cell => Math.Abs(transform.RangeOf(cell) - range) < band.RangeResolution)
                .Max(cell => profile[cell]);
            Assert.That(LevelAt(-0.5), Is.EqualTo(Dbsm(0.04)).Within(0.1), "in front");
            Assert.That(LevelAt(0), Is.EqualTo(Dbsm(0.16 - 0.04)).Within(0.1), "behind");
        }

        /// <summary>By default echoes of two bounces are not folded over others.</summary>
        [Test]
        public void CountOfFrequencies_HoldsTheTargetAndItsDoubleBounces()
        {
            double3 min = new double3(-5, 0, -30), max = new double3(5, 20, 30);
            double reach = EchoBand.Reach(min, max, 0, true);
            var frequencies = EchoBand.Frequencies(9.4e9, 150e6, (int)EchoBand.CountFor(reach, 150e6));
            Assert.That(frequencies.Average(), Is.EqualTo(9.4e9).Within(1e-3));
            double step = frequencies[1] - frequencies[0], unambiguous = C / (2 * step);
            Assert.That(unambiguous, Is.InRange(2 * reach + 8 * 0.999, 2 * reach + 10));
        }

        /// <summary>
        /// Echoes of up to two bounces, from all directions, of points all over a box: half of the way that is longer
        /// than that over the phase centre. The longest bounces far from each other, beside the direction of the radar.
        /// </summary>
        [TestCase(true)]
        [TestCase(false)]
        public void Reach_OfABox_IsTheFarthestEchoOfTwoBounces(bool isMonostatic)
        {
            double3 min = new double3(-5, 0, -30), max = new double3(5, 20, 30), centre = new double3(0, 10, 0);
            double reach = EchoBand.Reach(min, max, centre, isMonostatic), farthest = 0;
            var random = new System.Random(1);
            double3 Any() => new double3(random.NextDouble(), random.NextDouble(), random.NextDouble());
            // Many at corners.
            double3 Point() => math.lerp(min, max, math.saturate(3 * Any() - 1)) - centre;
            for (int i = 0; i < 200000; i++)
            {
                double3 a = Point(), b = Point(), from = math.normalize(Any() - 0.5),
                    to = isMonostatic ? from : math.normalize(Any() - 0.5);
                farthest = Math.Max(farthest, (math.dot(from, a) + math.distance(a, b) + math.dot(to, b)) / 2);
            }
            Assert.That(farthest, Is.InRange(0.97 * reach, reach));
        }

        // A plate of this area at normal incidence, or its equal, at the band's centre.
        static double Dbsm(double area) => 10 * Math.Log10(4 * Math.PI * area * area / (Wavelength * Wavelength));

        static double Power(Complex value) => value.Real * value.Real + value.Imaginary * value.Imaginary;

        // The target's own origin at this range from the phase centre, away from the radar.
        static CrossSectionPose PoseOf(TriangleMesh mesh, RadarAspect radar, double range)
        {
            var toWorld = Affine.Identity;
            toWorld.Origin = -range * radar.ToRadar;
            return new CrossSectionPose
            {
                Scene = new RadarScene(new MeshInstance { Mesh = mesh, ToWorld = toWorld }), Radar = radar,
                Receivers = new[] { radar }, ToleranceDb = 0.02, HasEdges = false
            };
        }

        static FrequencyBand Sample(CrossSectionPose pose, double bandwidth, int count)
        {
            pose.Frequencies = EchoBand.Frequencies(Centre, bandwidth, count);
            return new FrequencyBand(pose.Frequencies[0], bandwidth / count, count);
        }

        double[] ProfileOf(CrossSectionPose pose, FrequencyBand band, string window, out RangeTransform transform,
            int padding = 8)
        {
            var s = Tracer.Trace(pose).S;
            transform = new RangeTransform(band, Window.Named(window), padding, -0.5 * band.UnambiguousRange);
            return PowerLevel.Decibels(transform.Profile(
                Enumerable.Range(0, band.Count).Select(n => s[0, n].VV).ToArray()));
        }

        // Walls in x = 0 and x = width, an end in z = depth, open towards -z.
        static TriangleMesh Channel(double width, double height, double depth)
        {
            var outline = new[] { new float2(0, 0), new float2(0, (float)depth),
                new float2((float)width, (float)depth), new float2((float)width, 0) };
            var corners = outline.SelectMany(at => new[] { new float3(at.x, 0, at.y),
                new float3(at.x, (float)height, at.y) }).ToArray();
            return new TriangleMesh(corners, Enumerable.Range(0, 3).SelectMany(i => new[]
                { 2 * i, 2 * i + 1, 2 * i + 3, 2 * i, 2 * i + 3, 2 * i + 2 }).ToArray());
        }
    }
}
