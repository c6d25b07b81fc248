using System.Globalization;
using System.Linq;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class AnglesTests
    {
        [TestCase("0:45:1", 46, 0, 45)]
        [TestCase("0:0:1", 1, 0, 0)]
        [TestCase("0:1e-30:1", 1, 0, 0, Description = "the same in the 28 places of a decimal")]
        [TestCase("-10:10:2.5", 9, -10, 10)]
        [TestCase("0:360:0.1", 3601, 0, 360)]
        [TestCase("0:1:1e-3", 1001, 0, 1)]
        [TestCase(" 5 : 6 : 1 ", 2, 5, 6)]
        public void Range_ReachedByWholeSteps_IncludesBothEnds(string text, int count, double first, double last)
        {
            var angles = SweepAxis.Angle.Parse(text);

            Assert.That(angles.Length, Is.EqualTo(count));
            Assert.That(angles.First(), Is.EqualTo(first));
            Assert.That(angles.Last(), Is.EqualTo(last));
        }

        [TestCase("0:45:2", 44)]
        [TestCase("0:45:100", 0)]
        [TestCase("0:45:1e300", 0)]
        [TestCase("0:1:0.4", 0.8)]
        public void Range_NotReachedByWholeSteps_EndsBelow(string text, double last) =>
            Assert.That(SweepAxis.Angle.Parse(text).Last(), Is.EqualTo(last));

        [Test]
        public void Range_StepWrittenWithRounding_StillReachesTheEnd() =>
            Assert.That(SweepAxis.Angle.Parse("0:1:0.333333333"), Is.EqualTo(new[] { 0, 0.333333333, 0.666666666, 1 }));

        [Test]
        public void Range_OfTenths_PrintsAsTenths()
        {
            var printed = SweepAxis.Angle.Parse("-1:1:0.1")
                .Select(angle => angle.ToString("R", CultureInfo.InvariantCulture));

            var expected = Enumerable.Range(-10, 21).Select(tenth => (tenth < 0 ? "-" : "")
                + System.Math.Abs(tenth) / 10 + (tenth % 10 == 0 ? "" : "." + System.Math.Abs(tenth) % 10));
            Assert.That(printed, Is.EqualTo(expected));
        }

        [TestCase("30", new[] { 30.0 })]
        [TestCase("0,10,5", new[] { 0.0, 10, 5 })]
        [TestCase("-1.5, 2e1", new[] { -1.5, 20 })]
        public void List_WithCommas_KeepsItsOrder(string text, double[] expected) =>
            Assert.That(SweepAxis.Angle.Parse(text), Is.EqualTo(expected));

        [Test]
        public void NegativeZero_IsZero() =>
            Assert.That(1 / SweepAxis.Angle.Parse("-0")[0], Is.EqualTo(double.PositiveInfinity));

        [TestCase("", "no angles")]
        [TestCase("  ", "no angles")]
        [TestCase("0:45", "three parts")]
        [TestCase("0:45:1:2", "three parts")]
        [TestCase("0::1", "missing")]
        [TestCase("0,,2", "missing")]
        [TestCase(",", "missing")]
        [TestCase("0;45", "0;45 is not a number")]
        [TestCase("a:b:c", "a is not a number")]
        [TestCase("0:NaN:1", "NaN is not a number")]
        [TestCase("0:45:Infinity", "Infinity is not a number")]
        [TestCase("1e999", "1e999 is not a number")]
        [TestCase("0:45:0", "STEP must be above 0")]
        [TestCase("0:45:-1", "STEP must be above 0")]
        [TestCase("45:0:1", "FROM must not be above TO")]
        [TestCase("0:361:1", "from -360 to 360")]
        [TestCase("5,10,2.5,10", "the angle 10 degrees is given twice: give each once")]
        [TestCase("0,-0", "the angle 0 degrees is given twice")]
        [TestCase("1e1,10", "the angle 10 degrees is given twice")]
        [TestCase("-361", "from -360 to 360")]
        [TestCase("0:45:1e-9", "1,000,000 angles")]
        [TestCase("0:45:1e-300", "1,000,000 angles")]
        [TestCase("0:1e-20:1e-25", "STEP must be at least")]
        public void Text_Malformed_IsRefusedWithTheReason(string text, string reason)
        {
            var error = Assert.Throws<UsageException>(() => SweepAxis.Angle.Parse(text));

            Assert.That(error.Message, Does.Contain(reason));
            Assert.That(error.Message, Does.Not.Contain("\n"));
        }

        [Test]
        public void Range_OfTheMostAngles_IsTaken() =>
            Assert.That(SweepAxis.Angle.Parse("0:0.999999:0.000001").Length, Is.EqualTo(1000000));

        [Test]
        public void Message_OfALongList_IsShort()
        {
            var list = string.Join(",", Enumerable.Repeat("1", 1000)) + ",x";

            Assert.That(Assert.Throws<UsageException>(() => SweepAxis.Angle.Parse(list)).Message.Length,
                Is.LessThan(200));
        }
    }
}
