using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>Attenuation by rain.</summary>
    public sealed class RainAttenuationTests
    {
        // Table 5 of P.838-3: k, then alpha.
        [TestCase(10, true, 0.01217, 1.2571)]
        [TestCase(10, false, 0.01129, 1.2156)]
        [TestCase(20, true, 0.09164, 1.0568)]
        [TestCase(20, false, 0.09611, 0.9847)]
        [TestCase(35, true, 0.3374, 0.9047)]
        [TestCase(35, false, 0.3224, 0.8761)]
        public void Coefficients_AreThoseOfTheTable(double gigahertz, bool isHorizontal, double k, double alpha)
        {
            double At(double rate) => RainAttenuation.DecibelsAKilometre(1e9 * gigahertz, rate, isHorizontal);
            Assert.That(At(1), Is.EqualTo(k).Within(6e-4 * k));
            Assert.That(System.Math.Log10(At(10) / At(1)), Is.EqualTo(alpha).Within(6e-5));
            Assert.That(At(0), Is.Zero);
        }
    }
}
