using Glint.Core;
using Glint.Editor;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class PoseTableTests
    {
        [Test]
        public void Details_OfPerspectiveAndParallelRays_SayHowFarToTrustThem()
        {
            var sums = new RadarSums { InPhase = 3, Quadrature = -4, RaysOfPicture = 4 * 2073600 };
            var sampling = new SamplingReport(0.0123456, 2, false);
            string perspective = PoseTable.Details(new RadarResult(sums, sampling));
            Assert.That(perspective, Is.EqualTo("normalised amplitude 1.250, sampling error 0.0123; "
                + "largest step between neighbouring paths 2 wavelengths"));
            sums.RayArea = 0.000025;
            Assert.That(PoseTable.Details(new RadarResult(sums, sampling)),
                Does.EndWith(" 2 wavelengths; 2.5e-05 m2 a ray"));
            Assert.That(PoseTable.Details(new RadarResult(sums)),
                Is.EqualTo("normalised amplitude 1.250, sampling error not estimated; 2.5e-05 m2 a ray"));
        }
    }
}
