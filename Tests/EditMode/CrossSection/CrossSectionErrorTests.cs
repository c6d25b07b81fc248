using System;
using System.Linq;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests
{
    public sealed class CrossSectionErrorTests
    {
        static readonly string[] Bodies =
        {
            "plate", "plate with fringe fields", "dihedral", "trihedral", "sphere", "cylinder", "top hat",
            "two plates", "coated box", "ship"
        };

        [Test]
        public void Explore()
        {
            int from = int.Parse(Environment.GetEnvironmentVariable("EX_FROM")), to = int.Parse(Environment.GetEnvironmentVariable("EX_TO"));
            string only = Environment.GetEnvironmentVariable("EX_BODY") ?? "";
            string depths = Environment.GetEnvironmentVariable("EX_DEPTH") ?? "7";
            string file = Environment.GetEnvironmentVariable("EX_OUT");
            using var tracer = new CrossSectionTracer(TestKernels.Tubes);
            foreach (string body in Bodies.Where(b => only == "" || b == only))
            {
                var scene = SceneOf(body);
                for (int i = from; i < to; i++)
                {
                    var pose = PoseOf(body, scene, i);
                    foreach (string depth in depths.Split(','))
                    {
                        var watch = System.Diagnostics.Stopwatch.StartNew();
                        var settings = TubeSettings.Default;
                        settings.MaxDepth = int.Parse(depth);
                        var truth = new ReferenceCrossSection(pose.Scene).Compute(pose, settings)[0, 0];
                        double time = watch.Elapsed.TotalSeconds;
                        foreach (double tolerance in new[] { 1, 0.3, 0.1, 0.03 })
                        {
                            pose.ToleranceDb = tolerance;
                            watch.Restart();
                            var result = tracer.Trace(pose);
                            var s = result.S[0, 0];
                            double scale = new CrossSectionAccuracy(s, 0, result.FloorDbsm).Scale;
                            System.IO.File.AppendAllText(file, FormattableString.Invariant(
                                $"{body.Replace(' ', '_')} {i} {depth} {tolerance} {result.Errors[0, 0]:g5} {(s.VV - truth.VV).Magnitude:g5} {(s.HH - truth.HH).Magnitude:g5} {(s.HV - truth.HV).Magnitude:g5} {(s.VH - truth.VH).Magnitude:g5} {truth.VV.Magnitude:g5} {truth.HH.Magnitude:g5} {scale:g5} {(result.IsMet ? 1 : 0)} {result.Rays} {watch.Elapsed.TotalSeconds:f3} {time:f3}\n"));
                        }
                    }
                }
            }
        }

        static RadarScene SceneOf(string body)
        {
            var layer = new SurfaceMaterial("layer",
                new[] { new MaterialLayer(Medium.Constant(4, 0.4), 0.002) });
            switch (body)
            {
                case "plate":
                case "plate with fringe fields": return new RadarScene(CrossSectionTargets.Plate(0.3, 0.2));
                case "dihedral": return new RadarScene(CrossSectionTargets.Dihedral(0.2, 0.15));
                case "trihedral":
                    return new RadarScene(
                        CrossSectionTargets.Trihedral(0.2, CrossSectionTargets.TrihedralFace.Triangular));
                case "sphere": return new RadarScene(CrossSectionTargets.Sphere(0.25, 48));
                case "cylinder": return new RadarScene(CrossSectionTargets.Cylinder(0.05, 0.2, 180, true));
                case "top hat": return new RadarScene(CrossSectionTargets.TopHat(0.05, 0.1, 0.2, 180));
                case "two plates": return new RadarScene(CrossSectionTargets.TwoPlates(0.15, 0.15, 0.25));
                case "coated box":
                    return new RadarScene(CrossSectionTargets.Box(0.25, 0.15, 0.1)) { Surfaces = new[] { layer } };
                default: return Ship();
            }
        }

        // A hull with raked sides, a deckhouse and a mast.
        static RadarScene Ship()
        {
            var box = CrossSectionTargets.Box(1, 1, 1);
            MeshInstance Part(TriangleMesh mesh, double3 size, double3 rake, double3 at) => new MeshInstance
            {
                Mesh = mesh,
                ToWorld = new Affine
                {
                    X = new double3(size.x, 0, 0), Y = new double3(0, size.y, 0) + rake, Z = new double3(0, 0, size.z),
                    Origin = at
                }
            };
            return new RadarScene(
                Part(box, new double3(0.08, 0.06, 0.4), new double3(0, 0, 0.02), 0),
                Part(box, new double3(0.05, 0.06, 0.1), new double3(0.008, 0, 0), new double3(0, 0.05, -0.05)),
                Part(CrossSectionTargets.Cylinder(0.012, 0.1, 36, true), 1, 0, new double3(0, 0.12, -0.03)));
        }

        static CrossSectionPose PoseOf(string body, RadarScene scene, int number)
        {
            var random = new System.Random(1 + 1000 * Array.IndexOf(Bodies, body) + number);
            double Within(double a, double b) => a + (b - a) * random.NextDouble();
            RadarAspect Aspect() =>
                RadarAspect.At(Within(-180, 180), math.degrees(math.asin(Within(-1, 1))));
            var radar = Aspect();
            var receiver = radar;
            if (number % 4 == 3)
                do
                    receiver = Aspect();
                while (math.dot(receiver.ToRadar, radar.ToRadar) < -0.5);
            return new CrossSectionPose
            {
                Scene = scene, Radar = radar, Receivers = new[] { receiver },
                Frequencies = new[] { Within(8e9, 12e9) }, MaxBounces = 4, HasEdges = body != "plate"
            };
        }
    }
}
