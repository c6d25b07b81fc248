using System.Linq;
using Glint.Editor.Views;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Glint.Tests
{
    /// <summary>The outlined receiver in Scene view is the receiver of a pose.</summary>
    public sealed class RadarGizmosTests : InspectorFixture
    {
        [Test]
        public void Receiver_Turned_IsThatOfThePose()
        {
            _radar.ReceiverSize = new Vector2(3, 2);
            _radar.transform.SetPositionAndRotation(new Vector3(1, 2, 3), Quaternion.Euler(10, 20, 30));
            _radar.transform.localScale = new Vector3(2, 2, 2);
            _radar.Receiver.localRotation = Quaternion.Euler(0, 5, 0);
            AssertIsThatOfThePose();
        }

        [Test]
        public void Receiver_AsLargeAsTheAperture_IsThatOfThePose()
        {
            var camera = _radar.GetComponent<Camera>();
            (camera.orthographic, camera.orthographicSize) = (true, 3);
            _radar.ReceiverSize = Vector2.zero;
            _radar.Receiver.localPosition = new Vector3(1, 1, -0.5f);
            AssertIsThatOfThePose();
            Assert.That(Vector3.Distance(RadarGizmos.ReceiverOutline(_radar)[0], RadarGizmos.ReceiverOutline(_radar)[3]),
                Is.EqualTo(6).Within(1e-5));
        }

        [Test]
        public void Receiver_ThatIsNotKnown_HasNoCorners()
        {
            _radar.GetComponent<Camera>().orthographic = _radar.FitAperture = true;
            _radar.ReceiverSize = Vector2.zero;
            Assert.That(RadarGizmos.ReceiverOutline(_radar), Is.Empty);
            _radar.ReceiverSize = Vector2.one;
            Assert.That(RadarGizmos.ReceiverOutline(_radar).Length, Is.EqualTo(4));
            Object.DestroyImmediate(_radar.Receiver.gameObject);
            Assert.That(RadarGizmos.ReceiverOutline(_radar), Is.Empty);
        }

        void AssertIsThatOfThePose()
        {
            var pose = _radar.Gather();
            var view = pose.View;
            double3 right = view.ReceiverSize.x / 2 * view.ReceiverRight,
                up = view.ReceiverSize.y / 2 * view.ReceiverUp, centre = pose.Scene.Origin + view.ReceiverCentre;
            var expected = new[] { centre - right - up, centre + right - up, centre + right + up, centre - right + up };
            var corners = RadarGizmos.ReceiverOutline(_radar);
            Assert.That(corners.Length, Is.EqualTo(4));
            Assert.That(corners.Zip(expected, (corner, position) => math.distance((double3)(float3)corner, position))
                .Max(),
                Is.LessThan(1e-4));
        }
    }
}
