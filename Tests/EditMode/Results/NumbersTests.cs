using System;
using System.Globalization;
using Glint.Core;
using NUnit.Framework;

namespace Glint.Tests
{
    public sealed class NumbersTests
    {
        [TestCase(0.0, "0")]
        [TestCase(-0.0, "0")]
        [TestCase(45.0, "45")]
        [TestCase(-1.5, "-1.5")]
        [TestCase(0.1, "0.1")]
        [TestCase(0.1 + 0.2, "0.30000000000000004")]
        [TestCase(1.0 / 3, "0.3333333333333333")]
        [TestCase(2.0 / 3, "0.6666666666666666")]
        [TestCase(2073600.0, "2073600")]
        [TestCase(10e9, "10000000000")]
        [TestCase(1e15, "1E+15")]
        [TestCase(1234567890123456.0, "1234567890123456")]
        [TestCase(1e-4, "0.0001")]
        [TestCase(1e-5, "1E-05")]
        [TestCase(1.7976931348623157E+308, "1.7976931348623157E+308")]
        public void Format_Number_IsTheShortestText(double value, string text) =>
            Assert.That(Numbers.Format(value), Is.EqualTo(text));

        [Test]
        public void Format_AnyBits_ReadBackTheSame()
        {
            var random = new Random(1);
            var bytes = new byte[8];
            for (int i = 0; i < 20000; i++)
            {
                random.NextBytes(bytes);
                double value = BitConverter.ToDouble(bytes, 0);
                if (double.IsNaN(value) || double.IsInfinity(value))
                    continue;
                string text = Numbers.Format(value);
                Assert.That(double.Parse(text, CultureInfo.InvariantCulture), Is.EqualTo(value), text);
                Assert.That(text.Length,
                    Is.LessThanOrEqualTo(value.ToString("G17", CultureInfo.InvariantCulture).Length));
            }
        }

        [Test]
        public void Format_InForeignCulture_IsTheSame()
        {
            using (new ForeignCulture())
                Assert.That(Numbers.Format(-1234.5), Is.EqualTo("-1234.5"));
        }

        [TestCase(double.NaN)]
        [TestCase(double.PositiveInfinity)]
        public void Format_NotFinite_IsRefused(double value) =>
            Assert.Throws<ArgumentOutOfRangeException>(() => Numbers.Format(value));
    }
}
