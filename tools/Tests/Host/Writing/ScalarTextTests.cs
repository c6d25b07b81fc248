using System.Globalization;
using NUnit.Framework;

namespace Glint.Host.Tests;

public sealed class ScalarTextTests
{
    [TestCase(20f, "20")]
    [TestCase(-1.234567e9f, "-1234567000")]
    [TestCase(9e16f, "90000000000000000")]
    [TestCase(1e-7f, "1e-07")]
    [TestCase(3.4028235e38f, "3.4028235e+38")]
    public void Of_Single_IsReadBackAndHasNoExponentWhereDigitsDo(float value, string text)
    {
        Assert.That(ScalarText.Of(value), Is.EqualTo(text));
        Assert.That(float.Parse(text, CultureInfo.InvariantCulture), Is.EqualTo(value));
    }
}
