using System.Linq;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>
    /// The reference tracer's traversal against a loop over all triangles, and with difficult triangles.
    /// </summary>
    public sealed class ReferenceBvhTests
    {
        const double Nanometre = 1e-9;

        static readonly Affine s_turned =
            Affine.FromTransform(double3(117.5, -31.25, 43), double4(0.3, -0.2, 0.5, 0.8), double3(1, -1.5, 0.7));

        [Test]
        public void ClosestHit_RandomTriangles_IsTheNearestOfAll()
        {
            var scene = TestRadar.Clutter(500, seed: 3);
            var bvh = new ReferenceBvh(new RadarScene(scene));
            var random = new System.Random(5);
            int hits = 0;
            for (int i = 0; i < 2000; i++)
            {
                double3 origin =
                    12 * double3(random.NextDouble() * 2 - 1, random.NextDouble() * 2 - 1, random.NextDouble() * 2 - 1);
                double3 direction = i % 10 == 0 ? double3(0, 0, 1) : normalize(
                    double3(random.NextDouble() - 0.5, random.NextDouble() - 0.5, random.NextDouble() - 0.5));
                int expected = BruteForce.ClosestHit(scene, origin, direction, out double distance);
                int hit = bvh.ClosestHit(origin - bvh.Centre, direction, out double found);
                Assert.That(hit < 0 ? hit : bvh.Number(hit), Is.EqualTo(expected), $"ray {i}");
                if (expected < 0)
                    continue;
                hits++;
                Assert.That(found, Is.EqualTo(distance).Within(Nanometre), $"ray {i}");
            }
            Assert.That(hits, Is.GreaterThan(200));
        }

        [Test]
        public void ClosestHit_SeveralAtTheSameDistance_IsTheOneOfTheLowestNumber()
        {
            var plates = Enumerable.Range(0, 40).Select(_ => TestRadar.FacingPlate(4, 5)).ToArray();
            var bvh = new ReferenceBvh(new RadarScene(TestRadar.Join(plates)));
            for (int i = 0; i < 100; i++)
            {
                double3 direction = normalize(double3(0.003 * (i - 50), 0.1, 1));
                int hit = bvh.ClosestHit(-bvh.Centre, direction, out double distance);
                Assert.That(distance * direction.z, Is.EqualTo(5).Within(Nanometre));
                Assert.That(bvh.Number(hit), Is.LessThan(2), "the first plate");
            }
        }

        [Test]
        public void ClosestHit_FromInsideAClosedBodyAtItsVerticesAndAlongItsEdges_NoneEscapes()
        {
            var body = new SeaAndShip(1, 1000, 4000).Ship;
            var bvh = new ReferenceBvh(Placed(body));
            // A point of each of its four bodies.
            foreach (var inside in new[]
            {
                double3(0, 0.5, 0), double3(-5, 6, 0), double3(9, 5, 0), double3(-4, 12, 0)
            })
                for (int i = 0; i < body.Indices.Length; i++)
                    for (int part = 0; part < 4; part++)
                    {
                        float3 from = body.Vertices[body.Indices[i]],
                            to = body.Vertices[body.Indices[i / 3 * 3 + (i + 1) % 3]];
                        double3 origin = s_turned.Point(inside) - bvh.Centre;
                        double3 direction =
                            normalize(s_turned.Point(from + part / 4.0 * ((double3)to - from)) - bvh.Centre - origin);
                        if (bvh.ClosestHit(origin, direction, out _) < 0)
                            Assert.Fail($"side {i}, {part} quarters along it");
                    }
        }

        [Test]
        public void ClosestHit_FromASurfaceThatIsThereTwice_MeetsNeitherAgain()
        {
            // The second time with the opposite winding.
            var plate = TestRadar.FacingPlate(4, 0);
            var twice = TestRadar.Join(plate, new TriangleMesh(plate.Vertices, plate.Indices.Reverse().ToArray()));
            var bvh = new ReferenceBvh(Placed(twice));
            var random = new System.Random(3);
            for (int i = 0; i < 10000; i++)
            {
                double Next() => 2 * random.NextDouble() - 1;
                double3 origin = s_turned.Point(double3(3 * Next(), 3 * Next(), -20)) - bvh.Centre;
                double3 direction =
                    normalize(s_turned.Point(double3(1.9 * Next(), 1.9 * Next(), 0)) - bvh.Centre - origin);
                int hit = bvh.ClosestHit(origin, direction, out double distance);
                Assert.That(hit, Is.GreaterThanOrEqualTo(0), $"ray {i}");
                double3 normal = bvh.Normal(hit), position = origin + distance * direction;
                Assert.That(bvh.ClosestHit(position, direction, out _), Is.EqualTo(-1), $"ray {i}, onwards");
                Assert.That(bvh.ClosestHit(position, direction - 2 * dot(direction, normal) * normal, out _),
                    Is.EqualTo(-1), $"ray {i}, back");
            }
        }

        [Test]
        public void ClosestHit_TrianglesWithoutArea_AreNeverMet()
        {
            // Duplicate corners, and three on a line of float32 numbers, at scales from 1e-6 to 1e6. A ray is aimed at
            // the centre of each.
            var random = new System.Random(4);
            for (int i = 0; i < 2000; i++)
            {
                float scale = pow(2f, random.Next(-20, 20));
                float3 a = scale * float3(random.Next(-99, 99), random.Next(-99, 99), random.Next(-99, 99)),
                    step = scale * float3(random.Next(-99, 99), random.Next(-99, 99), random.Next(-99, 99));
                var corners = i % 2 == 0 ? new[] { a, a, a + step } : new[] { a, a + 3 * step, a + step };
                var bvh = new ReferenceBvh(Placed(new TriangleMesh(corners, new[] { 0, 1, 2 })));
                double3 origin = s_turned.Point((double3)a + 0.5 * (double3)step + 100 * scale) - bvh.Centre,
                    aim = s_turned.Point(a + 0.5f * step) - bvh.Centre;
                Assert.That(bvh.ClosestHit(origin, normalize(aim - origin), out _), Is.EqualTo(-1), $"triangle {i}");
            }
        }

        [Test]
        public void ClosestHit_MirrorOfMillimetresOneHundredKilometresFromTheRaysStart_IsMetInsideItsEdgesOnly()
        {
            // In a scene of that size. Rays pass its edges by a micrometre, inside and outside.
            var mirror = new TriangleMesh(new[] { float3(0, 0, 0), float3(2e-3f, 0, 0), float3(0, 1e-3f, 0) },
                new[] { 0, 1, 2 });
            var far = Affine.Identity;
            far.Origin = double3(1e5, 5e4, 3e4);
            var bvh = new ReferenceBvh(new RadarScene(new MeshInstance { Mesh = mirror, ToWorld = far },
                new MeshInstance { Mesh = TestRadar.FacingPlate(1, -1e5f), ToWorld = Affine.Identity }));
            const double Micrometre = 1e-6;
            foreach (var position in new[] { double2(1e-3, 0), double2(0, 5e-4), double2(1e-3, 5e-4) })
                foreach (int side in new[] { -1, 1 })
                {
                    double2 outwards =
                        position.y == 0 ? double2(0, -1) : position.x == 0 ? double2(-1, 0) : normalize(double2(1, 2));
                    double3 aim = far.Origin + double3(position + side * Micrometre * outwards, 0) - bvh.Centre,
                        origin = -bvh.Centre;
                    int hit = bvh.ClosestHit(origin, normalize(aim - origin), out double distance);
                    Assert.That(hit >= 0, Is.EqualTo(side < 0), $"{position}, side {side}");
                    if (side < 0)
                        Assert.That(distance, Is.EqualTo(length(aim - origin)).Within(Nanometre));
                }
        }

        static RadarScene Placed(TriangleMesh mesh) =>
            new RadarScene(new MeshInstance { Mesh = mesh, ToWorld = s_turned });
    }
}
