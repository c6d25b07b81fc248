using System.Linq;
using System.Numerics;
using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>Sums of the echo of a sea, as the device leaves them.</summary>
    public sealed class ClutterSumsTests
    {
        // A sea of a square kilometre, seen from above, has 20 million square metres: more than 64 bits of units.
        [TestCase(4.0e6, 5)]
        [TestCase(1.5e7, 1)]
        [TestCase(1.0e15, 200)]
        public void Echoes_OfLargePowers_AreTheirSum(double power, int copies)
        {
            var output = new uint[ClutterSums.WordsOf(1)];
            for (int copy = 0; copy < copies; copy++)
                Set(output, ClutterSums.Power, copy, new BigInteger(power) * new BigInteger(ClutterSums.PowerUnits));
            var echo = ClutterSums.Echoes(output, 1, Complex.One, "test").Single();
            Assert.That(echo.SigmaVV, Is.EqualTo(power * copies).Within(1e-9).Percent);
            Assert.That(echo.SigmaHH, Is.Zero);
        }

        // Fields have either sign, and so have the areas of waves that fold over.
        [Test]
        public void Echoes_OfNegativeFieldsAndAreas_AreTaken()
        {
            var output = new uint[ClutterSums.WordsOf(1)];
            Set(output, ClutterSums.Field, 0, new BigInteger(-3 * ClutterSums.FieldUnits));
            Set(output, ClutterSums.Area, 0, new BigInteger(-2 * ClutterSums.AreaUnits));
            var echo = ClutterSums.Echoes(output, 1, Complex.One, "test").Single();
            Assert.That((echo.S.VV.Real, echo.Area), Is.EqualTo((-3.0, -2.0)));
        }

        static void Set(uint[] output, int sum, int copy, BigInteger units)
        {
            int first = ClutterSums.SumWords * (sum * ClutterSums.CopiesOf(1) + copy);
            for (int word = first; word < first + ClutterSums.SumWords; word++, units >>= 32)
                output[word] = (uint)(units & uint.MaxValue);
        }
    }
}
