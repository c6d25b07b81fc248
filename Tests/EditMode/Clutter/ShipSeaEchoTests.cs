using System;
using System.Linq;
using System.Numerics;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>What ripples of the sea scatter between a ship and the radar.</summary>
    public sealed class ShipSeaEchoTests
    {
        const double TenGigahertz = 1e10, Width = 0.8, Height = 0.6;

        static readonly double3 s_up = new double3(0, 1, 0), s_wind = new double3(0, 0, 1);

        static readonly Complex s_water = Medium.SeaWater(20, 35).At(TenGigahertz).permittivity;

        static readonly Elfouhaily s_waves = new Elfouhaily(10);

        static readonly BistaticScattering s_scattering =
            new BistaticScattering(TenGigahertz, s_water, s_waves.Density);

        // Back to the radar it is Bragg scattering of tilted facets.
        [TestCase(30, 0.1, -0.2)]
        [TestCase(60, -0.1, 0.2)]
        [TestCase(80, 0.1, 0.1)]
        public void Coupling_BackToTheRadar_IsThatOfBraggScattering(double incidence, double along, double across)
        {
            var radar = RadarAspect.At(25, 90 - incidence);
            double3 normal = math.normalize(s_up - new double3(across, 0, along));
            double power = s_scattering.RipplePower(radar.ToRadar, radar.ToRadar, normal, s_wind);
            var expected = new SeaScattering(TenGigahertz, s_water, s_waves.Density).Bragg(normal, radar.ToRadar, s_wind);
            var waves = WavesOf(radar.ToRadar, radar.Up, radar.Right);
            double Of(int received, int sent) => power * Squared(s_scattering.Coupling(waves[received], waves[sent], normal));
            Assert.That(Of(0, 0), Is.EqualTo(expected.VV).Within(1e-6).Percent);
            Assert.That(Of(1, 1), Is.EqualTo(expected.HH).Within(1e-6).Percent);
            Assert.That(Of(1, 0), Is.EqualTo(expected.HV).Within(1e-4).Percent);
        }

        // Back to the radar breaking waves are those of the sea, in the polarisation sent.
        [TestCase(5)]
        [TestCase(60)]
        public void Breaking_BackToTheRadar_IsThatOfASea(double grazing)
        {
            var radar = RadarAspect.At(25, grazing);
            var waves = WavesOf(radar);
            double power = BistaticScattering.BreakingPower(radar.ToRadar, radar.ToRadar);
            double Of(int p, int q) => power * Squared(BistaticScattering.MirroredWhole(waves[p], waves[q]));
            Assert.That(Of(0, 0), Is.EqualTo(SeaScattering.Breaking(radar.ToRadar.y)).Within(1e-9).Percent);
            Assert.That(Of(1, 1), Is.EqualTo(Of(0, 0)).Within(1e-9).Percent);
            Assert.That(Of(1, 0), Is.LessThan(1e-20));
        }

        // Small perturbations of first order from one direction to another, as published in angles (Barrick and Peake
        // 1968; Ulaby, Moore and Fung 1982): 4 cos cos alpha. The azimuth is that from the forward direction.
        [TestCase(60, 40, 50)]
        [TestCase(75, 80, 120)]
        [TestCase(20, 70, -35)]
        public void Coupling_BetweenDirections_IsThePublishedOne(double incidence, double scattered, double azimuth)
        {
            double i = math.radians(incidence), s = math.radians(scattered), phi = math.radians(azimuth);
            double3 from = new double3(0, Math.Cos(i), -Math.Sin(i)),
                to = new double3(Math.Sin(s) * Math.Sin(phi), Math.Cos(s), Math.Sin(s) * Math.Cos(phi));
            var sent = WavesOf(from, VerticalOf(from), math.cross(s_up, from) / Math.Sin(i));
            var received = WavesOf(to, VerticalOf(to), math.cross(s_up, to) / Math.Sin(s));
            void AssertIs(int p, int q, Complex alpha) => Assert.That(
                s_scattering.Coupling(received[p], sent[q], s_up).Magnitude / (4 * Math.Cos(i) * Math.Cos(s)),
                Is.EqualTo(alpha.Magnitude).Within(1e-6).Percent);
            Complex qi = Root(i), qs = Root(s), e = s_water;
            AssertIs(1, 1, (e - 1) * Math.Cos(phi) / ((Math.Cos(i) + qi) * (Math.Cos(s) + qs)));
            AssertIs(0, 0, (e - 1) * (e * Math.Sin(i) * Math.Sin(s) - Math.Cos(phi) * qi * qs)
                / ((e * Math.Cos(i) + qi) * (e * Math.Cos(s) + qs)));
            AssertIs(1, 0, (e - 1) * Math.Sin(phi) * qi / ((e * Math.Cos(i) + qi) * (Math.Cos(s) + qs)));
            AssertIs(0, 1, (e - 1) * Math.Sin(phi) * qs / ((Math.Cos(i) + qi) * (e * Math.Cos(s) + qs)));
        }

        // Back to the radar they are the mirror points of a facet.
        [Test]
        public void Mirrored_BackToTheRadar_IsThatOfMirrorPoints()
        {
            var scattering = new SeaScattering(TenGigahertz, s_water, s_waves.Density);
            double2 variance = new double2(0.02, 0.013);
            foreach (double grazing in new[] { 60, 80, 89.0 })
            {
                var radar = RadarAspect.At(25, grazing);
                double3 normal = math.normalize(new double3(0.05, 1, -0.08));
                var waves = WavesOf(radar.ToRadar, radar.Up, radar.Right);
                double density = BistaticScattering.MirrorDensity(radar.ToRadar, radar.ToRadar, normal, s_wind, variance,
                    0.002), expected = scattering.Specular(normal, radar.ToRadar, s_wind, variance, 0.002);
                foreach (var wave in waves)
                    Assert.That(density * Squared(s_scattering.Mirrored(wave, wave)), Is.EqualTo(expected).Within(1e-6).Percent);
            }
        }

        // The field that a vertical conducting plate mirrors to the sea is that of the radar's image: the ripples scatter it
        // to the radar, as much the other way round, and back to the image. Turned by 40 degrees the plate lights the sea
        // aside; by 5 it lights mirror points towards the radar.
        [Category("Slow")]
        [TestCase(40, 30, double.PositiveInfinity)]
        [TestCase(40, 30, 400)]
        [TestCase(65, 15, double.PositiveInfinity)]
        [TestCase(5, 20, double.PositiveInfinity)]
        public void Sum_APlateOverASea_IsThatOfTheRadarsImage(double turn, double grazing, double range)
        {
            var (pose, clutter, plate) = PlateOverASea(turn, 0, grazing, 0);
            (pose.Range, pose.PhaseCentre) = (range, new double3(0, 0, 3));
            var byPlate = Mirrored(WavesOf(pose.Radar), plate);
            AssertNear(Sum(pose), LitBy(pose.Radar.ToRadar, byPlate, plate) * Between(clutter, pose.Radar, byPlate));
        }

        // |S|^2 of a moment is exponential about the cross section: over independent moments its mean is that, within five
        // standard deviations. Signal to clutter compares the field with the clutter's cross section.
        [Test]
        public void Fields_OverManyMoments_HaveTheMeanCrossSection()
        {
            const int moments = 1000;
            var (pose, _, _) = PlateOverASea(40, 0, 30, 0);
            pose.Times = Enumerable.Range(0, moments).Select(moment => 100.0 * moment).ToArray();
            var echoes = Echoes(pose);
            Assert.That(echoes.Length, Is.EqualTo(moments));
            foreach (var polarisation in Polarisation.All)
                Assert.That(echoes.Average(echo => Squared(polarisation.Of(echo.S))) / echoes[0].SigmaOf(polarisation),
                    Is.EqualTo(1).Within(5 / Math.Sqrt(moments)));
        }

        // A plate that leans towards the radar also lights the sea with what the water has mirrored to it, of both images.
        [TestCase(0, 20, 15)]
        [TestCase(30, 20, 15)]
        public void Sum_APlateThatLeansOverASea_IsAlsoThatOfTheImageInTheWater(double turn, double lean, double grazing)
        {
            var (pose, clutter, plate) = PlateOverASea(turn, lean, grazing, 0);
            var (_, alone, all) = OfBothImages(pose, clutter, plate);
            Assert.That(Sigma0.Decibels(all.HH / alone.HH), Is.GreaterThan(0.15));
            AssertNear(Sum(pose), all);
        }

        // One that leans so far that it lights the sea below it from straight above: mirror points throw the light back
        // to the plate.
        [Test]
        public void Sum_APlateThatLightsTheSeaFromAbove_IsThatOfTheImagesWithTheirMirrorPoints()
        {
            var (pose, clutter, plate) = PlateOverASea(0, 37, 15, 0);
            var (byPlate, _, all) = OfBothImages(pose, clutter, plate);
            Assert.That(byPlate[0].Towards.y, Is.GreaterThan(0.999));
            AssertNear(Sum(pose), all);
        }

        // The waves of the radar that the plate mirrors to the sea, and the echo of these alone and with those of the
        // radar's image in the water.
        static (SurfaceWave[] ByPlate, Sigma0 Alone, Sigma0 All) OfBothImages(CrossSectionPose pose, SeaClutter clutter,
            double3 plate)
        {
            var water = clutter.Surface.Reflection(pose.Radar.ToRadar.y, TenGigahertz);
            double3 toImage = Mirrored(pose.Radar.ToRadar, s_up), imageV = Mirrored(pose.Radar.Up, s_up);
            var fromWater = new[]
            {
                new SurfaceWave(toImage, imageV, pose.Radar.Right, -water.P, 0),
                new SurfaceWave(toImage, imageV, pose.Radar.Right, 0, water.S)
            };
            SurfaceWave[] byPlate = Mirrored(WavesOf(pose.Radar), plate), byBoth = Mirrored(fromWater, plate);
            var alone = LitBy(pose.Radar.ToRadar, byPlate, plate) * Between(clutter, pose.Radar, byPlate);
            return (byPlate, alone, alone + LitBy(toImage, byBoth, plate) * Between(clutter, pose.Radar, byBoth));
        }

        // A sea that breaks everywhere: mirror points of a slope variance of 0.19 and a pedestal, without loss.
        [TestCase(40, 30)]
        [TestCase(5, 20)]
        public void Sum_APlateOverBreakingWaves_IsThatOfTheRadarsImage(double turn, double grazing)
        {
            var (pose, _, plate) = PlateOverASea(turn, 0, grazing, 1e-3);
            SurfaceWave[] direct = WavesOf(pose.Radar), byPlate = Mirrored(direct, plate);
            double3 image = byPlate[0].Towards, middle = math.normalize(pose.Radar.ToRadar + image);
            double Power(double cosine) => (Math.Exp((1 - 1 / (cosine * cosine)) / 0.19) / Math.Pow(cosine, 4) + 0.005) / 0.19;
            // A conductor along the middle turns both polarisations.
            Complex Field(SurfaceWave a, SurfaceWave b) => a.Along(new double3(1, 0, 0)) * Turned(b, new double3(1, 0, 0))
                + a.Along(s_up) * Turned(b, s_up) + a.Along(s_wind) * Turned(b, s_wind);
            Complex Turned(SurfaceWave wave, double3 axis) => wave.Along(2 * math.dot(axis, middle) * middle - axis);
            double Of(int p, int q) => Power(middle.y) * Squared(Field(direct[p], byPlate[q]) + Field(byPlate[p], direct[q]))
                + (p == q ? Power(image.y) : 0);
            AssertNear(Sum(pose), LitBy(pose.Radar.ToRadar, byPlate, plate) * new Sigma0(Of(1, 1), Of(0, 0), Of(1, 0)));
        }

        // 0.8 m wide and 0.6 m high, turned about the vertical and leaning to the radar, over level facets of a sea; and
        // where the plate looks.
        static (CrossSectionPose, SeaClutter, double3) PlateOverASea(double turn, double lean, double grazing,
            double whitecaps)
        {
            var sea = new TestSea(10, 16, 16, 30, 0, height: 0.001);
            var settings = SeaClutterSettings.On;
            (settings.WhitecapCoefficient, settings.Gustiness) = (whitecaps, 0);
            var clutter = new SeaClutter(sea.Surface, 0, sea.Clutter.Wind, settings);
            var pose = sea.Pose(0, grazing, clutter);
            var (sine, cosine) = (Math.Sin(math.radians(turn)), Math.Cos(math.radians(turn)));
            double3 right = new double3(cosine, 0, -sine), ahead = new double3(-sine, 0, -cosine),
                up = Math.Cos(math.radians(lean)) * s_up + Math.Sin(math.radians(lean)) * ahead;
            var water = sea.Instances[0];
            water.Ranges = new[] { new MeshRange(0, 0, 1) };
            pose.Scene = new RadarScene(water, Plate(new double3(0, 0.1, 3), Width * right, Height * up))
            {
                Seas = pose.Scene.Seas, Surfaces = new[] { SurfaceMaterial.PerfectConductor, clutter.Surface }
            };
            return (pose, clutter, math.cross(up, right));
        }

        static double3 Mirrored(double3 v, double3 normal) => v - 2 * math.dot(v, normal) * normal;

        // Waves that a conducting plate mirrors.
        static SurfaceWave[] Mirrored(SurfaceWave[] waves, double3 plate)
        {
            // The same vectors for all waves: across their direction.
            double3 towards = waves[0].Towards, v = VerticalOf(towards), h = math.cross(v, towards);
            return waves.Select(wave => new SurfaceWave(Mirrored(towards, plate), Mirrored(v, plate), Mirrored(h, plate),
                wave.Along(v), wave.Along(h))).ToArray();
        }

        // Area of the level sea that the plate lights.
        static double LitBy(double3 from, SurfaceWave[] byPlate, double3 plate) =>
            Width * Height * math.dot(from, plate) / byPlate[0].Towards.y;

        static void AssertNear(in ClutterEcho echo, in Sigma0 expected)
        {
            void AssertIs(double sigma, double other, double decibels)
            {
                double difference = Sigma0.Decibels(sigma / other);
                TestContext.WriteLine($"{Sigma0.Decibels(sigma):0.00} dBsm, off by {difference:0.000} dB");
                Assert.That(difference, Is.EqualTo(0).Within(decibels));
            }
            AssertIs(echo.SigmaVV, expected.VV, 0.05);
            AssertIs(echo.SigmaHH, expected.HH, 0.05);
            AssertIs(echo.SigmaHV, expected.HV, 0.05);
        }

        static ClutterEcho Sum(CrossSectionPose pose) => Echoes(pose).Single();

        static ClutterEcho[] Echoes(CrossSectionPose pose)
        {
            using var scene = new DeviceScene(BvhLayout.Binary, "test", long.MaxValue);
            using var surfaces = new SurfaceBuffers();
            using var kernel = new ShipSeaKernel(TestKernels.Tubes);
            scene.Set(pose.Scene, new TraceStatistics(), (mesh, layout) => MeshBvh.Build(mesh, layout, default));
            surfaces.Set(pose.Scene, scene.Centre, pose.CreaseDegrees, pose.CoefficientFrequency);
            return kernel.Sum(scene, surfaces, pose);
        }

        // Per area of a level sea, mean over the slopes of its ripples.
        static Sigma0 Between(SeaClutter clutter, RadarAspect radar, SurfaceWave[] byPlate)
        {
            const int steps = 30;
            var table = clutter.TableAt(TenGigahertz);
            var scattering = new BistaticScattering(TenGigahertz, s_water, clutter.ShortWaves.Spectrum.Density);
            double3 image = byPlate[0].Towards, across = new double3(-clutter.Wind.z, 0, clutter.Wind.x);
            var direct = WavesOf(radar);
            double weights = 0;
            var sum = default(Sigma0);
            for (int i = -steps; i <= steps; i++)
                for (int j = -steps; j <= steps; j++)
                {
                    double u = 4.5 * i / steps, v = 4.5 * j / steps, weight = Math.Exp(-(u * u + v * v) / 2);
                    double3 normal = math.normalize(s_up - u * Math.Sqrt(table.TiltVariance.x) * clutter.Wind
                        - v * Math.Sqrt(table.TiltVariance.y) * across);
                    double between = scattering.RipplePower(radar.ToRadar, image, normal, clutter.Wind),
                        back = scattering.RipplePower(image, image, normal, clutter.Wind);
                    double Of(int p, int q) => between * Squared(scattering.Coupling(direct[p], byPlate[q], normal)
                        + scattering.Coupling(byPlate[p], direct[q], normal))
                        + back * Squared(scattering.Coupling(byPlate[p], byPlate[q], normal));
                    sum += weight * new Sigma0(Of(1, 1), Of(0, 0), Of(1, 0));
                    weights += weight;
                }
            double loss = RoughnessLoss.MillerBrown(2 * Math.PI / Signal.Wavelength(TenGigahertz) * clutter.ShortWaves.Height
                * image.y);
            double mirrors = (1 - loss * loss) * BistaticScattering.MirrorDensity(radar.ToRadar, image, s_up, clutter.Wind,
                table.Unresolved, table.Covariance);
            double ByMirrors(int p, int q) => mirrors
                * Squared(scattering.Mirrored(direct[p], byPlate[q]) + scattering.Mirrored(direct[q], byPlate[p]));
            // Back to the image in the polarisation sent, with the power that the image's waves carry.
            double specular = (1 - loss * loss) * new SeaScattering(TenGigahertz, s_water, s_waves.Density)
                .Specular(s_up, image, clutter.Wind, table.Unresolved, table.Covariance);
            double BackFrom(int p) => specular * Math.Pow(PowerOf(byPlate[p]), 2);
            return 1 / weights * sum + new Sigma0(ByMirrors(1, 1) + BackFrom(1), ByMirrors(0, 0) + BackFrom(0),
                ByMirrors(1, 0));
        }

        static SurfaceWave[] WavesOf(RadarAspect radar) => WavesOf(radar.ToRadar, radar.Up, radar.Right);

        static SurfaceWave[] WavesOf(double3 towards, double3 v, double3 h) =>
            new[] { new SurfaceWave(towards, v, h, 1, 0), new SurfaceWave(towards, v, h, 0, 1) };

        static double PowerOf(SurfaceWave wave)
        {
            double3 v = VerticalOf(wave.Towards);
            return Squared(wave.Along(v)) + Squared(wave.Along(math.cross(v, wave.Towards)));
        }

        static double3 VerticalOf(double3 towards) => math.normalize(s_up - towards.y * towards);

        static Complex Root(double incidence) => Complex.Sqrt(s_water - Math.Sin(incidence) * Math.Sin(incidence));

        static double Squared(Complex value) => value.Magnitude * value.Magnitude;

        static MeshInstance Plate(double3 foot, double3 across, double3 up) => new MeshInstance
        {
            Mesh = new TriangleMesh(new[] { -across / 2, across / 2, across / 2 + up, -across / 2 + up }
                .Select(corner => (float3)(foot + corner)).ToArray(), new[] { 0, 2, 1, 0, 3, 2 }),
            ToWorld = Affine.Identity
        };
    }
}
