using System.Linq;
using Glint.Reference;
using NUnit.Framework;
using UnityEditor.SceneManagement;
using UnityEngine;

namespace Glint.Tests
{
    /// <summary>Scenes/CornerReflector.unity against the reference tracer, which players lack.</summary>
    [Category("Slow")]
    public sealed class StoredSceneReferenceTests
    {
        [TearDown]
        public void LeaveAnEmptyScene() => EditorSceneManager.NewScene(NewSceneSetup.EmptyScene, NewSceneMode.Single);

        [TestCase(0)]
        [TestCase(23)]
        [TestCase(28)]
        public void Trace_AtAnAngle_EqualsTheReferenceWithTheSameTriangles(float angle)
        {
            EditorSceneManager.OpenScene("Packages/com.glint.scenes/CornerReflector.unity", OpenSceneMode.Single);
            var radar = Object.FindFirstObjectByType<RadarController>();
            GameObject.Find("Corner Reflector").transform.rotation = Quaternion.AngleAxis(angle, Vector3.up);
            var result = radar.Trace();
            var referenceTracer = new ReferenceTracer(radar.Gather());
            var expected = referenceTracer.Sum(referenceTracer.TraceAll());
            Assert.That(result.RaysHit, Is.EqualTo(expected.RaysHit).Within(0.01).Percent);
            Assert.That(result.RaysReceived, Is.EqualTo(expected.RaysReceived).Within(2));
            Assert.That(result.Bounces, Is.EqualTo(expected.Bounces).Within(0.01).Percent);
            Assert.That(result.PathLengthMeters, Is.EqualTo(expected.PathLengthMeters).Within(0.01).Percent);
            // Each phase has an error of at most some 0.005 rad: float32 lengths of 100 m have steps of 8 micrometres.
            double tolerance =
                0.005 * expected.RaysReceived + System.Math.Abs(result.RaysReceived - expected.RaysReceived);
            Assert.That(result.InPhase, Is.EqualTo(expected.InPhase).Within(tolerance));
            long inOtherBins = result.PhaseHistogram.Zip(expected.PhaseHistogram,
                (ours, theirs) => System.Math.Abs(ours - theirs)).Sum() / 2;
            Assert.That(inOtherBins, Is.LessThanOrEqualTo(expected.RaysReceived / 50), "rays in another bin of 10 deg");
            Assert.That(result.Quadrature, Is.EqualTo(expected.Quadrature).Within(tolerance));
        }
    }
}
