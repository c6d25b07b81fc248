using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>Horizons hide nothing, change no sum, and save visits.</summary>
    public sealed class HorizonTests
    {
        const int TestedRays = 6000;

        static readonly RadarView s_view =
            TestRadar.LookAt(50 * double3(0, sin(radians(10.0)), -cos(radians(10.0))), 0);

        static SeaAndShip Made => new SeaAndShip(1, 3000, 4000);

        static readonly Dictionary<string, Func<TriangleMesh>> Meshes = new Dictionary<string, Func<TriangleMesh>>
        {
            ["sea"] = () => Made.Sea,
            ["ship"] = () => Made.Ship,
            ["sea and ship"] = () => TestRadar.Join(Made.Sea, Made.Ship),
            ["sea whose triangles share no vertices"] = () => TestMeshes.Soup(Made.Sea),
            ["sea and ship in two dispatches"] = () =>
                TestRadar.Join(new SeaAndShip(1, 35000, 44000).Ship, new SeaAndShip(1, 35000, 44000).Sea),
            ["clutter"] = () => TestRadar.Clutter(1000, seed: 1),
            ["sparse clutter"] = () => TestRadar.Clutter(1000, seed: 2, halfSide: 10, largest: 0.2f),
            ["corner reflector"] = () => TestRadar.Trihedral(0, 4),
            ["powers of two"] = () => TestRadar.PowersOfTwo(1000, sizes: 20),
        };

        static IEnumerable<string> MeshNames => Meshes.Keys;

        [TestCaseSource(nameof(MeshNames))]
        public void FindHorizons_RandomRaysAboveTheHorizon_MeetNothing(string name)
        {
            var mesh = Meshes[name]();
            var rows = RowsWithHorizons(mesh, out var part);
            var random = new System.Random(7);
            int above = 0, free = 0;
            for (int i = 0; i < TestedRays; i++)
            {
                int leaf = random.Next(part.LeafCount), row = part.FirstRecordRow + 3 * leaf;
                double3[] pair = PairAt(rows, row);
                bool second = random.Next(2) == 1 && any(pair[2] != pair[3]);
                double3 a = pair[0], b = second ? pair[2] : pair[1], c = second ? pair[3] : pair[2];
                double3 normal = normalize(cross(b - a, c - a)), x = normalize(pair[2] - a), y = cross(normal, x);
                double u = sqrt(random.NextDouble()), v = random.NextDouble();
                double3 origin = a + u * (1 - v) * (b - a) + u * v * (c - a);
                double azimuth = 2 * PI_DBL * random.NextDouble(), sine = random.NextDouble();
                double3 direction = sine * normal + sqrt(1 - sine * sine) * (cos(azimuth) * x + sin(azimuth) * y);
                bool isFree = !Meets(mesh, origin, direction, a, b, c);
                free += isFree ? 1 : 0;
                if (sine <= HorizonAt(rows, row, second, azimuth))
                    continue;
                above++;
                if (!isFree)
                    Assert.Fail($"leaf {leaf}, sine {sine}, azimuth {azimuth}: the ray meets a triangle");
            }
            Assert.That(above, Is.LessThanOrEqualTo(free));
            if (name == "sea" || name == "ship")
                Assert.That(above, Is.GreaterThan(0.6 * free), "rays above the horizon of those that meet nothing");
        }

        [TestCase(false)]
        [TestCase(true)]
        public void Trace_WithHorizons_SumsAreTheSameBitForBitAndFewerNodesAreVisited(bool joined)
        {
            var made = new SeaAndShip(1, 35000, 44000);
            var scene = joined
                ? new RadarScene(TestRadar.Join(made.Ship, made.Sea))
                : new RadarScene(new MeshInstance { Mesh = made.Ship, ToWorld = Affine.Identity },
                    new MeshInstance { Mesh = made.Sea, ToWorld = Affine.Identity });
            var pose = new RadarPose(scene, TestRadar.Settings(480, 270), s_view);
            using (var tracer = new RayTracer(TestKernels.Trace, "test", false))
            {
                tracer.CountVisits = true;
                var without = tracer.Trace(pose, RayReadback.None);
                tracer.HorizonRaysATriangle = 0;
                var with = tracer.Trace(pose, RayReadback.None);
                Assert.That(with.Statistics.RaysRefined, Is.EqualTo(without.Statistics.RaysRefined));
                Assert.That(with.PathLengthMeters, Is.EqualTo(without.PathLengthMeters));
                Assert.That(with.Bounces, Is.EqualTo(without.Bounces));
                Assert.That(with.Amplitude, Is.EqualTo(without.Amplitude));
                Assert.That(with.Statistics.NodesVisited,
                    Is.LessThan((joined ? 0.8 : 0.65) * without.Statistics.NodesVisited));
            }
        }

        static uint4[] RowsWithHorizons(TriangleMesh mesh, out BvhPart part)
        {
            BvhPart found = null;
            var kernel = new TraceKernel(TestKernels.Trace, false, "test");
            using (var scene = new DeviceScene(BvhLayout.Binary, "test", long.MaxValue))
            {
                var statistics = new TraceStatistics();
                scene.Set(new RadarScene(mesh), statistics, (some, layout) =>
                {
                    var bvh = MeshBvh.Build(some, layout);
                    found = bvh.Parts.Single();
                    return bvh;
                });
                long rays = 10L * mesh.TriangleCount;
                scene.FindHorizons(kernel, rays, 10, statistics);
                Assert.That(statistics.Dispatches, Is.Zero, "a mesh that no ray has traced");
                scene.FindHorizons(kernel, rays, 10, statistics);
                int dispatches = statistics.Dispatches;
                Assert.That(dispatches, Is.GreaterThan(0));
                scene.FindHorizons(kernel, rays, 10, statistics);
                Assert.That(statistics.Dispatches, Is.EqualTo(dispatches), "horizons that are known");
                part = found;
                var rows = new uint4[found.Rows.Length];
                scene.Pages[0].Rows.ReadBack(rows, rows.Length);
                return rows;
            }
        }

        static double3[] PairAt(uint4[] rows, int row)
        {
            float4 r0 = asfloat(rows[row]), r1 = asfloat(rows[row + 1]), r2 = asfloat(rows[row + 2]);
            return new double3[] { r0.xyz, float3(r0.w, r1.xy), float3(r1.zw, r2.x), r2.yzw };
        }

        // Sine of the horizon, by the description in Shaders/Horizon.hlsl.
        static double HorizonAt(uint4[] rows, int row, bool second, double azimuth)
        {
            uint4 horizons = rows[rows[0].w + row / 3];
            double x = cos(azimuth), y = sin(azimuth);
            int sector = (x < 0 ? 1 : 0) + (y < 0 ? 2 : 0) + (abs(x) < abs(y) ? 4 : 0);
            uint word = horizons[(second ? 2 : 0) + sector / 4];
            return 1 - (word >> (8 * (sector % 4)) & 0xff) / 255.0;
        }

        // Tests all triangles but the ray's own, in double (Moeller and Trumbore).
        static bool Meets(TriangleMesh mesh, double3 origin, double3 direction, double3 a, double3 b, double3 c)
        {
            for (int t = 0; t < mesh.TriangleCount; t++)
            {
                mesh.GetTriangle(t, out var fa, out var fb, out var fc);
                double3 p0 = fa, p1 = fb, p2 = fc;
                if (IsCorner(p0) && IsCorner(p1) && IsCorner(p2))
                    continue;
                double3 e1 = p1 - p0, e2 = p2 - p0, p = cross(direction, e2), s = origin - p0, q = cross(s, e1);
                double determinant = dot(e1, p), u = dot(s, p) / determinant, v = dot(direction, q) / determinant;
                if (u >= 0 && v >= 0 && u + v <= 1 && dot(e2, q) / determinant > 0)
                    return true;
            }
            return false;

            bool IsCorner(double3 p) => all(p == a) || all(p == b) || all(p == c);
        }
    }
}
