using System.Linq;
using Glint.Core;
using NUnit.Framework;
using UnityEngine;
using static Glint.Host.Tests.UnityText;

namespace Glint.Host.Tests;

public sealed class PrefabFileTests
{
    const int Mast = 1, Ship = 2, Variant = 3, MarkerScript = 9;

    TemporaryProject _project;

    [SetUp]
    public void Create()
    {
        _project = new TemporaryProject();
        _project.WriteScript(typeof(Marker), MarkerScript);

        // Mast: root with a child Radar that carries a mesh and a Marker that refers to the root.
        _project.Write("Assets/Mast.prefab", Prefab(
            Object(100, "Mast", children: [111], position: "{x: 0, y: 5, z: 0}")
            + Object(110, "Radar", father: 101, components: Component(112, 113, 114))
            + MeshFilter(112, 110) + MeshRenderer(113, 110)
            + Script(114, 110, MarkerScript,
                "  Target: {fileID: 101}\n  Numbers:\n  - 1.5\n  - 2.5\n  Packed: 0100000002000000\n")), Mast);
    }

    [TearDown]
    public void Delete() => _project.Dispose();

    [Test]
    public void Instance_AtTheRoot_IsTheWholePrefabWithItsInnerReferences()
    {
        GameObject root = _project.LoadScene(Scene(Instance(500, Mast), 500)).Single();
        Assert.That(root.name, Is.EqualTo("Mast"));
        Marker marker = root.transform.Find("Radar").GetComponent<Marker>();
        Assert.That(marker.Target, Is.SameAs(root.transform));
        Assert.That(marker.GetComponent<MeshFilter>().sharedMesh.name, Is.EqualTo("Cube"));
    }

    [Test]
    public void TwoInstances_OfOnePrefab_ShareNothing()
    {
        GameObject[] roots = _project.LoadScene(Scene(Instance(500, Mast)
            + Instance(501, Mast, modifications: "\n" + Change(100, Mast, "m_Name", "Other")), 501, 500));
        Assert.That(roots.Select(root => root.name), Is.EqualTo(new[] { "Other", "Mast" }));
        Assert.That(roots.Select(root => root.GetComponentInChildren<Marker>().Target),
            Is.EqualTo(roots.Select(root => root.transform)));
    }

    [Test]
    public void Override_OfPositionNameAndLayer_Counts()
    {
        string changes = "\n" + Change(101, Mast, "m_LocalPosition.y", "7.5") + Change(110, Mast, "m_Name", "Scanner")
            + Change(110, Mast, "m_Layer", "4")
            + Change(113, Mast, "m_Enabled", "0")
            + Change(112, Mast, "m_Mesh", "", "{fileID: 10210, guid: 0000000000000000e000000000000000, type: 0}");
        GameObject root = _project.LoadScene(Scene(Instance(500, Mast, modifications: changes), 500)).Single();
        GameObject scanner = root.transform.GetChild(0).gameObject;
        Assert.That((root.transform.localPosition.x, root.transform.localPosition.y), Is.EqualTo((0f, 7.5f)));
        Assert.That((scanner.name, scanner.layer), Is.EqualTo(("Scanner", 4)));
        Assert.That(scanner.GetComponent<MeshRenderer>().enabled, Is.False);
        Assert.That(scanner.GetComponent<MeshFilter>().sharedMesh.name, Is.EqualTo("Quad"));
    }

    [Test]
    public void Override_OfArrays_ChangesSizeAndElements()
    {
        string changes = "\n"
            + Change(114, Mast, "Numbers.Array.size", "3") + Change(114, Mast, "Numbers.Array.data[0]", "9")
            + Change(114, Mast, "Packed.Array.size", "4") + Change(114, Mast, "Packed.Array.data[3]", "-7")
            + Change(114, Mast, "Parts.Array.size", "2") + Change(114, Mast, "Parts.Array.data[1].Length", "12")
            + Change(114, Mast, "Parts.Array.data[1].Label", "hull");
        Marker marker = _project.LoadScene(Scene(Instance(500, Mast, modifications: changes), 500)).Single()
            .GetComponentInChildren<Marker>();
        Assert.That(marker.Numbers, Is.EqualTo(new[] { 9f, 2.5f, 2.5f }));
        Assert.That(marker.Packed, Is.EqualTo(new[] { 1, 2, 2, -7 }));
        Assert.That(marker.Parts.Select(part => (part.Length, part.Label)),
            Is.EqualTo(new[] { (0f, ""), (12f, "hull") }));
    }

    [Test]
    public void Override_OfAnObjectThatThePrefabLost_IsDropped()
    {
        GameObject root = _project.LoadScene(
            Scene(Instance(500, Mast, modifications: "\n" + Change(999, Mast, "m_Name", "Ghost")), 500)).Single();
        Assert.That(root.name, Is.EqualTo("Mast"));
    }

    [Test]
    public void StandIn_ReferredToFromTheScene_IsTheInstancesObject()
    {
        string scene = Object(10, "Deck", children: [600]) + Object(20, "Lamp", father: 601)
            + Instance(500, Mast, father: 11) + StandIn(4, 600, 101, Mast, 500) + StandIn(4, 601, 111, Mast, 500);
        GameObject deck = _project.LoadScene(Scene(scene, 11)).Single();
        Assert.That(deck.transform.GetChild(0).name, Is.EqualTo("Mast"));
        Assert.That(deck.transform.Find("Mast/Radar/Lamp"), Is.Not.Null);
    }

    [Test]
    public void RemovedComponent_AndRemovedObject_AreGone()
    {
        string removed = $"\n    - {Asset(114, Mast)}\n";
        GameObject without = _project.LoadScene(Scene(Instance(500, Mast, removedComponents: removed), 500)).Single();
        Assert.That(without.GetComponentInChildren<Marker>(), Is.Null);
        Assert.That(without.GetComponentInChildren<MeshFilter>(), Is.Not.Null);

        string gone = $"\n    - {Asset(110, Mast)}\n";
        GameObject bare = _project.LoadScene(Scene(Instance(500, Mast, removedObjects: gone), 500)).Single();
        Assert.That(bare.transform.childCount, Is.Zero);
    }

    [Test]
    public void AddedComponentAndObject_GoToTheirPlaces()
    {
        string scene = StandIn(1, 601, 110, Mast, 500) + StandIn(4, 602, 101, Mast, 500)
            + Script(30, 601, MarkerScript, "  Numbers:\n  - 4\n") + Object(20, "Flag", father: 602)
            + Instance(500, Mast, addedObjects: "\n" + Added(101, Mast, 21, 0),
                addedComponents: "\n" + Added(110, Mast, 30));
        GameObject root = _project.LoadScene(Scene(scene, 500)).Single();
        Assert.That(root.transform.Cast<Transform>().Select(child => child.name),
            Is.EqualTo(new[] { "Flag", "Radar" }));
        Assert.That(root.transform.Find("Radar").GetComponents<Marker>().Last().Numbers, Is.EqualTo(new[] { 4f }));
    }

    [Test]
    public void NestedPrefab_FromOutside_IsNamedByTheExclusiveOr()
    {
        // The ship holds the mast as instance 700; from the scene the mast's radar is 700 XOR 110 of the ship.
        _project.Write("Assets/Ship.prefab", Prefab(Object(10, "Ship", children: [700 ^ 101])
            + Instance(700, Mast, father: 11) + StandIn(4, 700 ^ 101, 101, Mast, 700)), Ship);
        string scene = Instance(500, Ship, modifications: "\n"
            + Change(700 ^ 110, Ship, "m_Name", "Scanner") + Change(700 ^ 101, Ship, "m_LocalPosition.z", "3"));
        GameObject ship = _project.LoadScene(Scene(scene, 500)).Single();
        Assert.That(ship.transform.Find("Mast/Scanner"), Is.Not.Null);
        Assert.That((ship.transform.GetChild(0).localPosition.y, ship.transform.GetChild(0).localPosition.z),
            Is.EqualTo((5f, 3f)));
        Assert.That(ship.GetComponentInChildren<Marker>().Target.name, Is.EqualTo("Mast"));
    }

    [Test]
    public void Variant_OfAPrefab_IsItsBaseWithTheVariantsOverrides()
    {
        _project.Write("Assets/Tall Mast.prefab", Prefab(Instance(800, Mast, modifications: "\n"
            + Change(101, Mast, "m_LocalPosition.y", "20") + Change(100, Mast, "m_Name", "Tall Mast"))), Variant);
        string scene = Instance(500, Variant, modifications: "\n" + Change(800 ^ 100, Variant, "m_Name", "Mine"))
            + Instance(501, Variant);
        GameObject[] roots = _project.LoadScene(Scene(scene, 500, 501));
        Assert.That(roots.Select(root => (root.name, root.transform.localPosition.y)),
            Is.EqualTo(new[] { ("Mine", 20f), ("Tall Mast", 20f) }));
    }

    [Test]
    public void PrefabAsset_LoadedTwice_IsOneSleepingObject()
    {
        Object first = _project.Project.LoadAsset("Assets/Mast.prefab", typeof(GameObject));
        Assert.That(_project.Project.LoadAsset("Assets/Mast.prefab", typeof(GameObject)), Is.SameAs(first));
        Assert.That(((GameObject)first).scene.IsValid(), Is.False);
        Assert.That(((GameObject)first).activeInHierarchy, Is.False);
    }

    [Test]
    public void Prefab_ThatHoldsItself_IsRefusedWithTheRing()
    {
        _project.Write("Assets/A.prefab", Prefab(Object(10, "A") + Instance(700, 5, father: 11)), 4);
        _project.Write("Assets/B.prefab", Prefab(Object(10, "B") + Instance(700, 4, father: 11)), 5);
        GlintException error = Assert.Throws<GlintException>(() => _project.LoadScene(Scene(Instance(500, 4), 500)));
        Assert.That(error.Message, Is.EqualTo("Assets/A.prefab: the prefab holds itself: "
            + "Assets/A.prefab -> Assets/B.prefab -> Assets/A.prefab: remove one of these instances"));
    }

    [Test]
    public void Prefab_Damaged_IsRefusedByItsOwnFileAndIds()
    {
        _project.Write("Assets/Bad.prefab", Prefab(Object(10, "Bad", components: Component(99))), 4);
        Assert.That(Assert.Throws<GlintException>(() => _project.LoadScene(Scene(Instance(500, 4), 500))).Message,
            Is.EqualTo("Assets/Bad.prefab: GameObject 'Bad' has a component &99, "
                + "which is not in the file: restore the file"));
    }

    [Test]
    public void Prefab_NotInTheProject_IsRefusedByItsGuid()
    {
        GlintException error = Assert.Throws<GlintException>(() => _project.LoadScene(Scene(Instance(500, 77), 500)));
        Assert.That(error.Message, Does.StartWith("Assets/Scene.unity: "
            + "PrefabInstance &500 refers to the prefab with guid " + TemporaryProject.Guid(77)));
    }
}
