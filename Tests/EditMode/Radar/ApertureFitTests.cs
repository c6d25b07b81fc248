using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>The smallest picture of parallel rays that covers the traced objects.</summary>
    public sealed class ApertureFitTests
    {
        static readonly double3 X = new double3(1, 0, 0), Y = new double3(0, 1, 0), Z = new double3(0, 0, 1);

        [TestCase(0.03125, 64, 32)]
        [TestCase(0.3, 7, 4)]
        [TestCase(2, 1, 1)]
        [TestCase(50, 1, 1)]
        public void Cover_PlateAcrossTheView_TakesWholeSpacingsAboutItsMiddle(double spacing, int across, int down)
        {
            // 2 m wide, 1 m high, centred at (5, 7).
            var pose = Pose(Plate(4, 6, 6.5f, 7.5f), new double3(-3, 2, 100));
            ApertureFit.Cover(ref pose, spacing, "Radar");
            Assert.That((pose.Settings.RaysAcross, pose.Settings.RaysDown), Is.EqualTo((across, down)));
            Assert.That(pose.View.ApertureHeight, Is.EqualTo(down * spacing));
            Assert.That(distance(pose.View.Position, new double3(5, 7, 100)),
                Is.LessThan(1e-12), "moved sideways only");
            Assert.That(pose.Settings.FrequencyHz, Is.EqualTo(10e9), "the rest stays");
        }

        [Test]
        public void Cover_AnySceneFromAnySide_IsCoveredWithNoRowOrColumnToSpare([Range(1, 20)] int seed)
        {
            var random = new System.Random(seed);
            double Number(double limit) => (2 * random.NextDouble() - 1) * limit;
            double3 Point(double limit) => new double3(Number(limit), Number(limit), Number(limit));
            double size = pow(10, Number(4)), far = 1e6 * random.NextDouble();
            var scene = new RadarScene(Enumerable.Range(0, 3).Select(_ => new MeshInstance
            {
                Mesh = Triangles(Enumerable.Range(0, 30).Select(__ => (float3)Point(1)).ToArray()),
                // Stretched, sheared and mirrored at random.
                ToWorld =
                    new Affine { X = Point(size), Y = Point(size), Z = Point(size), Origin = Point(far) + Point(size) },
            }).ToArray());
            var before = Pose(scene, Point(far));
            (before.View.Forward, before.View.Up) = (normalize(Point(1)), Y);
            before.View.Right = normalize(cross(before.View.Up, before.View.Forward));
            before.View.Up = cross(before.View.Forward, before.View.Right);

            var pose = before;
            var seen = SceneBuilder.Corners(scene)
                .Select(corner => new double2(dot(corner - before.View.Position, before.View.Right),
                    dot(corner - before.View.Position, before.View.Up))).ToArray();
            double2 extent = seen.Aggregate(max) - seen.Aggregate(min);
            double spacing = cmax(extent) / (10 + 500 * random.NextDouble());
            ApertureFit.Cover(ref pose, spacing, "Radar");

            double rounding = 1e-9 + 2e-6 * spacing; // of coordinates up to 1,000 km
            var rays = new double2(pose.Settings.RaysAcross, pose.Settings.RaysDown);
            double2 half = pose.View.HalfSize(pose.Settings);
            Assert.That(distance(half, rays * spacing / 2), Is.LessThan(rounding));
            double3 moved = pose.View.Position - before.View.Position;
            var centre = new double2(dot(moved, before.View.Right), dot(moved, before.View.Up));
            Assert.That(abs(dot(moved, before.View.Forward)), Is.LessThan(rounding));
            Assert.That(seen.Max(point => cmax(abs(point - centre) - half)), Is.LessThan(rounding), "covered");
            Assert.That(cmax((rays - 1) * spacing - extent), Is.LessThan(rounding), "none to spare");
        }

        [Test]
        public void Cover_VerticesWithoutATriangle_AreNothingToSee()
        {
            var plate = Plate(0, 1, 0, 1);
            var scene = new RadarScene(
                new TriangleMesh(plate.Vertices.Append(new float3(1000, 1000, 0)).ToArray(), plate.Indices));
            var pose = Pose(scene, 0);
            ApertureFit.Cover(ref pose, 0.1, "Radar");
            Assert.That((pose.Settings.RaysAcross, pose.Settings.RaysDown), Is.EqualTo((10, 10)));
        }

        [Test]
        public void Cover_NoTriangles_IsRefused()
        {
            foreach (var scene in new[] { new RadarScene(), new RadarScene(Triangles()) })
            {
                var pose = Pose(scene, 0);
                Assert.That(Assert.Throws<GlintException>(() => ApertureFit.Cover(ref pose, 1, "Radar 'X'")).Message,
                    Does.StartWith("Radar 'X': there is nothing to fit its aperture to"));
            }
        }

        [TestCase(0)]
        [TestCase(-1)]
        [TestCase(double.NaN)]
        [TestCase(double.PositiveInfinity)]
        public void Cover_SpacingThatIsNone_IsRefused(double spacing)
        {
            var pose = Pose(Plate(0, 1, 0, 1), 0);
            Assert.That(Assert.Throws<GlintException>(() => ApertureFit.Cover(ref pose, spacing, "Radar 'X'")).Message,
                Does.StartWith("Radar 'X': ray spacing ").And.Contain("positive and finite"));
        }

        [TestCase(0.000001)] // 1,000,000 across
        [TestCase(0.00001)] // 10^10 in all
        public void Cover_MoreRaysThanAPictureHas_IsRefusedWithTheirNumber(double spacing)
        {
            var pose = Pose(Plate(0, 1, 0, 1), 0);
            string message =
                Assert.Throws<GlintException>(() => ApertureFit.Cover(ref pose, spacing, "Radar 'X'")).Message;
            Assert.That(message, Does.StartWith("Radar 'X': rays ")
                .And.Contain(spacing == 1e-6 ? "1000000 x 1000000" : "100000 x 100000").And.Contain("larger spacing"));
        }

        [Test]
        public void Divide_Rectangle_IsEnlargedToWholeSpacings()
        {
            var pose = Pose(new RadarScene(), 0);
            ApertureFit.Divide(new double2(3, 1), 0.4, ref pose, "Radar");
            Assert.That((pose.Settings.RaysAcross, pose.Settings.RaysDown), Is.EqualTo((8, 3)));
            Assert.That(pose.View.ApertureHeight, Is.EqualTo(1.2).Within(1e-15));
            Assert.That(pose.View.Position, Is.EqualTo(new double3(0)));
        }

        [Test]
        public void MatchReceiver_OffTheAxis_IsBroughtOntoItAtItsDistance()
        {
            var pose = Pose(Plate(4, 6, 6.5f, 7.5f), new double3(-3, 2, 100));
            pose.View.ReceiverCentre = new double3(-3, 2.5, 99.75);
            ApertureFit.Cover(ref pose, 0.3, "Radar");
            ApertureFit.MatchReceiver(ref pose);
            Assert.That(distance(pose.View.ReceiverCentre, new double3(5, 7, 99.75)), Is.LessThan(1e-12));
            Assert.That(distance(pose.View.ReceiverSize, new double2(2.1, 1.2)), Is.LessThan(1e-12));
        }

        static RadarPose Pose(TriangleMesh mesh, double3 position) => Pose(new RadarScene(mesh), position);

        static RadarPose Pose(RadarScene scene, double3 position) => new RadarPose
        {
            Scene = scene,
            Settings = RadarSettings.Default,
            View = new RadarView { Position = position, Right = X, Up = Y, Forward = Z, ApertureHeight = 1 },
        };

        static TriangleMesh Plate(float left, float right, float lower, float upper) =>
            new TriangleMesh(
                new[] { new float3(left, lower, 0), new float3(left, upper, 0), new float3(right, upper, 0),
                    new float3(right, lower, 0) }, new[] { 0, 1, 2, 0, 2, 3 });

        static TriangleMesh Triangles(params float3[] corners) =>
            new TriangleMesh(corners, Enumerable.Range(0, corners.Length).ToArray());
    }
}
