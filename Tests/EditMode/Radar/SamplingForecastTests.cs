using Glint.Core;
using NUnit.Framework;
using Unity.Mathematics;
using static Unity.Mathematics.math;

namespace Glint.Tests
{
    /// <summary>The forecast of a mirror's return, against the traced mirror.</summary>
    public sealed class SamplingForecastTests
    {
        // Large enough to reflect rays to the whole receiver.
        const float Side = 12;

        [TestCase(0, 192, 108, 10, TestName = "On the axis")]
        [TestCase(4, 384, 216, 5, TestName = "4 m off the axis")]
        [TestCase(-6, 768, 432, 3, TestName = "6 m off the axis")]
        [TestCase(6, 384, 216, 5,
            TestName = "So far off the axis that neighbours differ by more than half a wavelength")]
        public void Of_AMirrorThatFacesTheRadar_IsWhatItsTraceGives(double aside, int across, int down, double percent)
        {
            var settings = TestRadar.Settings(across, down);
            var view = TestRadar.LookAt(0, double3(0, 0, 40), 20);
            var centre = double3(aside, 0, 40);
            var result = TestKernels.TraceOnce(Facing(centre, normalize(centre)), settings, view);

            var forecast = SamplingForecast.Of(settings, view, centre).Value;
            Assert.That(result.RaysReceived, Is.GreaterThan(100));
            Assert.That(forecast.RaysReceived, Is.EqualTo(result.RaysReceived).Within(percent).Percent);
            Assert.That(forecast.LargestPathStep, Is.EqualTo(result.LargestPathStep).Within(percent).Percent);
            Assert.That(forecast.IsTooCoarse, Is.EqualTo(result.Undersampled));
            Assert.That(forecast.IsTooFew, Is.False);
            // The view's height at 40 m divided by its rays.
            Assert.That(forecast.RaySpacing, Is.EqualTo(2 * 40 * tan(radians(10.0)) / down).Within(1e-9));
        }

        [Test]
        public void Of_ParallelRays_IsWhatTheTraceGives()
        {
            var settings = TestRadar.Settings(100, 100);
            var view = TestRadar.LookAt(0, double3(0, 0, 40));
            view.ApertureHeight = 6;
            // The receiver faces aside, so that neighbouring paths differ by 0.06 m * tan(10 deg), also across the
            // picture's corners.
            view.ReceiverRight = double3(cos(radians(10.0)), 0, -sin(radians(10.0)));
            view.ReceiverForward = double3(sin(radians(10.0)), 0, cos(radians(10.0)));
            var result = TestKernels.TraceOnce(Facing(double3(0, 0, 40), double3(0, 0, 1)), settings, view);

            var forecast = SamplingForecast.Of(settings, view, double3(0, 0, 40)).Value;
            Assert.That(forecast.RaysReceived, Is.EqualTo(result.RaysReceived).Within(5).Percent);
            Assert.That(forecast.LargestPathStep,
                Is.EqualTo(0.06 * tan(radians(10.0)) / settings.Wavelength).Within(1e-6));
            Assert.That(forecast.LargestPathStep, Is.EqualTo(result.LargestPathStep).Within(1).Percent);
            Assert.That(forecast.RaySpacing, Is.EqualTo(0.06).Within(1e-12));
        }

        [Test]
        public void Of_FewRaysOnASmallReceiver_IsTooFew()
        {
            var view = TestRadar.LookAt(0, double3(0, 0, 40));
            view.ReceiverSize = 0.5;
            // Neighbours return 2 * 40 m * 2 tan(30 deg) / 54 = 1.7 m apart.
            Assert.That(SamplingForecast.Of(TestRadar.Settings(96, 54), view, double3(0, 0, 40)).Value.IsTooFew);
        }

        [Test]
        public void Of_APointBehindTheRadarOrAReceiverThatFacesAway_IsNone()
        {
            var view = TestRadar.LookAt(0, double3(0, 0, 40));
            Assert.That(SamplingForecast.Of(TestRadar.Settings(), view, double3(0, 0, -40)), Is.Null);
            view.ReceiverForward = -view.ReceiverForward;
            Assert.That(SamplingForecast.Of(TestRadar.Settings(), view, double3(0, 0, 40)), Is.Null);
        }

        static TriangleMesh Facing(double3 centre, double3 normal)
        {
            double3 right = normalize(cross(double3(0, 1, 0), normal)), up = cross(normal, right);
            return TestRadar.Plate((float3)(centre - Side / 2 * (right + up)),
                (float3)(Side * right), (float3)(Side * up));
        }
    }
}
