using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>Points on surfaces: their number, their areas, and where they lie.</summary>
    public sealed class SurfaceSamplesTests
    {
        // Rectangles of 30 x 10 m and, twice as large by its transform, 1 x 1 m.
        static readonly RadarScene s_scene = new RadarScene(
            Instance(Rectangle(30, 10), Affine.Identity),
            Instance(Rectangle(1, 1), new Affine
            {
                X = new double3(2, 0, 0), Y = new double3(0, 2, 0), Z = new double3(0, 0, 2),
                Origin = new double3(100, 0, 0)
            }));

        [Test]
        public void Points_OfAnObject_HaveItsArea()
        {
            var samples = SurfaceSamples.Of(s_scene, 0.5, "test");
            double AreaOf(uint instance) => samples.Points.Where(point => point.Instance == instance).Sum(point => point.Area);
            Assert.That(samples.Spacing, Is.EqualTo(0.5));
            Assert.That(samples.Points.Count(point => point.Instance == 0), Is.EqualTo(1200));
            Assert.That(AreaOf(0), Is.EqualTo(300).Within(1e-3));
            Assert.That(samples.Points.Count(point => point.Instance == 1), Is.EqualTo(SurfaceSamples.MinOfAnObject));
            Assert.That(AreaOf(1), Is.EqualTo(4).Within(1e-5));
        }

        // 1,200 points in 30 x 10 squares: 4 each. Points at random would leave 2 % of the squares empty, and give some 11.
        [Test]
        public void Points_AreSpreadEvenly()
        {
            var samples = SurfaceSamples.Of(s_scene, 0.5, "test");
            var counts = samples.Points.Where(point => point.Instance == 0)
                .GroupBy(point => (int2)math.floor(point.Position.xz)).Select(square => square.Count()).ToArray();
            Assert.That(counts, Has.Length.EqualTo(300));
            Assert.That(counts.Max(), Is.LessThanOrEqualTo(8));
            Assert.That(samples.Points.Where(point => point.Instance == 0).GroupBy(point => point.Triangle)
                .Select(triangle => triangle.Count()), Is.EqualTo(new[] { 600, 600 }));
        }

        [Test]
        public void Spacing_GrowsUntilThePointsAreFewEnough()
        {
            var samples = SurfaceSamples.Of(s_scene, 0.001, "test");
            Assert.That(samples.Points.Length, Is.InRange(SurfaceSamples.MaxCount - 200, SurfaceSamples.MaxCount));
            Assert.That(samples.Spacing, Is.EqualTo(math.sqrt(304.0 / SurfaceSamples.MaxCount)).Within(1e-5));
        }

        [Test]
        public void Scenes_WithoutArea_HaveNoPoints()
        {
            Assert.That(SurfaceSamples.Of(new RadarScene(), 1, "test").Points, Is.Empty);
            Assert.That(SurfaceSamples.Of(new RadarScene(Rectangle(0, 1)), 1, "test").Points, Is.Empty);
        }

        [Test]
        public void TooManyObjects_AreRefused()
        {
            var mesh = Rectangle(1, 1);
            var scene = new RadarScene(Enumerable.Repeat(Instance(mesh, Affine.Identity), 8193).ToArray());
            Assert.That(() => SurfaceSamples.Of(scene, 1, "RadarScreen of 'Mast'"), Throws.InstanceOf<GlintException>()
                .With.Message.EqualTo("RadarScreen of 'Mast': traces 8193 objects, and a radar screen traces 8192 at most: "
                    + "leave out layers of small objects"));
        }

        static MeshInstance Instance(TriangleMesh mesh, Affine toWorld) =>
            new MeshInstance { Mesh = mesh, ToWorld = toWorld };

        static TriangleMesh Rectangle(float x, float z) => new TriangleMesh(
            new[] { new float3(0, 0, 0), new float3(x, 0, 0), new float3(x, 0, z), new float3(0, 0, z) },
            new[] { 0, 1, 2, 0, 2, 3 });
    }
}
