using System.Linq;
using NUnit.Framework;
using UnityEngine;
using static Glint.Host.Tests.UnityText;

namespace Glint.Host.Tests;

/// <summary>Values that are not finite are refused on assignment and accepted from a file.</summary>
public sealed class TransformValueTests : EngineFixture
{
    const float Inf = float.PositiveInfinity, NaN = float.NaN;

    Transform _child;

    [SetUp]
    public void MakeObjects()
    {
        Transform parent = new GameObject("Ship").transform;
        parent.localPosition = new Vector3(10f, 0f, 0f);
        _child = new GameObject("Hull").transform;
        _child.SetParent(parent, false);
        _child.localPosition = new Vector3(1f, 2f, 3f);
    }

    [Test]
    public void Position_NotFinite_IsRefusedAndStays()
    {
        _child.localPosition = new Vector3(0f, NaN, -1.5f);
        _child.position = new Vector3(-Inf, 0f, 0f);
        Assert.That((_child.localPosition.x, _child.position.x), Is.EqualTo((1f, 11f)));
        Assert.That(Errors, Is.EqualTo(new[]
        {
            "transform.localPosition assign attempt for 'Hull' is not valid. "
                + "Input localPosition is { 0.000000, NaN, -1.500000 }.",
            "transform.position assign attempt for 'Hull' is not valid. Input position is { -Infinity, "
                + "0.000000, 0.000000 }.",
        }));
        Assert.That(Log.Select(entry => entry.Type), Is.All.EqualTo(LogType.Error));
    }

    [Test]
    public void Scale_NotFinite_IsRefusedAndStays()
    {
        _child.localScale = new Vector3(Inf, 1f, 1f);
        Assert.That(_child.localScale, Is.EqualTo(Vector3.one));
        Assert.That(Errors.Single(), Is.EqualTo("transform.localScale assign attempt for 'Hull' is not valid. "
            + "Input localScale is { Infinity, 1.000000, 1.000000 }."));
    }

    [Test]
    public void Rotation_NotANumber_IsRefusedAndStays()
    {
        _child.localRotation = Quaternion.Euler(0f, 30f, 0f);
        Quaternion before = _child.localRotation;
        _child.localRotation = new Quaternion(NaN, 0f, 0f, 1f);
        _child.rotation = new Quaternion(0f, NaN, 0f, 1f);
        _child.eulerAngles = new Vector3(NaN, 0f, 0f);
        Assert.That(_child.localRotation, Is.EqualTo(before));
        Assert.That(Errors.Take(2), Is.EqualTo(new[]
        {
            "transform.localRotation assign attempt for 'Hull' is not valid. Input rotation is { NaN, 0.000000, "
                + "0.000000, 1.000000 }.",
            "transform.rotation assign attempt for 'Hull' is not valid. Input rotation is { 0.000000, NaN, "
                + "0.000000, 1.000000 }.",
        }));
        Assert.That(Errors, Has.Length.EqualTo(3));
    }

    [TestCase("NaN", NaN), TestCase("nan", NaN), TestCase(".nan", NaN), TestCase("-nan", NaN)]
    [TestCase("Infinity", Inf), TestCase("inf", Inf), TestCase(".inf", Inf), TestCase("+.inf", Inf),
        TestCase("-inf", -Inf), TestCase("-Infinity", -Inf)]
    public void Position_OfAFile_IsTakenAsItIs(string written, float expected)
    {
        using TemporaryProject project = new();
        Transform loaded =
            project.LoadScene(Scene(Object(10, "A", position: $"{{x: {written}, y: 0, z: 0}}"), 11)).Single().transform;
        Assert.That(loaded.localPosition.x, Is.EqualTo(expected));
        Assert.That(Errors, Is.Empty);
    }
}
