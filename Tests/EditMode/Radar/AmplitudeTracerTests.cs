using System;
using System.Linq;
using System.Numerics;
using Glint.Core;
using Glint.Reference;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using Vector3 = UnityEngine.Vector3;

namespace Glint.Tests
{
    /// <summary>The amplitude by ray tubes against closed forms and the double-precision reference.</summary>
    [Category("Slow")]
    public sealed class AmplitudeTracerTests
    {
        const double OnePercentDb = 0.0864;

        AmplitudeTracer _tracer;

        // Traced once for all tests that compare with them.
        (RadarPose[] Poses, RadarResult[] Results) _single;

        [SetUp]
        public void SetUp() => _tracer = new AmplitudeTracer(TestKernels.Amplitude);

        [TearDown]
        public void TearDown() => _tracer.Dispose();

        static RadarPose Pose(RadarScene scene, in RadarView view, double toleranceDb)
        {
            var settings = RadarSettings.Default;
            settings.ToleranceDb = toleranceDb;
            return new RadarPose(scene, settings, view);
        }

        static Complex Normalised(RadarResult result) =>
            new Complex(result.InPhase, result.Quadrature) * RadarResult.NormalRays / result.RaysOfPicture;

        // Corners of a square of a side across the z axis.
        static TriangleMesh Square(float side)
        {
            float half = side / 2;
            return new TriangleMesh(new[]
            {
                new float3(-half, -half, 0), new float3(half, -half, 0), new float3(half, half, 0),
                new float3(-half, half, 0)
            }, new[] { 0, 1, 2, 0, 2, 3 });
        }

        /// <summary>
        /// Converged amplitudes by Reference/ReferenceAmplitude.cs, 3840 cells across: Documentation~/accuracy.md.
        /// </summary>
        [TestCase(0, 51.33, Category = "Stress")]
        [TestCase(23, 1.594)]
        [TestCase(28, 30.09)]
        [Timeout(600000)]
        public void CornerReflector_IsWithinOnePercentOfConverged(double degrees, double converged)
        {
            var result = _tracer.Trace(Pose(CornerReflector.Turned(degrees), CornerReflector.View, OnePercentDb));
            Assert.That(result.NormalisedAmplitude, Is.EqualTo(converged).Within(1).Percent);
            Assert.That(result.Undersampled, Is.False, "the tolerance is met");
            Assert.That(result.RaysEmitted, Is.LessThan(RadarResult.NormalRays / 2));
        }

        /// <summary>Crests, hidden facets and double bounces in a part of the sea, ray by ray in double precision.</summary>
        [Test]
        public void RegionOfSea_AgreesWithReference()
        {
            var sea = AccuracyScene.All().Last();
            var pose = Pose(sea.Scene, sea.View, OnePercentDb);
            pose.Settings.Region = new RayRegion { Left = 960, Bottom = 405, Width = 120, Height = 135 };
            var expected = ReferenceAmplitude.Of(pose, 120);
            Assert.That((Normalised(_tracer.Trace(pose)) - expected).Magnitude,
                Is.LessThan(0.01 * expected.Magnitude), $"{expected}");
        }

        /// <summary>
        /// A mirror square to the radar returns what falls within half the receiver's size; the path to the receiver's
        /// plane has the length (2 R + 0.2 m) sqrt(1 + u^2 + v^2) for the direction (u, v, 1).
        /// </summary>
        [Test]
        public void PlateBeforeRadar_IsClippedByReceiver()
        {
            var view = AccuracyScene.PublishedView(50, 0);
            double way = 2 * 50 + 0.2, edge = view.ReceiverSize.x / 2 / way, k = 2 * Math.PI / RadarSettings.Default.Wavelength;
            const int Steps = 400; // Simpson's rule
            Complex integral = 0;
            for (int i = 0; i <= Steps; i++)
                for (int j = 0; j <= Steps; j++)
                {
                    double u = edge * (2.0 * i / Steps - 1), v = edge * (2.0 * j / Steps - 1);
                    double weight = Simpson(i, Steps) * Simpson(j, Steps);
                    integral += Complex.FromPolarCoordinates(weight, k * way * Math.Sqrt(1 + u * u + v * v));
                }
            integral *= math.pow(2 * edge / Steps / 3, 2);
            double2 half = view.HalfSize(RadarSettings.Default);
            Complex expected = integral * RadarResult.NormalRays / (4 * half.x * half.y);
            var result = _tracer.Trace(Pose(new RadarScene(Square(4)), view, 0.01));
            Assert.That((Normalised(result) - expected).Magnitude, Is.LessThan(5e-4 * expected.Magnitude));
        }

        static double Simpson(int i, int steps) => i == 0 || i == steps ? 1 : i % 2 == 1 ? 4 : 2;

        /// <summary>
        /// Parallel rays on a mirror turned by an angle: the length grows by tan(a) (1 + 1 / cos 2a) across the wave,
        /// and the amplitude is the rays on the mirror times a sinc.
        /// </summary>
        [TestCase(0.5)]
        [TestCase(1.5)]
        public void TurnedPlateInPlaneWave_IsSinc(double degrees)
        {
            var view = AccuracyScene.PublishedView(50, 0);
            view.ApertureHeight = 2;
            view.ReceiverSize = 20;
            double a = math.radians(degrees), width = 0.5 * Math.Cos(a), k = 2 * Math.PI / RadarSettings.Default.Wavelength;
            double x = k * Math.Tan(a) * (1 + 1 / Math.Cos(2 * a)) * width / 2;
            double rays = RadarResult.NormalRays * width * 0.5 / (2 * 2 * RadarSettings.Default.Aspect);
            var scene = AccuracyScene.Turned(Square(0.5f), degrees);
            Assert.That(_tracer.Trace(Pose(scene, view, 0.01)).NormalisedAmplitude,
                Is.EqualTo(rays * Math.Abs(Math.Sin(x) / x)).Within(0.2).Percent);
        }

        [Test]
        public void Result_DoesNotDependOnDispatches()
        {
            var pose = Pose(CornerReflector.Turned(10), CornerReflector.View, OnePercentDb);
            var whole = _tracer.Trace(pose);
            _tracer.RowsADispatch = 7;
            var parts = _tracer.Trace(pose);
            Assert.That(parts.InPhase, Is.EqualTo(whole.InPhase));
            Assert.That(parts.Quadrature, Is.EqualTo(whole.Quadrature));
            Assert.That(parts.SamplingError, Is.EqualTo(whole.SamplingError));
        }

        /// <summary>Full lists halve slices; what their rays have revealed is in the error all the same.</summary>
        [Test]
        public void Result_DoesNotDependOnLists()
        {
            var pose = Pose(CornerReflector.Turned(28), CornerReflector.View, 1);
            var whole = _tracer.Trace(pose);
            using (var tracer = new AmplitudeTracer(TestKernels.Amplitude) { ListCapacity = 1 << 11 })
            {
                var halved = tracer.Trace(pose);
                Assert.That(halved.InPhase, Is.EqualTo(whole.InPhase));
                Assert.That(halved.Quadrature, Is.EqualTo(whole.Quadrature));
                Assert.That(halved.SamplingError, Is.EqualTo(whole.SamplingError));
            }
        }

        // Two instances, one of which turns, beside other views and scenes.
        (RadarPose[] Poses, RadarResult[] Results) Single()
        {
            if (_single.Poses != null)
                return _single;
            TriangleMesh reflector = CornerReflector.Turned(0).Instances[0].Mesh, square = Square(0.3f);
            RadarPose Turned(double degrees, double toleranceDb)
            {
                var scene = new RadarScene(CornerReflector.Turned(degrees).Instances[0], new MeshInstance
                {
                    Mesh = square, ToWorld = Affine.Identity
                });
                scene.Instances[0].Mesh = reflector;
                scene.Instances[1].ToWorld.Origin = new double3(1.5 - 0.05 * degrees, 0, 0);
                return Pose(scene, CornerReflector.View, toleranceDb);
            }
            var poses = new[]
            {
                Turned(0, 3), Turned(10, 2), Turned(12, 3),
                // Nothing in the picture; another scene.
                Turned(0, 3), Pose(CornerReflector.Turned(20), CornerReflector.View, 3)
            };
            poses[2].Settings.Region = new RayRegion { Left = 480, Bottom = 200, Width = 960, Height = 500 };
            poses[3].Settings.Region = new RayRegion { Left = 0, Bottom = 0, Width = 10, Height = 10 };
            var results = Array.ConvertAll(poses, pose => _tracer.Trace(pose));
            Assert.That(results.Take(3).Select(result => result.RaysReceived), Is.All.GreaterThan(0));
            Assert.That(results[3].RaysEmitted, Is.EqualTo(0));
            return _single = (poses, results);
        }

        /// <summary>Bit for bit, whatever the slices.</summary>
        [TestCase(0, 0)]
        [TestCase(50, 0, Category = "Stress")]
        [TestCase(0, 1 << 13)]
        [Timeout(600000)]
        public void Trace_ManyPoses_GivesResultsOfSingleOnes(int rowsADispatch, int listCapacity)
        {
            var (poses, single) = Single();
            using (var together = new AmplitudeTracer(TestKernels.Amplitude)
            {
                PosesTogether = 8, RowsADispatch = rowsADispatch, ListCapacity = listCapacity
            })
            {
                var results = together.Trace(poses);
                for (int i = 0; i < poses.Length; i++)
                {
                    Assert.That(results[i].InPhase, Is.EqualTo(single[i].InPhase), $"{i}");
                    Assert.That(results[i].Quadrature, Is.EqualTo(single[i].Quadrature), $"{i}");
                    Assert.That(results[i].SamplingError, Is.EqualTo(single[i].SamplingError), $"{i}");
                    Assert.That(results[i].RaysReceived, Is.EqualTo(single[i].RaysReceived), $"{i}");
                    Assert.That(results[i].RaysHit, Is.EqualTo(single[i].RaysHit), $"{i}");
                    Assert.That(results[i].PathLengthMeters, Is.EqualTo(single[i].PathLengthMeters), $"{i}");
                    Assert.That(results[i].RaysEmitted, Is.EqualTo(single[i].RaysEmitted), $"{i}");
                    Assert.That(results[i].Undersampled, Is.EqualTo(single[i].Undersampled), $"{i}");
                }
            }
        }

        [Test]
        [Timeout(600000)]
        public void TrueError_IsAsSaid()
        {
            foreach (double degrees in new[] { 5.0, 33 })
            {
                var coarse = _tracer.Trace(Pose(CornerReflector.Turned(degrees), CornerReflector.View, 1));
                var fine = _tracer.Trace(Pose(CornerReflector.Turned(degrees), CornerReflector.View, 0.2));
                double error = (Normalised(coarse) - Normalised(fine)).Magnitude;
                Assert.That(error, Is.LessThan(3 * coarse.SamplingError + fine.SamplingError), $"{degrees} deg");
                Assert.That(coarse.Undersampled, Is.False);
                Assert.That(error, Is.LessThan((Math.Pow(10, 0.05) - 1) * coarse.NormalisedAmplitude), $"{degrees} deg");
            }
        }

        [Test]
        public void SceneThatReturnsNothing_HasNoAmplitudeAndMeetsTolerance()
        {
            var result = _tracer.Trace(Pose(AccuracyScene.Turned(Square(4), 45), AccuracyScene.PublishedView(50, 0),
                OnePercentDb));
            Assert.That(result.Amplitude, Is.EqualTo(0));
            Assert.That(result.SamplingError, Is.EqualTo(0));
            Assert.That(result.Undersampled, Is.False);
        }

        // The points of their paths are more than a buffer of 128 MiB holds of the usual number of paths.
        [Test]
        public void MaxBounces_AreTraced()
        {
            var pose = Pose(CornerReflector.Turned(0), CornerReflector.View, 1);
            double four = _tracer.Trace(pose).NormalisedAmplitude;
            pose.Settings.MaxBounces = RadarSettings.BounceLimit;
            Assert.That(_tracer.Trace(pose).NormalisedAmplitude, Is.EqualTo(four).Within(15).Percent);
        }

        [TestCase(-0.1)]
        [TestCase(1e-6)]
        [TestCase(11)]
        [TestCase(double.NaN)]
        public void Tolerance_OutOfRange_IsRefused(double toleranceDb)
        {
            var pose = Pose(CornerReflector.Turned(0), CornerReflector.View, toleranceDb);
            Assert.That(() => _tracer.Trace(pose), Throws.InstanceOf<GlintException>()
                .With.Message.Contains("tolerance").And.Message.Contains("0.001 to 10"));
        }

        [Test]
        public void Tolerance_WithoutError_IsRefused()
        {
            var pose = Pose(CornerReflector.Turned(0), CornerReflector.View, OnePercentDb);
            pose.Settings.SkipSamplingError = true;
            Assert.That(() => _tracer.Trace(pose),
                Throws.InstanceOf<GlintException>().With.Message.Contains("Skip Sampling Error"));
        }

        /// <summary>Without a tolerance a radar makes no tracer of tubes, which would need their kernels.</summary>
        [Test]
        public void RadarWithoutTolerance_GivesBitsOfRayTracer()
        {
            var scene = new SceneBuilder();
            try
            {
                var mesh = Square(4);
                scene.Add("Square", new Mesh
                {
                    vertices = mesh.Vertices.Select(vertex => (Vector3)vertex).ToArray(), triangles = mesh.Indices
                }).localPosition = new Vector3(0, 0, 50);
                var camera = scene.Empty("Radar").gameObject.AddComponent<Camera>();
                var radar = camera.gameObject.AddComponent<RadarController>();
                radar.Receiver = scene.Empty("Receiver", radar.transform);
                radar.Roots.Add(scene.Root);
                radar.Kernel = TestKernels.Trace;
                radar.TubeKernel = null;
                radar.Settings = TestRadar.Settings();
                var result = radar.Trace();
                RadarResult expected;
                using (var tracer = new RayTracer(TestKernels.Trace))
                    expected = tracer.Trace(radar.Gather(), RayReadback.Received);
                Assert.That(result.RaysReceived, Is.GreaterThan(0));
                Assert.That(result.InPhase, Is.EqualTo(expected.InPhase));
                Assert.That(result.Quadrature, Is.EqualTo(expected.Quadrature));
                Assert.That(result.SamplingError, Is.EqualTo(expected.SamplingError));
                Assert.That(result.RaysEmitted, Is.EqualTo(expected.RaysEmitted));

                var settings = TestRadar.Settings();
                settings.ToleranceDb = OnePercentDb;
                radar.Settings = settings;
                Assert.That(() => radar.Trace(),
                    Throws.InstanceOf<GlintException>().With.Message.Contains("Tube Kernel"));
            }
            finally
            {
                scene.Destroy();
            }
        }

        [Test]
        public void OtherShader_IsRefused() => Assert.That(() => new AmplitudeTracer(TestKernels.Trace, "the radar"),
            Throws.InstanceOf<GlintException>().With.Message.Contains("Amplitude.compute"));
    }
}
