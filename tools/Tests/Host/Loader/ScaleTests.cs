using System.Linq;
using Glint.Core;
using NUnit.Framework;
using UnityEngine;
using static Glint.Host.Tests.UnityText;

namespace Glint.Host.Tests;

/// <summary>Large and adverse projects take time and memory in proportion to their size, or are refused.</summary>
public sealed class ScaleTests
{
    const int Mast = 1, Ship = 2, MarkerScript = 1000;

    TemporaryProject _project;

    [SetUp]
    public void Create()
    {
        _project = new TemporaryProject();
        _project.WriteScript(typeof(Marker), MarkerScript);
    }

    [TearDown]
    public void Delete() => _project.Dispose();

    // Four times as many objects take four times as long, not sixteen times. A search through all others for each
    // object took ten minutes.
    [Test, MaxTime(30_000)]
    public void Instances_ManyUnderOneObject_AreLoadedWithTheirChanges()
    {
        const int many = 2000;
        WriteMast();
        _project.Write("Assets/Ship.prefab",
            Prefab(Object(200, "Ship") + Instance(250, Mast, father: 201) + Instance(251, Mast, father: 201)), Ship);
        string changes = "\n" + Change(101, Mast, "m_LocalPosition.x", "2") + Change(200, Ship, "m_Name", "Boat"),
            removed = $"\n    - {Asset(113, Mast)}\n";
        string instances = string.Concat(Enumerable.Range(1000, many)
            .Select(id => Instance(id, Ship, father: 11, modifications: changes, removedComponents: removed)));
        Transform fleet = _project.LoadScene(Scene(Object(10, "Fleet") + instances, 11)).Single().transform;
        Assert.That(fleet.childCount, Is.EqualTo(many));
        Assert.That(fleet.GetChild(many - 1).name, Is.EqualTo("Boat"));
        Assert.That(fleet.GetComponentsInChildren<MeshRenderer>(), Has.Length.EqualTo(many));
    }

    [Test, MaxTime(30_000)]
    public void Prefabs_EachManyTimesInTheNext_AreRefused()
    {
        const int times = 80, levels = 10;
        _project.Write("Assets/Ship.prefab", Prefab(Object(200, "Ship")), Ship);
        for (int level = 1; level <= levels; level++)
            _project.Write($"Assets/Ship{level}.prefab", Prefab(Object(200, "Ship") + string.Concat(
                Enumerable.Range(250, times).Select(id => Instance(id, Ship + level - 1, father: 201)))), Ship + level);
        Assert.That(Refusal(Scene(Instance(500, Ship + levels), 500)), Is.EqualTo("Assets/Ship3.prefab: "
            + "its prefab instances, with those in the prefabs, hold more than 20000000 values: remove some"));
    }

    [Test]
    public void Prefabs_FarTooDeepInEachOther_AreRefused()
    {
        const int levels = 300;
        _project.Write("Assets/Ship.prefab", Prefab(Object(200, "Ship")), Ship);
        for (int level = Ship + 1; level <= levels; level++)
            _project.Write($"Assets/Ship{level}.prefab",
                Prefab(Object(200, "Ship") + Instance(250, level - 1, father: 201)), level);
        Assert.That(Refusal(Scene(Instance(500, levels), 500)), Does.StartWith("Assets/Scene.unity: "
            + "its prefabs lie more than 100 deep in each other, down to Assets/Ship"));
    }

    [Test]
    public void OverridePath_FarTooLong_IsRefused() =>
        Assert.That(RefusalOf(Change(114, Mast, string.Join('.', Enumerable.Repeat("a", 100_000)), "1")),
            Does.Contain("propertyPath must be a path such as"));

    [Test, MaxTime(60_000)]
    public void Arrays_GrownInEachOther_AreRefused() => Assert.That(RefusalOf(
        Change(114, Mast, "Parts.Array.size", "1") + Change(114, Mast, "Parts.Array.data[0].Array.size", "900000")
        + Change(114, Mast, "Parts.Array.size", "900000")), Does.Contain("values: remove some"));

    [TestCase("{<hex>: []}")]
    [TestCase("{<hex>: 00, <edits>: [[size, 2147483647]]}")]
    [TestCase("{<hex>: 00000000, <edits>: [[size, -3]]}")]
    public void PackedArray_OfTheLoadersOwnMarks_IsRefused(string value) =>
        Assert.That(Refusal(Scene(
            Object(10, "Ship", components: Component(12)) + Script(12, 10, MarkerScript, $"  Packed: {value}\n"), 11)),
            Does.Contain("Packed must be a text of 4-byte hexadecimal numbers"));

    [Test, MaxTime(20_000)]
    public void Meta_OfManyEmptyLines_IsReadOnce()
    {
        _project.Write("Assets/Scripts/Marker.cs.meta",
            $"fileFormatVersion: 2\nguid: {TemporaryProject.Guid(MarkerScript)}\n" + new string('\n', 300_000));
        GameObject ship = _project.LoadScene(
            Scene(Object(10, "Ship", components: Component(12)) + Script(12, 10, MarkerScript, ""), 11)).Single();
        Assert.That(ship.GetComponent<Marker>() != null);
    }

    [Test]
    public void AssemblyDefinition_WithAnEmptyName_IsRefused()
    {
        _project.Write("Assets/Scripts/Scripts.asmdef", """{ "name": "" }""");
        Assert.That(
            Refusal(Scene(Object(10, "Ship", components: Component(12)) + Script(12, 10, MarkerScript, ""), 11)),
            Is.EqualTo("Assets/Scripts/Scripts.asmdef: has no \"name\": add one"));
    }

    [Test]
    public void AssemblyDefinition_WithANameThatNoAssemblyHas_LeavesItsScriptsOut()
    {
        _project.Write("Assets/Scripts/Scripts.asmdef", """{ "name": "a, b=c" }""");
        GameObject ship = _project.LoadScene(
            Scene(Object(10, "Ship", components: Component(12)) + Script(12, 10, MarkerScript, ""), 11)).Single();
        Assert.That(ship.GetComponents<Component>(), Has.Length.EqualTo(1));
        Assert.That(_project.Warnings.Single(), Does.Contain("belongs to a, b=c, an assembly that is not built here"));
    }

    void WriteMast() => _project.Write("Assets/Mast.prefab", Prefab(
        Object(100, "Mast", children: [111]) + Object(110, "Radar", father: 101, components: Component(112, 113))
        + MeshFilter(112, 110) + MeshRenderer(113, 110)), Mast);

    // A scene with one changed instance of a prefab with a Marker.
    string RefusalOf(string changes)
    {
        _project.Write("Assets/Mast.prefab",
            Prefab(Object(100, "Mast", components: Component(114)) + Script(114, 100, MarkerScript, "  Numbers: []\n")),
            Mast);
        return Refusal(Scene(Instance(500, Mast, modifications: "\n" + changes), 500));
    }

    string Refusal(string scene) => Assert.Throws<GlintException>(() => _project.LoadScene(scene)).Message;
}
