using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    public sealed class ShipModelTests
    {
        const double Step = 1.0 / 65536;

        static readonly ShipSettings Default = ShipSettings.Default;

        // The example of the command's help.
        static readonly ShipSettings Large = LargeSettings();

        readonly TriangleMesh _ship = ShipModel.Build(Default);

        // Its flat faces are unchanged, and tracing takes half the time.
        readonly TriangleMesh _coarse = ShipModel.Build(WithTriangles(15000));

        [Test]
        public void Build_Default_IsClosed() => ShipMesh.AssertClosed(_ship);

        // The finest mesh of the sharpest bow, with the smallest distances between points.
        [Test]
        public void Build_FinestAndMostFlared_IsClosed()
        {
            var settings = WithTriangles(600000);
            settings.Flare = 0.8;
            ShipMesh.AssertClosed(ShipModel.Build(settings));
        }

        [TestCase(15000, 0.02)]
        [TestCase(44000, 0.02)]
        [TestCase(600000, 0.02)]
        public void Build_HasAsManyTrianglesAsAskedFor(int triangles, double within)
        {
            Assert.That(ShipModel.Build(WithTriangles(triangles)).TriangleCount,
                Is.EqualTo(triangles).Within(within * triangles));
        }

        // In float32, triangles below 5e-17 m2 have no normal, and slivers lose digits.
        [Test]
        public void Build_Default_HasNoTriangleWithoutAreaAndNoNeedle() => AssertNoNeedle(_ship, 1e-3);

        static void AssertNoNeedle(TriangleMesh ship, double minWidth)
        {
            for (int t = 0; t < ship.TriangleCount; t++)
            {
                ship.GetTriangle(t, out var a, out var b, out var c);
                double area = length(cross((double3)b - a, (double3)c - a)) / 2;
                double longest = max(distance(a, b), max(distance(b, c), distance(c, a)));
                if (area < 1e-6 || 2 * area / (longest * longest) < minWidth)
                    Assert.Fail($"triangle {t} at {a}: {area} m2, {longest} m long");
            }
        }

        [Test]
        public void Build_Default_MeasuresWhatItsSettingsSay_BowTowardsMinusZ()
        {
            double3 boxMin = _ship.Vertices[0], boxMax = boxMin;
            foreach (var vertex in _ship.Vertices)
                (boxMin, boxMax) = (min(boxMin, vertex), max(boxMax, vertex));

            Assert.That(Default.Length, Is.InRange(60, 75));
            Assert.That(-boxMin.z, Is.EqualTo(Default.Length / 2).Within(Step));
            Assert.That(boxMax.z, Is.EqualTo(Default.Length / 2).Within(Step));
            // The widest frame is between two stations.
            Assert.That(boxMax.x - boxMin.x, Is.EqualTo(Default.Beam).Within(0.001));
            Assert.That(-boxMin.y, Is.EqualTo(Default.Draught).Within(Step));
            Assert.That(boxMax.y, Is.EqualTo(Default.Freeboard + Default.Forecastle + 3 * Default.StoreyHeight
                + Default.MastHeight).Within(2 * Step));

            var bow = _ship.Vertices.Where(vertex => vertex.z == boxMin.z).ToArray();
            Assert.That(bow.Select(vertex => vertex.x), Is.All.Zero);
            Assert.That(bow.Max(vertex => vertex.y),
                Is.EqualTo(Default.Freeboard + Default.Forecastle + Default.Sheer).Within(2 * Step));
            var stern = _ship.Vertices.Where(vertex => vertex.z == boxMax.z).ToArray();
            Assert.That(stern.Max(vertex => vertex.x), Is.EqualTo(Default.Transom * Default.Beam / 2).Within(Step));
            Assert.That(stern.Max(vertex => vertex.y), Is.EqualTo(Default.Freeboard).Within(Step));
        }

        [Test]
        public void Build_Default_IsTheSameOnBothSides()
        {
            var positions = _ship.Vertices.ToHashSet();
            Assert.That(
                positions.Count(vertex => !positions.Contains(new float3(-vertex.x + 0f, vertex.y, vertex.z))),
                Is.Zero);
        }

        // The hull has most of the triangles.
        [Test]
        public void Build_OfALargeShip_FollowsItsHullAtTenGigahertz()
        {
            var hull = new Hull(Large);
            var vertices = new List<float3>();
            var indices = new List<int>();
            hull.Build(400000).AddTo(vertices, indices);
            var mesh = new TriangleMesh(vertices.ToArray(), indices.ToArray());
            var quality = MeshQuality.Find(new RadarScene(mesh), new[] { SurfacePatches.Find(mesh) });
            Assert.That(quality.Share(Signal.Wavelength(10e9)), Is.LessThan(0.02));
            Assert.That(ShipModel.Build(Large).TriangleCount, Is.GreaterThan(mesh.TriangleCount));
        }

        [Test]
        public void Build_OfALargeShip_IsClosedWithoutNeedles()
        {
            var ship = ShipModel.Build(Large);
            ShipMesh.AssertClosed(ship);
            // Rows of the flat transom are thinner near the keel.
            AssertNoNeedle(ship, 3e-4);
            Assert.That(ship.Vertices.Max(vertex => vertex.z) - ship.Vertices.Min(vertex => vertex.z),
                Is.EqualTo(Large.Length).Within(2 * Step));
            Assert.That(ShipMesh.VolumeUnderWater(ship) / (Large.Length * Large.Beam * Large.Draught),
                Is.InRange(0.38, 0.55));
        }

        // Block coefficients of patrol vessels are about 0.4 to 0.55.
        [Test]
        public void Build_Default_DisplacesAsAVesselOfItsSize() =>
            Assert.That(ShipMesh.VolumeUnderWater(_ship) / (Default.Length * Default.Beam * Default.Draught),
                Is.InRange(0.38, 0.55));

        [Test]
        public void Build_OfABoxUnderWater_MeasuresItsVolume()
        {
            var box = new TriangleMesh(
                Solid.BoxVertices(2, 5, 3).Select(vertex => vertex - new float3(0, 4, 0)).ToArray(), Solid.BoxIndices);
            Assert.That(ShipMesh.VolumeUnderWater(box), Is.EqualTo(2 * 4 * 3).Within(1e-9));
        }

        [Test]
        public void Build_Twice_IsTheSameBits_OnAGridOfPowersOfTwo()
        {
            var again = ShipModel.Build(Default);
            Assert.That(again.Vertices.SequenceEqual(_ship.Vertices));
            Assert.That(again.Indices.SequenceEqual(_ship.Indices));
            Assert.That(_ship.Vertices.All(vertex => all(fmod((double3)vertex, Step) == 0)));
            Assert.That(_ship.Vertices.All(vertex => all(asuint(vertex) != 0x80000000u)),
                "no -0: equal places have equal bits");
        }

        // Published hits of 1920 x 1080 rays, against 240 x 135 rays here, whose edges are accurate to 2 %.
        [TestCase(0, 125508)]
        [TestCase(90, 331864)]
        [TestCase(180, 161522)]
        public void Build_Default_FillsTheRadarsPictureAsThePublishedShip(double angle, double published)
        {
            var settings = TestRadar.Settings(240, 135, bounces: 1);
            var referenceTracer = new ReferenceTracer(
                new RadarPose(new RadarScene(_coarse), settings, TestRadar.LookAt(Radar(angle), 0)));
            Assert.That(64.0 * referenceTracer.Sum(referenceTracer.TraceAll()).RaysHit,
                Is.EqualTo(published).Within(0.15 * published));
        }

        // From ahead and from astern, deck and house are a dihedral, which reflects the rays back to the camera.
        [TestCase(0)]
        [TestCase(180)]
        public void Build_Default_SquareToTheRadar_DeckAndHouseReturnRays(double angle)
        {
            double deck = angle == 0 ? Default.Freeboard + Default.Forecastle : Default.Freeboard,
                house = angle == 0 ? -Default.HouseFront : Default.HouseAft;
            double3 corner = double3(0, deck, house * Default.Length);
            var settings = TestRadar.Settings();
            var view = TestRadar.LookAt(Radar(angle), corner, fov: 8);
            var rays = new ReferenceTracer(new RadarPose(new RadarScene(_coarse), settings, view)).TraceAll();

            double3 image = double3(view.Position.x, 2 * deck - view.Position.y, 2 * corner.z - view.Position.z);
            int returned = 0;
            for (int pixel = 0; pixel < rays.Length; pixel++)
            {
                if (!rays[pixel].Received || rays[pixel].Bounces != 2)
                    continue;
                double3 back = TestRadar.Direction(settings, view, pixel) * double3(1, -1, -1);
                double length = dot(view.ReceiverCentre - image, view.Forward) / dot(back, view.Forward);
                if (abs(rays[pixel].PathLength - length) < 1e-4) // heights are rounded to 2^-16 m
                    returned++;
            }
            // Half the receiver's width and height, since the corner is half as far as its image: a square of 1.5 m.
            // The bow covers a third of it.
            double across = 1.5 / (2 * tan(radians(4.0)) * distance(view.Position, corner)) * settings.RaysDown;
            Assert.That(returned, Is.GreaterThan(0.5 * across * across));
        }

        // Sill, jamb and pane are at right angles: a ray with a bounce off all three returns in the direction of
        // incidence.
        [TestCase(30, true)]
        [TestCase(30, false)]
        [TestCase(150, false)]
        public void Build_Default_WindowReturnsARayTheWayItCame(double bearing, bool isInFront)
        {
            var house = new Deckhouse(Default, new Hull(Default));
            var bridge = new Bridge(Default, house);
            double3 window = double3(isInFront ? 0 : bridge.HalfWidth, house.UpperRoof + 0.6 * Default.StoreyHeight,
                isInFront ? bridge.Front : (bridge.Front + bridge.Aft) / 2);
            double3 towards = double3(sin(radians(bearing)), 0.4, -cos(radians(bearing)));
            var settings = TestRadar.Settings();
            var view = TestRadar.LookAt(window + 20 * normalize(towards), window, fov: 5);
            var rays = new ReferenceTracer(new RadarPose(new RadarScene(_coarse), settings, view)).TraceAll();

            var corners = Enumerable.Range(0, rays.Length)
                .Where(pixel => rays[pixel].Received && rays[pixel].Bounces == 3).ToArray();
            Assert.That(corners.Length, Is.GreaterThan(20));
            foreach (int pixel in corners)
            {
                Assert.That(distance(rays[pixel].Direction, -TestRadar.Direction(settings, view, pixel)),
                    Is.LessThan(1e-12));
                // The pane is behind the wall by the window's depth.
                double3 position = rays[pixel].LastHit - window;
                Assert.That(abs(isInFront ? position.z : position.x), Is.LessThan(Default.WindowDepth + Step));
            }
        }

        static ShipSettings LargeSettings()
        {
            var settings = WithTriangles(500000);
            (settings.Length, settings.Beam) = (130, 16);
            return settings;
        }

        static ShipSettings WithTriangles(int triangles)
        {
            var settings = Default;
            settings.Triangles = triangles;
            return settings;
        }

        // The published set-up: 50 m from the ship's centre, at a grazing angle of 10 degrees.
        static double3 Radar(double angle) => 50 * double3(-cos(radians(10.0)) * sin(radians(angle)),
            sin(radians(10.0)), -cos(radians(10.0)) * cos(radians(angle)));
    }
}
