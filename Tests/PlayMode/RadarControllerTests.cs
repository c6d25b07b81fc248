using System.Collections;
using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Glint.Tests
{
    /// <summary>The component: when it traces, its refusals, and its cleanup.</summary>
    public sealed class RadarControllerTests
    {
        GameObject _plate;
        RadarController _radar;

        [SetUp]
        public void MakeScene()
        {
            // A plate of 4 m at 20 m, seen head-on.
            _plate = GameObject.CreatePrimitive(PrimitiveType.Quad);
            _plate.transform.position = new Vector3(0, 0, 20);
            _plate.transform.localScale = new Vector3(4, 4, 1);

            var camera = new GameObject("Radar");
            camera.SetActive(false);
            camera.AddComponent<Camera>().fieldOfView = 60;
            _radar = camera.AddComponent<RadarController>();
            _radar.Settings = new RadarSettings { FrequencyHz = 10e9, RaysAcross = 160, RaysDown = 90, MaxBounces = 4 };
            _radar.Receiver = new GameObject("Receiver").transform;
            _radar.Receiver.SetParent(camera.transform);
            _radar.Receiver.localPosition = new Vector3(0, 0, -0.2f);
            _radar.Roots.Add(_plate.transform); // another scene may be left by an earlier test
            _radar.Kernel = PlayAsset.Load<ComputeShader>("Packages/com.glint.radar/Shaders/Trace.compute");
        }

        [TearDown]
        public void RemoveScene()
        {
            _radar.Release(); // an object that was never active gets no OnDisable
            Object.DestroyImmediate(_radar.gameObject);
            Object.DestroyImmediate(_plate);
        }

        [UnityTest]
        public IEnumerator Start_ActiveRadar_TracesOnePose()
        {
            LogAssert.Expect(LogType.Log,
                new System.Text.RegularExpressions.Regex("RadarController of 'Radar': amplitude"));
            _radar.gameObject.SetActive(true);
            yield return null;
            Assert.That(_radar.Result, Is.Not.Null);
            Assert.That(_radar.Result.RaysReceived, Is.GreaterThan(0));
            Assert.That(_radar.Result.Statistics.Objects, Is.EqualTo(1));
            Assert.That(_radar.Result.Statistics.Triangles, Is.EqualTo(2));
        }

        [UnityTest]
        public IEnumerator Start_RadarWithoutReceiver_SaysSoOnceAndNamesTheField()
        {
            _radar.Receiver = null;
            LogAssert.Expect(LogType.Error,
                new System.Text.RegularExpressions.Regex("'Radar' has no receiver.*field Receiver"));
            _radar.gameObject.SetActive(true);
            yield return null;
            yield return null;
            Assert.That(_radar.Result, Is.Null);
        }

        [Test]
        public void Trace_AfterTheTargetMoved_SeesItThere()
        {
            var near = _radar.Trace();
            _plate.transform.position = new Vector3(0, 0, 40);
            var far = _radar.Trace();
            Assert.That(far.RaysHit, Is.EqualTo(near.RaysHit / 4).Within(10).Percent, "a quarter of the solid angle");
            Assert.That(far.PathLengthMeters / far.RaysHit, Is.EqualTo(40).Within(0.1));
        }

        [Test]
        public void Trace_StoredMeshChangedByAScript_IsHashedBesideAndSeen()
        {
            // In play mode scripts change a stored mesh without marking it dirty.
            var mesh = PlayAsset.Load<Mesh>("Packages/com.glint.meshes/Ship/Ship.asset");
            var stored = mesh.vertices;
            _plate.GetComponent<MeshFilter>().sharedMesh = mesh;
            _plate.transform.localScale = Vector3.one * 0.1f;
            _radar.Trace();
            var before = _radar.Trace();
            Assert.That((before.Statistics.BytesHashed, before.Statistics.BytesHashedBeside),
                Is.EqualTo((0L, 12L * mesh.vertexCount + 4L * mesh.GetIndexCount(0))));
            try
            {
                var moved = mesh.vertices;
                for (int i = 0; i < moved.Length; i++)
                    moved[i] += new Vector3(0, 0, 0.1f * moved[i].y);
                mesh.vertices = moved;
                var after = _radar.Trace();
                _radar.Release();
                var fresh = _radar.Trace();
                Assert.That(after.PathLengthMeters, Is.Not.EqualTo(before.PathLengthMeters));
                Assert.That(after.PathLengthMeters, Is.EqualTo(fresh.PathLengthMeters).Within(1e-6 * fresh.RaysHit));
            }
            finally
            {
                mesh.vertices = stored;
            }
        }

        [Test]
        public void Trace_PlateTurnedAway_IsHitAndNotReceived()
        {
            _plate.transform.rotation = Quaternion.Euler(0, 30, 0);
            var result = _radar.Trace();
            Assert.That(result.RaysHit, Is.GreaterThan(0));
            Assert.That(result.RaysReceived, Is.Zero);
        }

        [Test]
        public void Trace_RootThatWasDestroyed_IsRefusedInsteadOfTracingEverything()
        {
            Object.DestroyImmediate(_plate);
            Assert.That(Assert.Throws<GlintException>(() => _radar.Trace()).Message,
                Does.Contain("'Radar'").And.Contain("Roots"));
        }

        [Test]
        public void Trace_BelowARootMovedBy1000Kilometres_HasTheSameSumsBitForBit()
        {
            // Three plates at arbitrary angles, and an arbitrary radar pose; the roots are rotated and scaled.
            var root = new GameObject("Root").transform;
            foreach (var angles in new[] { new Vector3(0, 90, 3), new Vector3(88, 1, 0) })
            {
                var plate = Object.Instantiate(_plate, _plate.transform, true).transform;
                plate.localPosition = new Vector3(0.3f, -0.4f, -1.3f);
                plate.localRotation = Quaternion.Euler(angles);
            }
            _plate.transform.SetParent(root, true);
            _radar.transform.SetParent(root, true);
            root.localRotation = Quaternion.Euler(17, 130, -9);
            root.localScale = Vector3.one * 1.1f;
            _radar.RayReadback = RayReadback.All;
            var near = _radar.Trace();
            Assert.That(near.RaysReceived, Is.GreaterThan(0));
            var nearPose = _radar.Gather();
            root.localPosition = new Vector3(1000003.3f, -999985.9f, 777777.1f);
            for (int i = 0; i < 2; i++)
            {
                var far = _radar.Trace();
                Assert.That((far.InPhase, far.Quadrature, far.PathLengthMeters),
                    Is.EqualTo((near.InPhase, near.Quadrature, near.PathLengthMeters)));
                Assert.That((far.RaysHit, far.RaysReceived, far.Bounces),
                    Is.EqualTo((near.RaysHit, near.RaysReceived, near.Bounces)));
                Assert.That(_radar.Gather().View, Is.EqualTo(nearPose.View));

                // The file has world coordinates, whose float32 step is 1/16 m here.
                int hit = System.Array.FindIndex(far.Rays, ray => ray.Bounces > 0);
                double3 position = (double3)near.Rays[hit].LastHit + (float3)root.localPosition;
                Assert.That(math.distance(far.Rays[hit].LastHit, position), Is.LessThan(0.1));
                _radar.Release(); // and gathered again
            }
            _plate.transform.SetParent(null);
            _radar.transform.SetParent(null);
            Object.DestroyImmediate(root.gameObject);
        }

        [Test]
        public void Trace_RadarAndTargetApart1000KilometresAway_HasTheSameAmplitude()
        {
            // No common transform; float32 represents multiples of 1/16 m there.
            var near = _radar.Trace();
            Assert.That(near.RaysReceived, Is.GreaterThan(0));
            var away = new Vector3(1000000.0625f, -524288.5f, 250000.125f);
            _radar.transform.localPosition += away;
            _plate.transform.localPosition += away;
            var far = _radar.Trace();
            Assert.That(far.RaysReceived, Is.EqualTo(near.RaysReceived));
            Assert.That(far.Amplitude, Is.EqualTo(near.Amplitude).Within(0.1).Percent);
        }

        [Test]
        public void Gather_OrthographicCamera_HasAnApertureOfTwiceItsSize()
        {
            var camera = _radar.GetComponent<Camera>();
            (camera.orthographic, camera.orthographicSize) = (true, 2.25f);
            var pose = _radar.Gather();
            Assert.That(pose.View.ApertureHeight, Is.EqualTo(4.5));
            Assert.That(pose.View.HalfSize(pose.Settings).x, Is.EqualTo(4).Within(1e-12));
            Assert.That(pose.View.ReceiverSize, Is.EqualTo(new double2(3, 3)));

            _radar.ReceiverSize = Vector2.zero;
            Assert.That(_radar.Gather().View.ReceiverSize, Is.EqualTo(new double2(8, 4.5)), "as the aperture");
            camera.orthographic = false;
            Assert.That(Assert.Throws<GlintException>(() => _radar.Gather()).Message,
                Does.Contain("'Radar'").And.Contain("receiver size 0 x 0"));
        }

        [Test]
        public void Gather_FittedAperture_CoversWhatIsTraced()
        {
            var camera = _radar.GetComponent<Camera>();
            camera.orthographic = true;
            _radar.transform.position = new Vector3(10, 20, 0);
            (_radar.FitAperture, _radar.RaySpacing, _radar.ReceiverSize) = (true, 0.25, Vector2.zero);
            // A region of the fitted picture: 16 x 16 rays, not 160 x 90.
            _radar.Settings = new RadarSettings
            {
                FrequencyHz = 10e9, RaysAcross = 8, RaysDown = 8, MaxBounces = 4,
                Region = new RayRegion { Left = 8, Bottom = 8, Width = 8, Height = 8 }
            };
            var pose = _radar.Gather();
            Assert.That((pose.Settings.RaysAcross, pose.Settings.RaysDown, pose.View.ApertureHeight),
                Is.EqualTo((16, 16, 4.0)));
            Assert.That(math.distance(pose.View.Position, 0), Is.LessThan(1e-9));
            Assert.That(math.distance(pose.View.ReceiverCentre, new double3(0, 0, -0.2f)), Is.LessThan(1e-9));
            Assert.That(_radar.Trace().RaysEmitted, Is.EqualTo(64));
            Assert.That(_radar.Settings.RaysAcross, Is.EqualTo(8), "the radar's own settings stay");

            _plate.transform.rotation = Quaternion.Euler(0, 60, 0);
            Assert.That(_radar.Gather().Settings.RaysAcross, Is.EqualTo(8), "half as wide");
            camera.orthographic = false;
            _radar.ReceiverSize = Vector2.one;
            _radar.Settings = new RadarSettings { FrequencyHz = 10e9, RaysAcross = 160, RaysDown = 90, MaxBounces = 4 };
            Assert.That(_radar.Gather().Settings.RaysAcross, Is.EqualTo(160), "a perspective view is not fitted");
        }

        [TestCase(false, 0f, 1, "Camera of 'Radar'", "Size is 0")]
        [TestCase(false, -3f, 1, "Camera of 'Radar'", "Size is -3")]
        [TestCase(true, 5f, 0, "RadarController of 'Radar'", "ray spacing 0 m")]
        [TestCase(true, 5f, 1e-7, "RadarController of 'Radar'", "larger spacing")]
        public void Trace_ApertureThatCannotBe_IsRefusedByName(bool fits, float size, double spacing,
            string subject, string fault)
        {
            var camera = _radar.GetComponent<Camera>();
            (camera.orthographic, camera.orthographicSize) = (true, size);
            (_radar.FitAperture, _radar.RaySpacing) = (fits, spacing);
            Assert.That(Assert.Throws<GlintException>(() => _radar.Trace()).Message,
                Does.Contain(subject).And.Contain(fault));
        }

        [Test]
        public void Trace_SettingOutOfRange_IsRefusedByName()
        {
            _radar.Settings = new RadarSettings { FrequencyHz = 10e9, RaysAcross = 160, RaysDown = 90, MaxBounces = 0 };
            Assert.That(Assert.Throws<GlintException>(() => _radar.Trace()).Message,
                Does.Contain("RadarController of 'Radar'").And.Contain("1 to 16"));
        }

        [Test]
        public void Trace_AfterRelease_MakesItsBuffersAnewAndGivesTheSame()
        {
            var first = _radar.Trace();
            _radar.Release();
            Assert.That(_radar.Trace().InPhase, Is.EqualTo(first.InPhase));
        }
    }
}
