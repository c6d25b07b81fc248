using System;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    /// <summary>Echoes of meshes on the radar screen: levels, shadows, bounces and slices.</summary>
    public sealed class ScreenTargetsTests
    {
        const double Slope = 0.1, Range = 500, None = -100;

        // A plate that faces the radar, or is tilted. The mean is that of geometrical optics of a rough surface,
        // sigma0 = sec^4 exp(-tan^2 / (2 s^2)) / (2 s^2). A Gaussian of angles leaves out 4 sec^4: up to 0.4 dB here.
        [TestCase(0)]
        [TestCase(6)]
        [TestCase(12)]
        public void Plate_HasTheMeanOfARoughSurface(double tilt)
        {
            var mesh = Plate(20, 8, math.radians(tilt), new double3(0, 0, Range));
            using (var bench = new TargetBench(SceneOf(mesh, Slope, None)))
            {
                double expected = Integral(mesh, (cosine, area) =>
                {
                    double tan2 = 1 / (cosine * cosine) - 1;
                    return area * Math.Exp(-tan2 / (2 * Slope * Slope)) / (2 * Slope * Slope) / Math.Pow(cosine, 4);
                });
                bench.AssertMean(expected, 0.4);
            }
        }

        // The mean of the diffuse term: gamma times the area across the ray. The slope sends nothing back at 60 degrees.
        [TestCase(-10)]
        [TestCase(3)]
        public void DiffuseEcho_IsGammaTimesTheAreaAcrossTheRay(double gammaDb)
        {
            var mesh = Plate(20, 8, math.radians(60), new double3(0, 0, Range));
            using (var bench = new TargetBench(SceneOf(mesh, Slope, gammaDb)))
                bench.AssertMean(Integral(mesh, (cosine, area) => Math.Pow(10, gammaDb / 10) * area * cosine), 0);
        }

        // A half-space of permittivity 4 reflects 1/9 of the power at normal incidence.
        [Test]
        public void Dielectric_ReflectsItsShareOfThePower()
        {
            var mesh = Plate(20, 8, 0, new double3(0, 0, Range));
            var scene = SceneOf(mesh, Slope, None);
            scene.Surfaces = new[]
            {
                new SurfaceMaterial("wall", null, Medium.Constant(4, 0, 1, 0)).WithScatter(Slope, None)
            };
            using (var metal = new TargetBench(SceneOf(mesh, Slope, None)))
            using (var wall = new TargetBench(scene))
                Assert.That(wall.Power(1).Sum() / metal.Power(1).Sum(), Is.EqualTo(1.0 / 9).Within(1e-3));
        }

        // Two walls at a right angle. The echo of two bounces is at the range of the edge, whatever the wall that is met
        // first. Its mean is that of rays off walls of random slope, and twice as much: each path and its reverse add.
        [TestCase(45)]
        [TestCase(35)]
        public void Dihedral_HasTheMeanOfItsDoubleBounce(double aspect)
        {
            const double side = 12;
            var radar = TargetBench.Radar;
            // First and last hit are up to 17 m apart: in the middle of the beam, both.
            radar.BeamWidth = 30;
            double3 edge = new double3(0, 0, Range), first = Horizontal(180 - aspect), second = Horizontal(270 - aspect);
            var mesh = Joined(Wall(edge, side * first, side), Wall(edge, side * second, side));
            using (var bench = new TargetBench(SceneOf(mesh, Slope, None), radar))
            {
                double[] power = bench.Power(TargetBench.Seeds);
                int cell = (int)(Range / bench.Geometry.CellSize);
                double inCell = power.Where((_, i) => i % bench.Geometry.Radar.Cells == cell).Sum(), all = power.Sum();
                Assert.That(inCell / all, Is.GreaterThan(0.9), "at the edge");
                double expected = 2 * (DoubleBounce(side, aspect) + DoubleBounce(side, 90 - aspect)) / Math.Pow(Range, 4);
                TestContext.WriteLine($"{10 * Math.Log10(all / expected):F2} dB");
                // The spread is that of a circle, not of an ellipse, and some spread rays pass the walls' ends.
                Assert.That(10 * Math.Log10(all / expected), Is.EqualTo(0).Within(0.5 + bench.Tolerance(power)));
            }
        }

        [Test]
        public void Wall_HidesTheWallBehindIt()
        {
            var near = Plate(20, 20, 0, new double3(0, 0, 200));
            var far = Plate(20, 20, 0, new double3(0, 0, 400));
            using (var bench = new TargetBench(SceneOf(Joined(near, far), Slope, -10)))
            using (var alone = new TargetBench(SceneOf(far, Slope, -10)))
            {
                int cells = bench.Geometry.Radar.Cells, cell = (int)(400 / bench.Geometry.CellSize);
                double At(double[] power, int from) => power.Where((_, i) => i % cells >= from).Sum();
                Assert.That(At(alone.Power(1), cell), Is.GreaterThan(0));
                Assert.That(At(bench.Power(1), cell), Is.EqualTo(0));
            }
        }

        // The antenna looks over the wall's top, at its own height: of a mast from 40 m below to 40 m above it sees half.
        [Test]
        public void Mast_BehindALowWall_IsSeenAboveIt()
        {
            var mast = Plate(2, 80, 0, new double3(0, 0, 400));
            var wall = Plate(60, 40, 0, new double3(0, -20, 200));
            double[] Behind(TriangleMesh mesh)
            {
                using (var bench = new TargetBench(SceneOf(mesh, Slope, 0)))
                {
                    int cells = bench.Geometry.Radar.Cells, cell = (int)(395 / bench.Geometry.CellSize);
                    return bench.Power(TargetBench.Seeds).Where((_, i) => i % cells >= cell).ToArray();
                }
            }
            double ratio = Behind(Joined(mast, wall)).Sum() / Behind(mast).Sum();
            // Both sums are of few cells: two means of 40 exponential numbers each.
            Assert.That(ratio, Is.EqualTo(0.5).Within(4 * 0.5 * Math.Sqrt(2.0 / TargetBench.Seeds)));
        }

        // The own ship's side is before a target at 400 m, and it has an echo itself unless it is the own ship's.
        [TestCase(true)]
        [TestCase(false)]
        public void OwnShip_HasNoEcho_ButHides(bool isOwn)
        {
            var scene = new RadarScene(
                new MeshInstance { Mesh = Plate(2, 2, 0, new double3(0, 0, 20)), ToWorld = Affine.Identity },
                new MeshInstance { Mesh = Plate(2, 2, 0, new double3(0, 0, 400)), ToWorld = Affine.Identity });
            using (var bench = new TargetBench(scene, isOwn, false))
            {
                double[] power = bench.Power(1);
                int cells = bench.Geometry.Radar.Cells;
                double Near(bool isNear) => power.Where((_, i) => i % cells < cells / 4 == isNear).Sum();
                Assert.That(Near(true), isOwn ? Is.Zero : (NUnit.Framework.Constraints.IResolveConstraint)Is.GreaterThan(0));
                Assert.That(Near(false), Is.Zero);
            }
        }

        // The interference of a small target at 5,000 m: the phases of its points are the same with and without the sea.
        [TestCase(3)]
        [TestCase(11)]
        [TestCase(40)]
        public void Sea_InterferesAsWithAPoint(double height)
        {
            double Power(double reflection)
            {
                var radar = TargetBench.Radar;
                // So much power that fields in whole units are no coarser than the tolerance.
                (radar.RangeScale, radar.SeaReflection, radar.Power) = (6000, reflection, 1e8);
                // A strip of 1 mm: the interference changes by 60 dB a metre of height.
                var mesh = Plate(1, 0.001, 0, new double3(0, height - TargetBench.Height, 5000));
                using (var bench = new TargetBench(SceneOf(mesh, Slope, 20), radar))
                    return bench.Power(1).Sum();
            }
            double k = 2 * Math.PI * 9.41e9 / 299792458,
                expected = Math.Pow(SeaFactor.Squared(TargetBench.Height, height, 5000, 0.9, k), 2);
            Assert.That(10 * Math.Log10(Power(0.9) / Power(0) / expected), Is.EqualTo(0).Within(0.1));
        }

        // A target of 1 m height 5 m above the sea is behind the horizon at 26 km, where that of 50 m is before it.
        [TestCase(5, false)]
        [TestCase(50, true)]
        public void Target_BehindTheHorizon_HasNoEcho(double height, bool isSeen)
        {
            var radar = TargetBench.Radar;
            radar.RangeScale = 60000;
            double reach = Math.Sqrt(2 * 8.495e6) * (Math.Sqrt(TargetBench.Height) + Math.Sqrt(20));
            var mesh = Plate(1, 1, 0, new double3(0, height - TargetBench.Height, reach));
            using (var bench = new TargetBench(SceneOf(mesh, 0.01, None), radar))
                Assert.That(bench.Power(1).Any(power => power > 0), Is.EqualTo(isSeen));
        }

        // A ring of plates around the radar: every point has its echo once a turn, whatever the frames.
        [Test]
        public void Turns_OfAnyFrames_HaveTheSameBits()
        {
            var ring = Joined(Enumerable.Range(0, 12).Select(i => Plate(80, 10, 0, 300 * Horizontal(30 * i + 2), 30 * i + 2))
                .ToArray());
            using (var bench = new TargetBench(SceneOf(ring, Slope, -10)))
            {
                int[] expected = bench.Turn(1, 180);
                Assert.That(expected.Count(part => part != 0), Is.GreaterThan(500));
                foreach (double step in new[] { 77.0, 13 })
                    Assert.That(bench.Turn(1, step), Is.EqualTo(expected), $"frames of {step} deg");
            }
        }

        // Twenty boxes move to other places: as if the scene had been there from the start.
        [Test]
        public void MovedInstances_EchoFromWhereTheyAre()
        {
            var mesh = Plate(10, 10, 0, 0);
            RadarScene At(double turn) => new RadarScene(Enumerable.Range(0, 20).Select(i => new MeshInstance
            {
                Mesh = mesh,
                ToWorld = Placed(150 + (i * 7 % 20) * 20, 360.0 / 20 * i + turn)
            }).ToArray());
            using (var bench = new TargetBench(At(100)))
            using (var expected = new TargetBench(At(0)))
            {
                double[] before = bench.Power(1);
                bench.MoveTo(At(0));
                double[] moved = bench.Power(1), there = expected.Power(1);
                // Another centre rounds positions otherwise: phases differ by some hundredths.
                double difference = moved.Zip(there, (a, b) => Math.Abs(a - b)).Sum();
                Assert.That(difference, Is.LessThan(0.02 * there.Sum()));
                Assert.That(before.Zip(there, (a, b) => Math.Abs(a - b)).Sum(), Is.GreaterThan(there.Sum()));
            }
        }

        // Mean section of rays off a wall of random slope, then off the other one, in a small cone around the way back.
        static double DoubleBounce(double side, double aspect)
        {
            const double cone = 0.08;
            const int rays = 2_000_000;
            // The normals of the walls along x and z; the edge is y.
            double angle = math.radians(aspect);
            var direction = new double3(-Math.Cos(angle), 0, -Math.Sin(angle));
            // Of the wall that lies along z, whose normal is x, the part whose mirrored rays meet the other one.
            double width = Math.Min(side, side * Math.Tan(angle));
            var random = new System.Random(1);
            double sum = 0;
            for (int ray = 0; ray < rays; ray++)
            {
                double weight = 1;
                var once = Reflect(direction, new double3(1, 0, 0), new double3(0, 1, 0), new double3(0, 0, 1), random,
                    ref weight);
                if (once.z >= 0)
                    continue;
                var twice = Reflect(once, new double3(0, 0, 1), new double3(1, 0, 0), new double3(0, 1, 0), random,
                    ref weight);
                if (math.length(twice + direction) < cone)
                    sum += weight;
            }
            double density = sum / rays / (Math.PI * cone * cone), area = width * side * Math.Cos(angle);
            return 4 * Math.PI * area * density;
        }

        // Off a facet with Gaussian slopes. Facets take power as the ray sees them: its weight.
        static double3 Reflect(double3 direction, double3 normal, double3 u, double3 v, System.Random random,
            ref double weight)
        {
            double radius = Slope * Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())),
                turn = 2 * Math.PI * random.NextDouble();
            double3 facet = normal - radius * Math.Cos(turn) * u - radius * Math.Sin(turn) * v;
            weight *= Math.Max(0, math.dot(facet, direction) / math.dot(normal, direction));
            facet = math.normalize(facet);
            return direction - 2 * math.dot(facet, direction) * facet;
        }

        // Sum of section over R^4 of a mesh, by a function of the cosine of incidence and an area.
        static double Integral(TriangleMesh mesh, Func<double, double, double> section)
        {
            const int steps = 60;
            double sum = 0;
            for (int triangle = 0; triangle < mesh.TriangleCount; triangle++)
            {
                mesh.GetTriangle(triangle, out var a, out var b, out var c);
                double3 u = (double3)b - a, v = (double3)c - a, cross = math.cross(u, v);
                for (int i = 0; i < steps; i++)
                    for (int j = 0; j < steps; j++)
                    {
                        // A square folded to the triangle.
                        double x = (i + 0.5) / steps, y = (j + 0.5) / steps;
                        if (x + y > 1)
                            (x, y) = (1 - x, 1 - y);
                        double3 place = (double3)a + x * u + y * v - TargetBench.Antenna;
                        double range = math.length(place), cosine = Math.Abs(math.dot(place, cross)) / range / math.length(cross);
                        sum += section(cosine, math.length(cross) / 2 / (steps * steps)) / Math.Pow(range, 4);
                    }
            }
            return sum;
        }

        static double3 Horizontal(double degrees) =>
            new double3(Math.Sin(math.radians(degrees)), 0, Math.Cos(math.radians(degrees)));

        static Affine Placed(double range, double degrees)
        {
            double3 forward = Horizontal(degrees);
            return new Affine
            {
                X = new double3(forward.z, 0, -forward.x), Y = new double3(0, 1, 0), Z = forward, Origin = range * forward
            };
        }

        // Tilted back about its middle, relative to the antenna; bearing in degrees.
        // The plate is 5.71 degrees below the antenna, and 1 degree high.
        [TestCase(10)]
        [TestCase(22)]
        public void Plate_BelowTheBeam_LosesThePatternTwice(double width)
        {
            var mesh = Plate(20, 8, 0, new double3(0, -50, Range));
            var narrow = TargetBench.Radar;
            narrow.VerticalBeamWidth = width;
            double Level(in ScreenRadar radar)
            {
                using (var bench = new TargetBench(SceneOf(mesh, Slope, 0), radar))
                    return 10 * Math.Log10(bench.Power(4).Sum());
            }
            double half = Math.Atan(50 / Range) * 180 / Math.PI / (width / 2), wide = 5.71 / 89.5;
            Assert.That(Level(narrow) - Level(TargetBench.Radar),
                Is.EqualTo(-2 * 3.0103 * (half * half - wide * wide)).Within(0.1));
        }

        // At 10 GHz and 50 mm/h VV loses 0.01129 50^1.2156 = 1.31 dB/km (ITU-R P.838-3): 1.31 dB there and back.
        [Test]
        public void Rain_AttenuatesMeshesAndReflectors()
        {
            const double expected = -2 * 0.01129 * 116.2 * Range / 1000;
            var mesh = Plate(20, 8, 0, new double3(0, 0, Range));
            var radar = TargetBench.Radar;
            (radar.Frequency, radar.Polarisation) = (1e10, ScreenPolarisation.Vertical);
            (double, double) Levels(double rate)
            {
                radar.RainRate = rate;
                using (var bench = new TargetBench(SceneOf(mesh, Slope, 0), radar))
                    return (10 * Math.Log10(bench.Power(4).Sum()), 20 * Math.Log10(bench.Geometry.PointOf(
                        new double3(0, 10, Range), new double3(0, 10, 0), 1).Amplitude));
            }
            var (dryMesh, dryPoint) = Levels(0);
            var (wetMesh, wetPoint) = Levels(50);
            Assert.That(wetMesh - dryMesh, Is.EqualTo(expected).Within(0.01));
            Assert.That(wetPoint - dryPoint, Is.EqualTo(expected).Within(0.01));
        }

        // At 200 kHz pulses are 749.5 m apart; the plate is 290 to 301 m behind that.
        [Test]
        public void Plate_BeyondTheUnambiguousRange_IsShownNearer()
        {
            var mesh = Plate(40, 8, 0, new double3(0, 0, 1045));
            var radar = TargetBench.Radar;
            using (var bench = new TargetBench(SceneOf(mesh, Slope, 0), radar))
                Assert.That(bench.Power(1).Sum(), Is.Zero, "without a rate");
            radar.PulseRate = 2e5;
            using (var bench = new TargetBench(SceneOf(mesh, Slope, 0), radar))
            {
                double[] power = bench.Power(4);
                double shown = Enumerable.Range(0, power.Length).Where(i => i % radar.Cells == 29).Sum(i => power[i]);
                Assert.That(shown, Is.GreaterThan(0).And.EqualTo(power.Sum()));
            }
        }

        static TriangleMesh Plate(double width, double height, double tilt, double3 centre, double bearing = 0)
        {
            double3 across = Horizontal(bearing + 90) * width / 2,
                up = (Math.Cos(tilt) * new double3(0, 1, 0) + Math.Sin(tilt) * Horizontal(bearing)) * height / 2;
            return Rectangle(centre - across - up, 2 * across, 2 * up);
        }

        static TriangleMesh Wall(double3 edge, double3 along, double height) =>
            Rectangle(edge - new double3(0, height / 2, 0), along, new double3(0, height, 0));

        static TriangleMesh Rectangle(double3 corner, double3 u, double3 v)
        {
            corner += TargetBench.Antenna;
            return new TriangleMesh(new[] { (float3)corner, (float3)(corner + u), (float3)(corner + u + v),
                (float3)(corner + v) }, new[] { 0, 1, 2, 0, 2, 3 });
        }

        static TriangleMesh Joined(params TriangleMesh[] meshes) => new TriangleMesh(
            meshes.SelectMany(mesh => mesh.Vertices).ToArray(),
            meshes.SelectMany((mesh, i) => mesh.Indices.Select(index => index + meshes.Take(i).Sum(it => it.Vertices.Length)))
                .ToArray());

        static RadarScene SceneOf(TriangleMesh mesh, double slope, double gammaDb) => new RadarScene(mesh)
        {
            Surfaces = new[] { SurfaceMaterial.PerfectConductor.WithScatter(slope, gammaDb) }
        };
    }
}
