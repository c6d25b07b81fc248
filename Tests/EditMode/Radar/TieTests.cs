using System.Linq;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>Of triangles at equal distance the one of the lower instance is hit, then the lower of its mesh.</summary>
    public sealed class TieTests
    {
        static readonly RadarSettings s_settings = TestRadar.Settings(160, 90, 3);
        static readonly RadarView s_view = TestRadar.LookAt(double3(3, 14, -45), 0, fov: 25);

        // Others before, between and behind the coincident instances give them other places in the BVHs. Up to four
        // instances need no BVH of instances.
        [Test]
        public void TracePaths_CoincidentInstances_HitTheLowest([Values(0, 1, 3)] int others,
            [ValueSource(typeof(TestKernels), nameof(TestKernels.AsSoftware))] bool asSoftware)
        {
            var clutter = TestRadar.Clutter(60, 3);
            var transform = Affine.FromTransform(double3(1, 2, 3), normalize(double4(0.1, 0.7, -0.2, 0.6)), 1.5);
            var instances = Enumerable.Range(0, others)
                .Select(i => At(TestRadar.Clutter(20, (uint)(4 + i)), double3(2 * i - 3, i, 4 - i))).ToList();
            foreach (int place in new[] { others, others / 2, 0 })
                instances.Insert(place, new MeshInstance { Mesh = clutter, ToWorld = transform });
            var scene = new RadarScene(instances.ToArray());

            var paths = Paths(scene, asSoftware);
            var reference = new ReferenceTracer(new RadarPose(scene, s_settings, s_view));
            int lowest = instances.FindIndex(instance => instance.Mesh == clutter);
            Assert.That(paths.SelectMany(path => path.Hits)
                    .Where(hit => instances[hit.Instance].Mesh == clutter).Select(hit => hit.Instance).Distinct(),
                Is.EqualTo(new[] { lowest }));
            int compared = 0;
            foreach (var path in paths)
            {
                var expected = reference.Trace((int)path.Pixel % s_settings.RaysAcross,
                    (int)path.Pixel / s_settings.RaysAcross);
                var last = path.Hits.LastOrDefault();
                if (expected.Bounces != path.Bounces || path.Bounces == 0)
                    continue;
                compared++;
                Assert.That(expected.LastTriangle, Is.EqualTo(TestRadar.NumberOf(scene, last)), $"pixel {path.Pixel}");
            }
            Assert.That(compared, Is.GreaterThan(300));
        }

        // Every triangle three times in one mesh, in an order that puts the copies anywhere.
        [Test]
        public void TracePaths_CopiesInOneMesh_HitTheSameOneOnEveryBvh()
        {
            var clutter = TestRadar.Clutter(60, 3);
            var random = new System.Random(5);
            var indices = Enumerable.Range(0, 3 * clutter.TriangleCount).OrderBy(_ => random.Next())
                .SelectMany(i => clutter.Indices.Skip(3 * (i % clutter.TriangleCount)).Take(3)).ToArray();
            var scene = new RadarScene(new TriangleMesh(clutter.Vertices, indices));
            RayPath[] onBinary = Paths(scene, asSoftware: false), onWide = Paths(scene, asSoftware: true);
            Assert.That(onBinary.Select(Describe), Is.EqualTo(onWide.Select(Describe)));
            Assert.That(onBinary.Count(path => path.Bounces > 0), Is.GreaterThan(300));
        }

        static string Describe(RayPath path) =>
            string.Join(" ", path.Hits.Select(hit => $"{hit.Triangle} {hit.Position} {hit.Direction}"));

        static MeshInstance At(TriangleMesh mesh, double3 position) =>
            new MeshInstance { Mesh = mesh, ToWorld = Affine.FromTransform(position, double4(0, 0, 0, 1), 1) };

        static RayPath[] Paths(RadarScene scene, bool asSoftware)
        {
            uint[] pixels = Enumerable.Range(0, (int)s_settings.RayCount).Select(pixel => (uint)pixel).ToArray();
            using (var tracer = new RayTracer(TestKernels.Trace, "test", asSoftware))
                return tracer.TracePaths(new RadarPose(scene, s_settings, s_view), pixels);
        }
    }
}
