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
    }
}
