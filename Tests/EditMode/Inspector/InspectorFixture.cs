using Glint.Core;
using Glint.Editor;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Tests
{
    /// <summary>A 4 m plate at 20 m, head-on to a small radar, without any finding.</summary>
    public abstract class InspectorFixture
    {
        protected GameObject _plate;
        protected RadarController _radar;
        internal RadarCheck _check;

        [SetUp]
        public void MakeScene()
        {
            _plate = GameObject.CreatePrimitive(PrimitiveType.Quad);
            _plate.name = "Plate";
            _plate.transform.position = new Vector3(0, 0, 20);
            _plate.transform.localScale = new Vector3(4, 4, 1);

            _radar = new GameObject("Radar", typeof(Camera)).AddComponent<RadarController>();
            _radar.Settings = new RadarSettings { FrequencyHz = 10e9, RaysAcross = 160, RaysDown = 90, MaxBounces = 4 };
            _radar.Receiver = new GameObject("Receiver").transform;
            _radar.Receiver.SetParent(_radar.transform, false);
            _radar.Receiver.localPosition = new Vector3(0, 0, -0.2f);
            _radar.Roots.Add(_plate.transform); // another scene may be left by an earlier test
            _radar.Kernel = TestKernels.Trace;
            _check = new RadarCheck(_radar);
        }

        [TearDown]
        public void RemoveScene()
        {
            _radar.Release();
            Object.DestroyImmediate(_radar.gameObject);
            Object.DestroyImmediate(_plate);
        }
    }
}
