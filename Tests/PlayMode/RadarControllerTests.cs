using System.Collections;
using Glint.Core;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Glint.Tests
{
    /// <summary>The component: when it traces, what it refuses, what it leaves behind.</summary>
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
            _radar.Roots.Add(_plate.transform); // whatever scene an earlier test left
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
            LogAssert.Expect(LogType.Log, new System.Text.RegularExpressions.Regex("RadarController of 'Radar': amplitude"));
            _radar.gameObject.SetActive(true);
            yield return null;
            Assert.That(_radar.Result, Is.Not.Null);
            Assert.That(_radar.Result.RaysReceived, Is.GreaterThan(0));
            Assert.That(_radar.Result.Objects, Is.EqualTo(1));
            Assert.That(_radar.Result.Triangles, Is.EqualTo(2));
        }

        [UnityTest]
        public IEnumerator Start_RadarWithoutReceiver_SaysSoOnceAndNamesTheField()
        {
            _radar.Receiver = null;
            LogAssert.Expect(LogType.Error, new System.Text.RegularExpressions.Regex("'Radar' has no receiver.*field Receiver"));
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
            Assert.That(Assert.Throws<GlintException>(() => _radar.Trace()).Message, Does.Contain("'Radar'").And.Contain("Roots"));
        }

        [Test]
        public void Trace_OrthographicCamera_IsRefusedByName()
        {
            _radar.GetComponent<Camera>().orthographic = true;
            Assert.That(Assert.Throws<GlintException>(() => _radar.Trace()).Message, Does.Contain("'Radar'").And.Contain("Perspective"));
        }

        [Test]
        public void Trace_SettingOutOfRange_IsRefusedByName()
        {
            _radar.Settings = new RadarSettings { FrequencyHz = 10e9, RaysAcross = 160, RaysDown = 90, MaxBounces = 0 };
            Assert.That(Assert.Throws<GlintException>(() => _radar.Trace()).Message, Does.Contain("RadarController of 'Radar'").And.Contain("1 to 16"));
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
