using System.Linq;
using System.Numerics;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>Sums of the echo of a sea, as the device leaves them.</summary>
    public sealed class ClutterSumsTests
    {
        // A sea of a square kilometre, seen from above, has 20 million square metres.
        [TestCase(4.0e6, 5)]
        [TestCase(1.0e6, 30)]
        public void Echoes_OfCopiesThatPass64BitsTogether_AreTheirSum(double power, int copies)
        {
            var output = new uint[ClutterSums.WordsOf(1)];
            for (int copy = 0; copy < copies; copy++)
                Set(output, ClutterSums.Power, copy, power * ClutterSums.PowerUnits);
            var echo = ClutterSums.Echoes(output, 1, Complex.One, "test").Single();
            Assert.That(echo.SigmaVV, Is.EqualTo(power * copies).Within(1e-9).Percent);
            Assert.That(echo.SigmaHH, Is.Zero);
        }

        // A copy that has passed 64 bits is negative, or was about to.
        [TestCase(-1.0)]
        [TestCase(4.2e6)]
        public void Echoes_OfACopyThatMayHaveWrapped_AreRefused(double power)
        {
            var output = new uint[ClutterSums.WordsOf(1)];
            Set(output, ClutterSums.Power + 2, 3, power * ClutterSums.PowerUnits);
            Assert.That(() => ClutterSums.Echoes(output, 1, Complex.One, "Radar"),
                Throws.TypeOf<GlintException>().With.Message.StartsWith("Radar: the echo of the sea").And.Message.Contains("radar is much nearer"));
        }

        // Fields have either sign, and so have the areas of waves that fold over.
        [Test]
        public void Echoes_OfNegativeFieldsAndAreas_AreTaken()
        {
            var output = new uint[ClutterSums.WordsOf(1)];
            Set(output, ClutterSums.Field, 0, -3 * ClutterSums.FieldUnits);
            Set(output, ClutterSums.Area, 0, -2 * ClutterSums.AreaUnits);
            var echo = ClutterSums.Echoes(output, 1, Complex.One, "test").Single();
            Assert.That((echo.S.VV.Real, echo.Area), Is.EqualTo((-3.0, -2.0)));
        }

        static void Set(uint[] output, int sum, int copy, double units)
        {
            ulong bits = (ulong)(long)units;
            int word = 2 * (sum * ClutterSums.CopiesOf(1) + copy);
            (output[word], output[word + 1]) = ((uint)bits, (uint)(bits >> 32));
        }
    }
}
