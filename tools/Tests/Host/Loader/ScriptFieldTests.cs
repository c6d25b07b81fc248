using System.Linq;
using Glint.Core;
using NUnit.Framework;
using UnityEngine;
using static Glint.Host.Tests.UnityText;

namespace Glint.Host.Tests;

public sealed class ScriptFieldTests
{
    const int MarkerScript = 9, OptionsScript = 8, OptionsAsset = 7, Notes = 6, Prefab = 5, OtherAsset = 4;

    TemporaryProject _project;

    [SetUp]
    public void Create()
    {
        _project = new TemporaryProject();
        _project.WriteScript(typeof(Marker), MarkerScript);
        _project.WriteScript(typeof(MarkerOptions), OptionsScript);
    }

    [TearDown]
    public void Delete() => _project.Dispose();

    [Test]
    public void Numbers_OfEachWidth_AreTheFiles()
    {
        Marker marker = Load("  Precise: 10000000000.125\n  Large: -9223372036854775808\n"
            + "  Unsigned: 18446744073709551615\n  _hidden: 0.1\n  _base: 7\n  <Automatic>k__BackingField: 2.5\n");
        Assert.That((marker.Precise, marker.Large, marker.Unsigned, marker.Hidden, marker.Base, marker.Automatic),
            Is.EqualTo((10000000000.125, long.MinValue, ulong.MaxValue, 0.1f, 7, 2.5f)));
    }

    [Test]
    public void AbsentKeys_KeepTheInitialiserAndAreNeverNull()
    {
        Marker marker = Load("  unknown: 3\n  Skipped: 9\n  _private: 9\n");
        Assert.That((marker.Kept, marker.Kind, marker.Main.Length, marker.Skipped, marker.Private),
            Is.EqualTo((42, MarkerKind.Second, 3f, 5, 1f)));
        Assert.That((marker.Text, marker.Words.Count, marker.Numbers.Length, marker.Main.Label),
            Is.EqualTo(("", 0, 0, "")));
        Assert.That(marker.Target, Is.Null);
    }

    [Test]
    public void RenamedField_IsReadUnderItsFormerName() => Assert.That(Load("  oldName: 12\n").Renamed, Is.EqualTo(12));

    [Test]
    public void PackedArrays_AreDecodedFromHexadecimal()
    {
        Marker marker = Load("  Packed: 01000000ffffffff00000080\n  Switches: 010001\n");
        Assert.That(marker.Packed, Is.EqualTo(new[] { 1, -1, int.MinValue }));
        Assert.That(marker.Switches, Is.EqualTo(new[] { true, false, true }));
        Assert.That(Load("  Packed: \n").Packed, Is.Empty);
    }

    [Test]
    public void Texts_QuotedWrappedAndEmpty_AreAsUnityMeansThem()
    {
        Marker marker = Load("  Text: \"two\\nlines\"\n  Words:\n  - 'it''s: quoted'\n  - plain text that\n"
            + "    goes on\n  - \n  - \"\\u00e5\"\n");
        Assert.That(marker.Text, Is.EqualTo("two\nlines"));
        Assert.That(marker.Words, Is.EqualTo(new[] { "it's: quoted", "plain text that goes on", "", "\u00e5" }));
    }

    [Test]
    public void EngineStructs_AreReadByTheirOwnNames()
    {
        Marker marker = Load("  Layers:\n    serializedVersion: 2\n    m_Bits: 4294967295\n  Vector: {x: 1, y: 2, z: "
            + "3}\n  Cell: {x: -4, y: 5}\n  Turn: {x: 0, y: 1, z: 0, w: 0}\n"
            + "  Colour: {r: 0.25, g: 0.5, b: 0.75, a: 1}\n  Bytes:\n    serializedVersion: 2\n    rgba: 2164457985\n"
            + "  Box:\n    m_Center: {x: 1, y: 0, z: 0}\n    m_Extent: {x: 2, y: 3, z: 4}\n"
            + "  Area:\n    serializedVersion: 2\n    x: 1\n    y: 2\n    width: 3\n    height: 4\n");
        Assert.That(marker.Layers.value, Is.EqualTo(-1));
        Assert.That((marker.Vector.x, marker.Vector.y, marker.Vector.z), Is.EqualTo((1f, 2f, 3f)));
        Assert.That((marker.Cell.x, marker.Cell.y, marker.Turn.y), Is.EqualTo((-4, 5, 1f)));
        Assert.That((marker.Colour.r, marker.Colour.g, marker.Colour.b, marker.Colour.a),
            Is.EqualTo((0.25f, 0.5f, 0.75f, 1f)));
        Assert.That((marker.Bytes.r, marker.Bytes.g, marker.Bytes.b, marker.Bytes.a), Is.EqualTo((1, 2, 3, 129)));
        Assert.That((marker.Box.center.x, marker.Box.size.y, marker.Area.width, marker.Area.y),
            Is.EqualTo((1f, 6f, 3f, 2f)));
    }

    [Test]
    public void NestedClasses_AndListsOfThem_AreFilled()
    {
        Marker marker = Load("  Main:\n    Length: 8\n    Label: keel\n    Offset: {x: 1, y: 2, z: 3}\n  Parts:\n"
            + "  - Length: 1\n    Label: a\n  - Length: 2\n    Label: b\n  Kind: 4\n");
        Assert.That((marker.Main.Length, marker.Main.Label, marker.Main.Offset.z, marker.Kind),
            Is.EqualTo((8f, "keel", 3f, MarkerKind.Fourth)));
        Assert.That(marker.Parts.Select(part => part.Label), Is.EqualTo(new[] { "a", "b" }));
    }

    [Test]
    public void References_ToObjectsOfTheScene_AreThose()
    {
        string scene = Object(10, "A", components: Component(12)) + Script(12, 10, MarkerScript, "  Target: {fileID: "
                + "21}\n  Other: {fileID: 22}\n  Model: {fileID: 20}\n  Targets:\n  - {fileID: 11}\n  - {fileID: 0}\n")
            + Object(20, "B", components: Component(22)) + Script(22, 20, MarkerScript, "  Text: hello\n");
        GameObject[] roots = _project.LoadScene(Scene(scene, 11, 21));
        Marker marker = roots[0].GetComponent<Marker>();
        Assert.That(marker.Target, Is.SameAs(roots[1].transform));
        Assert.That(marker.Model, Is.SameAs(roots[1]));
        Assert.That(marker.Targets, Is.EqualTo(new[] { roots[0].transform, null }));
        Assert.That((marker.OtherAtCallback, marker.Callbacks), Is.EqualTo(("hello", 1)),
            "the callback comes once, when all objects are filled");
    }

    [Test]
    public void References_ToAssets_AreLoadedOnce()
    {
        _project.Write("Assets/Notes.txt", "calm sea", Notes);
        _project.Write("Assets/Box.prefab", UnityText.Prefab(Object(100, "Box")), Prefab);
        WriteOptions("Assets/A.asset", OptionsAsset, 9e9f, OtherAsset);
        WriteOptions("Assets/B.asset", OtherAsset, 2e9f, OptionsAsset);
        Marker marker = Load($"  Notes: {Asset(4900000, Notes)}\n  Model: {Asset(100, Prefab)}\n"
            + $"  Target: {Asset(101, Prefab)}\n  Settings: {Asset(11400000, OptionsAsset, 2)}\n");
        Assert.That(marker.Notes.text, Is.EqualTo("calm sea"));
        Assert.That(marker.Target, Is.SameAs(marker.Model.transform));
        Assert.That((marker.Settings.Frequency, marker.Settings.Next.Frequency), Is.EqualTo((9e9f, 2e9f)));
        Assert.That(marker.Settings.Next.Next, Is.SameAs(marker.Settings));
        Assert.That(_project.Project.LoadAsset("Assets/A.asset", typeof(MarkerOptions)), Is.SameAs(marker.Settings));
    }

    [Test]
    public void Reference_ToWhatIsNotThere_IsEmptyWithAWarning()
    {
        Marker marker =
            Load($"  Target: {{fileID: 77}}\n  Settings: {Asset(11400000, 33, 2)}\n  Other: {{fileID: 11}}\n");
        Assert.That(marker.Target, Is.Null);
        Assert.That(marker.Settings == null, "as in the editor, an asset that is gone equals null");
        Assert.That(_project.Warnings, Is.EqualTo(new[]
        {
            "Assets/Scene.unity: Marker of 'A': Target refers to object &77, which is not in the file: "
                + "the field is left empty, and what needs it may fail: assign it again",
            "Assets/Scene.unity: Marker of 'A': Other refers to a Transform, where a Marker is needed: "
                + "the field is left empty, and what needs it may fail: assign it again",
            $"Assets/Scene.unity: Marker of 'A': Settings refers to guid {TemporaryProject.Guid(33)}, which no .meta "
                + "in the project has: the field is left empty, and what needs it may fail: assign it again",
        }));
    }

    [Test]
    public void Field_OfTheWrongKind_IsRefusedByName()
    {
        GlintException error = Assert.Throws<GlintException>(() => Load("  Precise: fast\n"));
        Assert.That(error.Message, Is.EqualTo("Assets/Scene.unity: Marker of 'A': Precise must be a number, "
            + "and is 'fast': restore the file, or save it again in Unity"));
        Assert.Throws<GlintException>(() => Load("  Main: 5\n"));
        Assert.Throws<GlintException>(() => Load("  Packed: 01000\n"));
        Assert.Throws<GlintException>(() => Load("  Numbers: {x: 1}\n"));
        Assert.Throws<GlintException>(() => Load("  Target: 7\n"));
    }

    [Test]
    public void SerializeReference_InTheFile_IsRefusedInsteadOfLost() => Assert.That(
        Assert.Throws<GlintException>(() => Load("  Polymorphic:\n    rid: 1\n")).Message,
        Does.StartWith("Assets/Scene.unity: Marker of 'A': Polymorphic is a [SerializeReference] field"));

    [Test]
    public void ExecutionOrder_OfTheMetaFile_Counts()
    {
        _project.Write("Assets/Scripts/Marker.cs.meta", "fileFormatVersion: 2\nguid: "
            + $"{TemporaryProject.Guid(MarkerScript)}\nMonoImporter:\n  serializedVersion: 2\n  executionOrder: -50\n");
        Load("");
        int order = Messages.Of(typeof(Marker)).Order;
        Messages.Of(typeof(Marker)).Order = 0;
        Assert.That(order, Is.EqualTo(-50));
    }

    [Test]
    public void Scripts_Missing_AreLeftOutWithOneWarning()
    {
        string scene = Object(10, "A", components: Component(12)) + Script(12, 10, 55, "")
            + Object(20, "B", father: 11, components: Component(22)) + Script(22, 20, 55, "");
        GameObject root = _project.LoadScene(Scene(scene, 11)).Single();
        Assert.That(root.GetComponentsInChildren<MonoBehaviour>(), Is.Empty);
        Assert.That(_project.Warnings.Single(), Is.EqualTo(
            $"Assets/Scene.unity: MonoBehaviour of 'A' and 1 more: its script has guid {TemporaryProject.Guid(55)}, "
            + "which no .meta in the project has: it is left out, and anything it did is missing: "
            + "restore its script or remove it"));
    }

    Marker Load(string fields) =>
        _project.LoadScene(Scene(Object(10, "A", components: Component(12)) + Script(12, 10, MarkerScript, fields), 11))
            .Single().GetComponent<Marker>();

    void WriteOptions(string path, int guid, float frequency, int next) => _project.Write(path, Header
        + Script(11400000, 0, OptionsScript,
            $"  Frequency: {frequency:r}\n  Next: {Asset(11400000, next, 2)}\n"), guid);
}
