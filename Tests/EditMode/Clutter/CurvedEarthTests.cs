using System;
using System.Linq;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>Seas of meshes far from the radar, on an earth of 4/3 of the true radius.</summary>
    public sealed class CurvedEarthTests : ClutterFixture
    {
        const double TenGigahertz = 1e10;

        // The published height of the horizon: a calm sea is lit up to sqrt(2 R h), within half a tile.
        [TestCase(4)]
        [TestCase(15)]
        public void Trace_OfACalmSea_IsLitUpToTheHorizon(double height)
        {
            const double size = 256;
            var sea = new TestSea(10, size, 32, 0);
            var calm = new TriangleMesh(sea.Mesh.Vertices.Select(v => new float3(v.x, 0, v.z)).ToArray(), sea.Mesh.Indices);
            double horizon = Math.Sqrt(2 * ClutterGeometry.EarthRadius * height);
            int count = (int)(1.2 * horizon / size);
            var pose = PoseOf(sea, height, Enumerable.Range(1, count).Select(i => At(calm, i * size)).ToArray(), count);
            var grid = new ClutterGrid(new double3(-size, 0, size / 2), new double3(1, 0, 0), new double3(0, 0, 1),
                new double2(2 * size, size), new int2(1, count));
            var lit = Tracer.Trace(pose, TenGigahertz, grid).Select(cell => cell.LitFraction).ToArray();
            for (int i = 0; i < count; i++)
                if (Math.Abs((i + 1) * size - horizon) > size)
                    Assert.That(lit[i], Is.EqualTo((i + 1) * size < horizon ? 1 : 0).Within(0.01), $"{(i + 1) * size} m");
        }

        // A tile under the spherical wave of a radar near the sea is lit, and answers, as under the plane wave of the
        // grazing angle on a curved earth: at 10 km an eighth less than on a flat one.
        [TestCase(70, 2000, 0.003)]
        [TestCase(50, 10000, 0.118)]
        public void Trace_OfAFarTile_IsThatOfItsGrazingAngle(double height, double distance, double less)
        {
            const double size = 256;
            var sea = new TestSea(10, size, 256, 0);
            double slant = math.length(new double2(distance, height + ClutterGeometry.DropAt(distance))),
                grazing = ClutterGeometry.Grazing(height, slant);
            Assert.That(1 - grazing / (height / distance), Is.EqualTo(less).Within(0.003));
            var tiles = Enumerable.Range(0, (int)Math.Min(8, distance / size)).Select(i => At(sea.Mesh, distance - i * size));
            var pose = PoseOf(sea, height, tiles.ToArray(), 1);
            var found = Tracer.Trace(pose, TenGigahertz).Single();
            var plane = new EndlessSea(new RadarScene(At(sea.Mesh, 0)), pose.Scene.Seas[0])
                .PoseOf(0, math.degrees(grazing), TenGigahertz);
            var expected = Tracer.Trace(plane, TenGigahertz).Single();
            // Over a tile the angle and the power of 1 / distance^4 are those of its middle, but for their curvature.
            double spread = Math.Pow(size / distance, 2), strength = Math.Pow(slant / pose.Range, 4);
            Assert.That(found.LitFraction / expected.LitFraction, Is.EqualTo(1).Within(0.04 + spread));
            Assert.That(Sigma0.Decibels(strength * found.Sigma0.VV / expected.Sigma0.VV), Is.EqualTo(0).Within(0.3));
            Assert.That(Sigma0.Decibels(strength * found.Sigma0.HH / expected.Sigma0.HH), Is.EqualTo(0).Within(0.3));
        }

        // A cross section at a range: level at the phase centre, from which elevation is measured. The horizon is where it
        // is seen from the radar, by its height above the sea below it.
        [Test]
        public void PoseOf_ACrossSectionAtARange_IsLitUpToTheHorizon()
        {
            const double size = 256, height = 15, before = 4000;
            var sea = new TestSea(10, size, 32, 0);
            var calm = new TriangleMesh(sea.Mesh.Vertices.Select(v => new float3(v.x, 0, v.z)).ToArray(), sea.Mesh.Indices);
            double rise = height - ClutterGeometry.DropAt(before),
                horizon = Math.Sqrt(2 * ClutterGeometry.EarthRadius * height);
            int count = (int)(1.2 * horizon / size);
            var tiles = Enumerable.Range(0, count).Select(i => At(calm, i * size - before + size)).ToArray();
            var numbers = tiles.Select((_, i) => new SeaTileInstance(i, new int2(0, i))).ToArray();
            var scene = new RadarScene(tiles) { Seas = new[] { new RadarSea(sea.Clutter, numbers) } };
            var plan = new CrossSectionPlan(new[] { 0.0 }, new[] { math.degrees(Math.Atan(rise / before)) },
                new[] { TenGigahertz });
            var setup = new CrossSectionSetup(scene, plan) { Range = Math.Sqrt(rise * rise + before * before) };
            var pose = setup.PoseOf(plan[0]);
            var grid = new ClutterGrid(new double3(-size, 0, size / 2 - before), new double3(1, 0, 0), new double3(0, 0, 1),
                new double2(2 * size, size), new int2(1, count));
            var lit = Tracer.Trace(pose, TenGigahertz, grid).Select(cell => cell.LitFraction).ToArray();
            for (int i = 0; i < count; i++)
                if (Math.Abs((i + 1) * size - horizon) > size)
                    Assert.That(lit[i], Is.EqualTo((i + 1) * size < horizon ? 1 : 0).Within(0.01), $"{(i + 1) * size} m");
            Assert.That(setup.PoseOf(plan[0]).Scene, Is.SameAs(pose.Scene), "the same for all rows");
            setup.Range = double.PositiveInfinity;
            Assert.That(setup.PoseOf(plan[0]).Scene, Is.SameAs(scene));
        }

        // Edges are where the poses' scene has them: at 3 km half a metre lower than on a flat earth.
        [Test]
        public void TakeAhead_OfACrossSectionAtARange_HasTheWedgesOfItsPoses()
        {
            var sea = new TestSea(10, 32, 32, 0);
            var scene = new RadarScene(At(sea.Mesh, 0), At(CrossSectionTargets.Plate(1, 2), 3000))
            {
                Seas = new[] { new RadarSea(sea.Clutter, new[] { new SeaTileInstance(0, 0) }) }
            };
            var plan = new CrossSectionPlan(new[] { 0.0 }, new[] { 1.0 }, new[] { TenGigahertz });
            var setup = new CrossSectionSetup(scene, plan) { Range = 5000 };
            var ahead = setup.TakeAhead().WedgesOf(setup.FoundPatches, default).Wedges;
            var expected = EdgeBuffers.WedgesOf(setup.PoseOf(plan[0]).Scene, setup.FoundPatches).Wedges;
            Assert.That(ahead.Select(wedge => (wedge.A, wedge.B)), Is.EqualTo(expected.Select(wedge => (wedge.A, wedge.B))));
            var flat = EdgeBuffers.WedgesOf(scene, setup.FoundPatches).Wedges;
            Assert.That(flat.Max(wedge => wedge.A.z), Is.GreaterThan(2000));
            Assert.That(flat.Where(wedge => wedge.A.z > 2000).Max(wedge => wedge.A.y)
                - ahead.Where(wedge => wedge.A.z > 2000).Max(wedge => wedge.A.y),
                Is.EqualTo(ClutterGeometry.DropAt(3000)).Within(0.01));
        }

        // Wedges and patches of a sweep are found once.
        [Test]
        public void PoseOf_RadarsAtOtherPlaces_IsTheSameScene()
        {
            var sea = new TestSea(10, 32, 32, 0);
            var tiles = new[] { new SeaTileInstance(0, 0), new SeaTileInstance(1, 0) };
            var pose = new RadarPose
            {
                Settings = RadarSettings.Default, View = ViewAt(30),
                Scene = new RadarScene(At(sea.Mesh, 5000), At(sea.Mesh, 0)) { Seas = new[] { new RadarSea(sea.Clutter, tiles) } }
            };
            var first = CrossSectionPose.Of(pose);
            pose.View.Position = new double3(3000, 30, -200);
            Assert.That(CrossSectionPose.Of(pose).Scene.IsSame(first.Scene));
            Assert.That(first.Scene.IsSame(pose.Scene), Is.False);
        }

        // Nothing is moved without a sea. Parallel rays come from no position.
        [TestCase(false, 0)]
        [TestCase(true, 20)]
        public void PoseOf_WithoutSeaOrPosition_IsFlat(bool hasSea, double apertureHeight)
        {
            var sea = new TestSea(10, 32, 32, 0);
            var pose = new RadarPose { Settings = RadarSettings.Default, View = ViewAt(30) };
            pose.View.ApertureHeight = apertureHeight;
            pose.Scene = new RadarScene(At(sea.Mesh, 5000));
            if (hasSea)
                pose.Scene.Seas = new[] { new RadarSea(sea.Clutter, new[] { new SeaTileInstance(0, 0) }) };
            Assert.That(CrossSectionPose.Of(pose).Scene, Is.SameAs(pose.Scene));
        }

        // A radar at the origin that looks along Z; the first tiles have an echo, all of them shade.
        static CrossSectionPose PoseOf(TestSea sea, double height, MeshInstance[] tiles, int echoing)
        {
            var own = Enumerable.Range(0, echoing).Select(i => new SeaTileInstance(i, new int2(0, i))).ToArray();
            return CrossSectionPose.Of(new RadarPose
            {
                Settings = RadarSettings.Default, View = ViewAt(height),
                Scene = new RadarScene(tiles) { Seas = new[] { new RadarSea(sea.Clutter, own) } }
            });
        }

        static RadarView ViewAt(double height) => new RadarView
        {
            Position = new double3(0, height, 0), Right = new double3(1, 0, 0), Up = new double3(0, 1, 0),
            Forward = new double3(0, 0, 1), VerticalFovDegrees = 120
        };

        static MeshInstance At(TriangleMesh mesh, double distance)
        {
            var toWorld = Affine.Identity;
            toWorld.Origin = new double3(0, 0, distance);
            return new MeshInstance { Mesh = mesh, ToWorld = toWorld };
        }
    }
}
