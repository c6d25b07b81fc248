using NUnit.Framework;
using UnityEngine;

namespace Glint.Host.Tests;

public class MathfTests
{
    [TestCase(0.5f, 0)]
    [TestCase(1.5f, 2)]
    [TestCase(2.5f, 2)]
    [TestCase(-0.5f, 0)]
    public void RoundToInt_OfAHalf_GoesToTheEvenNumber(float value, int expected)
    {
        Assert.That(Mathf.RoundToInt(value), Is.EqualTo(expected));
    }

    [TestCase(350, 10, 20)]
    [TestCase(10, 350, -20)]
    [TestCase(0, 180, 180)]
    [TestCase(720, 90, 90)]
    public void DeltaAngle_AcrossZero_IsTheShortWay(float from, float to, float expected)
    {
        Assert.That(Mathf.DeltaAngle(from, to), Is.EqualTo(expected).Within(1e-4));
    }

    [Test]
    public void Repeat_OfANegativeAngle_IsPositive()
    {
        Assert.That(Mathf.Repeat(-90, 360), Is.EqualTo(270));
        Assert.That(Mathf.PingPong(3, 2), Is.EqualTo(1));
    }

    [Test]
    public void Lerp_BeyondItsEnds_Stops()
    {
        Assert.That(Mathf.Lerp(2, 4, 1.5f), Is.EqualTo(4));
        Assert.That(Mathf.LerpUnclamped(2, 4, 1.5f), Is.EqualTo(5));
        Assert.That(Mathf.InverseLerp(2, 4, 3), Is.EqualTo(0.5f));
    }

    [Test]
    public void Colours_ThroughHueAndBack_AreTheSame()
    {
        foreach (Color colour in new[]
        {
            Color.red, Color.green, Color.blue, Color.yellow, Color.gray, new Color(0.2f, 0.7f, 0.4f)
        })
        {
            Color.RGBToHSV(colour, out float hue, out float saturation, out float value);
            Assert.That(Color.HSVToRGB(hue, saturation, value) == colour, $"{colour}");
        }
        Color.RGBToHSV(Color.blue, out float blue, out _, out _);
        Assert.That(blue, Is.EqualTo(2f / 3f).Within(1e-6));
    }

    [Test]
    public void Color32_OfAColor_IsRounded()
    {
        Color32 colour = new Color(1.5f, 0.5f, -1, 1);
        Assert.That((colour.r, colour.g, colour.b, colour.a), Is.EqualTo(((byte)255, (byte)128, (byte)0, (byte)255)));
    }
}
