using System.Linq;
using Glint.Core;
using NUnit.Framework;
using static Glint.Host.Tests.UnityText;

namespace Glint.Host.Tests;

/// <summary>
/// Numbers out of a field's range are refused by name. Absent parts of a struct keep their initial values.
/// </summary>
public sealed class NumberFieldTests
{
    const int GaugeScript = 9, ScopeScript = 8, Mast = 1;

    TemporaryProject _project;

    [SetUp]
    public void Create()
    {
        _project = new TemporaryProject();
        _project.WriteScript(typeof(Gauge), GaugeScript);
    }

    [TearDown]
    public void Delete() => _project.Dispose();

    [TestCase("Whole", "4294967300", "-2147483648 to 2147483647"),
        TestCase("Whole", "99999999999", "-2147483648 to 2147483647")]
    [TestCase("Whole", "4294967295", "-2147483648 to 2147483647"),
        TestCase("Whole", "-2147483649", "-2147483648 to 2147483647")]
    [TestCase("Count", "4294967296", "0 to 4294967295"), TestCase("Count", "-1", "0 to 4294967295")]
    [TestCase("Small", "256", "0 to 255"), TestCase("Short", "32768", "-32768 to 32767")]
    [TestCase("Long", "9223372036854775808", "-9223372036854775808 to 9223372036854775807")]
    [TestCase("Unsigned", "18446744073709551616", "0 to 18446744073709551615"),
        TestCase("Unsigned", "-1", "0 to 18446744073709551615")]
    [TestCase("Kind", "4294967296", "-2147483648 to 4294967295")]
    public void WholeNumber_BeyondItsField_IsRefusedByName(string field, string value, string range) => Assert.That(
        Refusal($"  {field}: {value}\n"), Is.EqualTo($"Assets/Scene.unity: Gauge of 'A': {field} must be a whole "
            + $"number from {range}, and is '{value}': restore the file, or save it again in Unity"));

    [Test]
    public void Mask_BeyondItsBits_IsRefusedByName() =>
        Assert.That(Refusal("  Layers:\n    serializedVersion: 2\n    m_Bits: 4294967296\n"),
            Is.EqualTo("Assets/Scene.unity: Gauge of 'A': Layers.m_Bits must be a mask of 32 bits, "
                + "and is '4294967296': restore the file, or save it again in Unity"));

    [Test]
    public void WholeNumbers_AtTheirLimits_AreRead()
    {
        Gauge gauge = Load("  Whole: -2147483648\n  Count: 4294967295\n  Small: 255\n  Short: -32768\n"
            + "  Long: 9223372036854775807\n  Unsigned: 18446744073709551615\n  Kind: 4294967295\n  Layers:\n"
            + "    m_Bits: 4294967295\n");
        Assert.That((gauge.Whole, gauge.Count, gauge.Small, gauge.Short, gauge.Long, gauge.Unsigned,
            (int)gauge.Kind, gauge.Layers.value),
            Is.EqualTo(
                (int.MinValue, uint.MaxValue, byte.MaxValue, short.MinValue, long.MaxValue, ulong.MaxValue, -1, -1)));
    }

    [Test]
    public void PackedUnsignedNumbers_AreRead() =>
        Assert.That(Load("  Counts: 01000000ffffffff\n").Counts, Is.EqualTo(new[] { 1u, uint.MaxValue }));

    [Test]
    public void Override_BeyondItsField_IsRefusedByName()
    {
        _project.Write("Assets/Mast.prefab", Prefab(Object(100, "Mast", components: Component(102))
            + Script(102, 100, GaugeScript, "  Counts: 01000000\n")), Mast);
        string scene =
            Scene(Instance(500, Mast, modifications: "\n" + Change(102, Mast, "Counts.Array.data[0]", "-5")), 500);
        Assert.That(Assert.Throws<GlintException>(() => _project.LoadScene(scene)).Message,
            Does.Contain("Gauge of 'Mast': Counts[0] must be a whole number from 0 to 4294967295, and is '-5'"));
    }

    [TestCase("banana"), TestCase("nanometre"), TestCase("1e400"), TestCase("--inf"), TestCase("+-1"), TestCase("1,5")]
    public void Number_ThatIsNone_IsRefusedByName(string text)
    {
        foreach (string field in new[] { "Single", "Double" })
            Assert.That(Refusal($"  {field}: {text}\n"), Is.EqualTo("Assets/Scene.unity: Gauge of 'A': "
                + $"{field} must be a number, and is '{text}': restore the file, or save it again in Unity"));
    }

    [Test]
    public void Number_BeyondSinglePrecision_IsRefusedWhereItIsSingle()
    {
        Assert.That(Load("  Double: 1e39\n").Double, Is.EqualTo(1e39));
        Assert.That(Refusal("  Single: 1e39\n"), Does.Contain("Single must be a number, and is '1e39'"));
    }

    [TestCase("nan", double.NaN), TestCase("-.inf", double.NegativeInfinity),
        TestCase("Infinity", double.PositiveInfinity)]
    public void Number_InUnitysWords_IsRead(string text, double expected)
    {
        Gauge gauge = Load($"  Single: {text}\n  Double: {text}\n");
        Assert.That((gauge.Single, gauge.Double), Is.EqualTo(((float)expected, expected)));
    }

    [Test]
    public void Struct_WithoutSomeOfItsKeys_KeepsTheInitialisers()
    {
        Gauge gauge = Load("  Layers:\n    serializedVersion: 2\n  Size: {x: 7}\n  Area:\n    serializedVersion: 2\n"
            + "    width: 9\n  Box:\n    m_Center: {x: 5}\n");
        Assert.That((gauge.Layers.value, gauge.Size.x, gauge.Size.y), Is.EqualTo((-1, 7f, 3f)));
        Assert.That((gauge.Area.y, gauge.Area.width, gauge.Area.height), Is.EqualTo((2f, 9f, 4f)));
        Assert.That((gauge.Box.center.x, gauge.Box.center.y, gauge.Box.size.z), Is.EqualTo((5f, 1f, 2f)));
    }

    [Test]
    public void RequiredComponent_NotOnTheObject_IsRefusedByName()
    {
        _project.WriteScript(typeof(Scope), ScopeScript);
        string alone = Scene(Object(10, "Eye", components: Component(12)) + Script(12, 10, ScopeScript, ""), 11);
        Assert.That(Assert.Throws<GlintException>(() => _project.LoadScene(alone)).Message,
            Is.EqualTo("Assets/Scene.unity: 'Eye': Scope needs a Camera on the same object: add one"));
        string camera = "--- !u!20 &13\nCamera:\n  m_GameObject: {fileID: 10}\n  m_Enabled: 1\n";
        string whole =
            Scene(Object(10, "Eye", components: Component(12, 13)) + Script(12, 10, ScopeScript, "") + camera, 11);
        Assert.That(_project.LoadScene(whole).Single().GetComponent<Scope>(), Is.Not.Null);
    }

    Gauge Load(string fields) =>
        _project.LoadScene(Scene(Object(10, "A", components: Component(12)) + Script(12, 10, GaugeScript, fields), 11))
            .Single().GetComponent<Gauge>();

    string Refusal(string fields) => Assert.Throws<GlintException>(() => Load(fields)).Message;
}
