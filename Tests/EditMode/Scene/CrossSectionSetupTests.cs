using System.Numerics;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    public sealed class CrossSectionSetupTests
    {
        static readonly CrossSectionPlan s_plan =
            new CrossSectionPlan(new double[] { 0 }, new double[] { 0 }, new[] { 10e9 });

        [Test]
        public void Scene_WithoutTriangles_IsRefused() =>
            Assert.That(() => new CrossSectionSetup(new RadarScene(), s_plan).Validate("Empty.unity"),
                Throws.TypeOf<GlintException>().With.Message.StartsWith("Empty.unity: has no triangles"));

        [Test]
        public void Contributions_OfTooManyTriangles_AreRefused()
        {
            var mesh = CrossSectionTargets.Sphere(1, 30);
            var scene = new RadarScene(new MeshInstance[389]);
            for (int i = 0; i < scene.Instances.Length; i++)
                scene.Instances[i] = new MeshInstance { Mesh = mesh, ToWorld = Affine.Identity };
            Assert.That(scene.TriangleCount, Is.EqualTo(389 * 10800).And.GreaterThan(1 << 22));
            var setup = new CrossSectionSetup(scene, s_plan) { HasContributions = true };
            Assert.That(() => setup.Validate("Fleet.unity"), Throws.TypeOf<GlintException>().With.Message.EqualTo(
                "Fleet.unity: has 4201200 triangles, and contributions are summed of at most 4194304: "
                    + "leave --contributions out, or compute its parts alone"));
        }

        // A plate of 0.3 x 0.2 m has a = sqrt(0.13) / 2, and 10 log10(pi a^2) - 40 = -49.91 dBsm.
        [Test]
        public void Floor_Is40DecibelsBelowTheSphereAroundTheScene()
        {
            var mesh = CrossSectionTargets.Plate(0.3, 0.2);
            var turned = new Affine
            {
                X = new double3(0.6, 0, 0.8), Y = new double3(0, 1, 0), Z = new double3(-0.8, 0, 0.6),
                Origin = new double3(100, 0, 0)
            };
            var setup = new CrossSectionSetup(new RadarScene(mesh), s_plan);
            Assert.That(setup.Radius, Is.EqualTo(math.sqrt(0.13) / 2).Within(1e-7));
            Assert.That(setup.FloorDbsm, Is.EqualTo(-49.9097).Within(1e-4));
            var moved = new CrossSectionSetup(
                new RadarScene(new MeshInstance { Mesh = mesh, ToWorld = turned }), s_plan);
            Assert.That(moved.Radius, Is.EqualTo(setup.Radius).Within(1e-7), "a plate's box turns with its diagonal");
        }

        // The extent of the water says nothing of the target.
        [Test]
        public void Floor_OfASceneWithASea_IsThatOfTheRest()
        {
            MeshInstance Instance(TriangleMesh mesh) => new MeshInstance { Mesh = mesh, ToWorld = Affine.Identity };
            MeshInstance plate = Instance(CrossSectionTargets.Plate(0.3, 0.2)), water = Instance(TestMeshes.Sea(20, 20));
            RadarScene Of(params MeshInstance[] instances) => new RadarScene(instances)
            {
                Seas = new[] { new RadarSea(null, new[] { new SeaTileInstance(0, 0) }) }
            };
            Assert.That(new CrossSectionSetup(Of(water, plate), s_plan).FloorDbsm, Is.EqualTo(-49.9097).Within(1e-4));
            Assert.That(new CrossSectionSetup(Of(water), s_plan).FloorDbsm,
                Is.EqualTo(new CrossSectionSetup(new RadarScene(water.Mesh), s_plan).FloorDbsm).Within(1e-9));
        }

        // 2 pi f / c times the size, 2^-24 of it, is what the tolerance allows: for 0.1 dB and 1 km 9.27 GHz.
        [TestCase(0.1, 9.27e9)]
        [TestCase(0.01, 0.922e9)]
        [TestCase(1, 96.1e9)]
        [TestCase(10, 96.1e9)]
        public void Frequency_IsRefusedWherePhasesInFloat32DoNotSuffice(double toleranceDb, double border)
        {
            foreach (double factor in new[] { 0.99, 1.01 })
            {
                var plan = new CrossSectionPlan(new double[] { 0 }, new double[] { 0 }, new[] { factor * border });
                var setup = new CrossSectionSetup(Apart(1000), plan) { ToleranceDb = toleranceDb };
                if (factor < 1)
                    Assert.That(() => setup.Validate("far"), Throws.Nothing);
                else
                    Assert.That(() => setup.Validate("far"), Throws.TypeOf<GlintException>().With.Message.Match(
                        "far: .* Hz is too high for its size of 1000 m and a tolerance of .* dB: phases in float32 "
                        + "are off by .* rad; up to .* Hz is possible"
                        // From 1 dB on the border is that of any tolerance.
                        + $"{(toleranceDb < 1 ? ", with a larger tolerance up to .* Hz" : "")}; or compute its parts alone"));
            }
        }

        // The plate seen from its normal has S = -j k A / sqrt(pi) exp(2jkx); the other one is seen along its side.
        [Test]
        public void Phases_UpToTheBorder_AreWithinTheTolerance()
        {
            double Largest(double factor)
            {
                double largest = 0;
                using (var tracer = new CrossSectionTracer(TestKernels.Tubes))
                    for (int i = 0; i < 12; i++)
                    {
                        double size = 900 + 17.123 * i;
                        var scene = Apart(size);
                        var setup = new CrossSectionSetup(scene, s_plan);
                        double frequency = factor * setup.MaxFrequency(0.1), k = 2 * math.PI_DBL * frequency / 299792458;
                        var radar = new RadarAspect(new double3(1, 0, 0), new double3(0, 1, 0), new double3(0, 0, 1));
                        var s = tracer.Trace(new CrossSectionPose
                        {
                            Scene = scene, Radar = radar, Receivers = new[] { radar }, Frequencies = new[] { frequency },
                            HasEdges = false, ToleranceDb = 0.01
                        }).S[0, 0].VV;
                        double place = (float)(size / 2);
                        var expected = new Complex(0, -k * 0.06 / math.sqrt(math.PI_DBL))
                            * Complex.FromPolarCoordinates(1, 2 * k * place);
                        largest = math.max(largest, (s - expected).Magnitude / expected.Magnitude);
                    }
                return largest;
            }
            double allowed = CrossSectionAccuracy.AllowedBy(0.1);
            Assert.That(Largest(1), Is.LessThan(allowed));
            Assert.That(Largest(8), Is.GreaterThan(allowed), "the border is no more than 8 times too cautious");
        }

        // Plates of 0.3 x 0.2 m at both ends of a scene: the front one across the x axis, the other one along it.
        static RadarScene Apart(double size)
        {
            MeshInstance At(double x, double3 first, double3 third) => new MeshInstance
            {
                Mesh = CrossSectionTargets.Plate(0.3, 0.2),
                ToWorld = new Affine
                { X = first, Y = new double3(0, 1, 0), Z = third, Origin = new double3((float)x, 0, 0) }
            };
            double3 x = new double3(1, 0, 0), z = new double3(0, 0, 1);
            return new RadarScene(At(size / 2, x, z), At(-size / 2 + 0.15, z, -x));
        }
    }
}
