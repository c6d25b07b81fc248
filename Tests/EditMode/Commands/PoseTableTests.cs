using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class PoseTableTests
    {
        [Test]
        public void Details_OfPerspectiveAndParallelRays_SayHowFarToTrustThem()
        {
            var result = new RadarResult
            {
                InPhase = 3, Quadrature = -4, RaysOfPicture = 4 * 2073600,
                SamplingError = 0.0123456, LargestPathStep = 2
            };
            Assert.That(PoseTable.Details(result), Is.EqualTo("normalised amplitude 1.250, sampling error 0.0123; "
                + "largest step between neighbouring paths 2 wavelengths"));
            result.RayArea = 0.000025;
            Assert.That(PoseTable.Details(result), Does.EndWith(" 2 wavelengths; 2.5e-05 m2 a ray"));
        }
    }
}
