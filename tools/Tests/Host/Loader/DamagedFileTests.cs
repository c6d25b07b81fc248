using System;
using System.IO;
using System.Linq;
using System.Text;
using Glint.Core;
using NUnit.Framework;
using UnityEngine;
using static Glint.Host.Tests.UnityText;

namespace Glint.Host.Tests;

public sealed class DamagedFileTests
{
    const int Mast = 1, Hull = 2, MarkerScript = 9;

    TemporaryProject _project;

    [SetUp]
    public void Create() => _project = new TemporaryProject();

    [TearDown]
    public void Delete() => _project.Dispose();

    [Test]
    public void Mesh_WithUnknownGuid_IsRefusedByObjectAndGuid() => AssertRefused(WithMesh(Asset(4300000, 77, 2)),
        $"Assets/Scene.unity: MeshFilter of 'Ship/Hull' refers to guid {TemporaryProject.Guid(77)}, which no .meta in "
            + "the project has: restore the file, or assign another mesh (an .asset or a built-in one)");

    [Test]
    public void Mesh_WhoseFileIsGone_IsRefusedByItsPath()
    {
        _project.Write("Assets/Hull.asset.meta", $"fileFormatVersion: 2\nguid: {TemporaryProject.Guid(Hull)}\n");
        AssertRefused(WithMesh(Asset(4300000, Hull, 2)),
            "Assets/Scene.unity: MeshFilter of 'Ship/Hull' refers to Assets/Hull.asset, of which only the .meta is "
                + "there: restore the file, or assign another mesh (an .asset or a built-in one)");
    }

    [Test]
    public void Mesh_WithUnknownFileId_IsRefusedByIt()
    {
        _project.Write("Assets/Hull.asset", MeshText.Of([0, 0, 0, 1, 0, 0, 0, 0, 1], 0, 1, 2).ToString(), Hull);
        AssertRefused(WithMesh(Asset(4300002, Hull, 2)),
            "Assets/Scene.unity: MeshFilter of 'Ship/Hull' refers to object &4300002 of Assets/Hull.asset, "
                + "which is not in it: restore the file, or assign another mesh (an .asset or a built-in one)");
    }

    [Test]
    public void Mesh_OfAModel_IsRefusedWithTheRemedy()
    {
        _project.Write("Assets/Ship.fbx", "", Hull);
        AssertRefused(WithMesh(Asset(4300000, Hull)),
            "Assets/Scene.unity: MeshFilter of 'Ship/Hull' refers to Assets/Ship.fbx, a model, which only Unity reads: "
                + "restore the file, or assign another mesh (an .asset or a built-in one)");
    }

    // Unity does not draw it, and a radar does not trace it.
    [TestCase("  m_IsActive: 1\n", "  m_IsActive: 0\n")]
    [TestCase("  m_Enabled: 1\n  m_Materials", "  m_Enabled: 0\n  m_Materials")]
    public void Mesh_MissingOfWhatIsNotShown_IsOnlyWarnedOf(string shown, string hidden)
    {
        string item = Object(10, "Hull", components: Component(12, 13)) + MeshFilter(12, 10, Asset(4300000, 77, 2))
            + MeshRenderer(13, 10);
        Assert.That(Refusal(Scene(item, 11)), Does.Contain("which no .meta in the project has"));
        Assert.That(item, Does.Contain(shown));
        var made = _project.LoadScene(Scene(item.Replace(shown, hidden), 11)).Single();
        Assert.That(made.GetComponent<MeshFilter>().sharedMesh == null);
        Assert.That(_project.Warnings.Single(), Does.Contain("which no .meta in the project has"));
    }

    // It is no empty field, which would be a perfect conductor.
    [Test]
    public void RadarMaterial_Missing_IsOneThatIsGone()
    {
        _project.WriteScript(typeof(RadarSurface), MarkerScript);
        var made = _project.LoadScene(Scene(Object(10, "Hull", components: Component(12))
            + Script(12, 10, MarkerScript, $"  _material: {Asset(11400000, 77, 2)}\n  _submesh: -1\n"), 11)).Single();
        var material = made.GetComponent<RadarSurface>().Material;
        Assert.That(material == null && !ReferenceEquals(material, null) && material.GetInstanceID() != 0);
        Assert.That(_project.Warnings.Single(), Does.Contain("_material refers to guid"));
    }

    [Test]
    public void Mesh_InTheSceneItself_IsRead()
    {
        string mesh = MeshText.Of([0, 0, 0, 1, 0, 0, 0, 0, 1], 0, 1, 2).ToString();
        mesh = mesh[mesh.IndexOf("--- ")..].Replace("&4300000", "&99");
        var made = _project.LoadScene(Scene(Object(10, "Hull", components: Component(12, 13))
            + MeshFilter(12, 10, "{fileID: 99}") + MeshRenderer(13, 10) + mesh, 11)).Single();
        Assert.That(made.GetComponent<MeshFilter>().sharedMesh.vertexCount, Is.EqualTo(3));
        Assert.That(_project.Warnings, Is.Empty);
    }

    [Test]
    public void Terrain_IsWarnedOf()
    {
        _project.LoadScene(Scene(Object(10, "Coast", components: Component(12))
            + "--- !u!218 &12\nTerrain:\n  m_GameObject: {fileID: 10}\n  m_Enabled: 1\n", 11));
        Assert.That(_project.Warnings.Single(), Is.EqualTo("Assets/Scene.unity: Terrain of 'Coast': terrains are not "
            + "traced: make a mesh of it to include it"));
    }

    [Test]
    public void Mesh_WithoutMeta_IsRefusedAsUnknownGuid()
    {
        _project.Write("Assets/Hull.asset", MeshText.Of([0, 0, 0, 1, 0, 0, 0, 0, 1], 0, 1, 2).ToString());
        Assert.That(Refusal(WithMesh(Asset(4300000, Hull, 2))), Does.Contain("which no .meta in the project has"));
    }

    [Test]
    public void Guid_OfTwoFiles_IsRefusedNamingBoth()
    {
        _project.Write("Assets/Hull.asset", "", Hull);
        _project.Write("Assets/Copy/Hull.asset", "", Hull);
        string message = Refusal(WithMesh(Asset(4300000, Hull, 2)));
        Assert.That(message, Does.Contain("Assets/Hull.asset").And.Contain("Assets/Copy/Hull.asset")
            .And.Contain(TemporaryProject.Guid(Hull)));
    }

    [Test]
    public void Guid_InFoldersThatUnityIgnores_IsNotSeen()
    {
        _project.Write("Assets/.hidden/Hull.asset", "", Hull);
        _project.Write("Assets/Old~/Hull.asset", "", Hull);
        Assert.That(_project.Project.GuidToPath(TemporaryProject.Guid(Hull)), Is.Null);
    }

    [Test]
    public void Material_Missing_IsOnlyWarnedOf()
    {
        string renderer = MeshRenderer(13, 10, $"  m_Enabled: 1\n  m_Materials:\n  - {Asset(2100000, 66, 2)}\n");
        GameObject item =
            _project.LoadScene(Scene(Object(10, "Box", components: Component(13)) + renderer, 11)).Single();
        Assert.That(item.GetComponent<MeshRenderer>().sharedMaterials, Is.EqualTo(new Material[] { null }));
        Assert.That(_project.Warnings.Single(), Does.StartWith("Assets/Scene.unity: MeshRenderer of 'Box': "
            + "m_Materials[0] refers to guid " + TemporaryProject.Guid(66)));
    }

    [Test]
    public void Warning_OfANameWithALineBreak_IsOneLine()
    {
        _project.LoadScene(
            Scene(Object(10, "\"a\\nb\\x1bc\"").Replace("m_TagString: Untagged", "m_TagString: Lost"), 11));
        Assert.That(_project.Warnings.Single(),
            Does.StartWith("Assets/Scene.unity: GameObject 'a b c': has the tag 'Lost'"));
    }

    [TestCase("", "Assets/Scene.unity: is empty, or a pipe or device instead of a file: restore the file")]
    [TestCase("version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n",
        "Assets/Scene.unity: is a git-lfs pointer, not the file's content: run 'git lfs pull'")]
    [TestCase("\0\0\0\u0016\0\0", "Assets/Scene.unity: is serialized as binary: "
        + "set Asset Serialization to Force Text (Edit, Project Settings, Editor) and save it again")]
    [TestCase("solid hull\n",
        "Assets/Scene.unity: is not a Unity YAML file, it does not begin with '%YAML 1.1': restore the file")]
    [TestCase(Header, "Assets/Scene.unity: holds no object: restore the file")]
    [TestCase(Header + "--- !u!1 10\nGameObject:\n",
        "Assets/Scene.unity:3: damaged: '--- !u!1 10' is not a header of the form '--- !u!CLASS &ID': restore the "
            + "file")]
    [TestCase(Header + "--- !u!1 &10\nGameObject:\n--- !u!1 &10\nGameObject:\n",
        "Assets/Scene.unity:5: damaged: a second object &10: restore the file")]
    [TestCase(Header + "--- !u!1 &10\n<<<<<<< HEAD\nGameObject:\n",
        "Assets/Scene.unity:4: has an unresolved merge conflict: resolve it")]
    public void File_NoScene_IsRefusedWithTheReason(string text, string message) => AssertRefused(text, message);

    [Test]
    public void Yaml_BrokenInOneObject_IsRefusedWithItsLine() => Assert.That(
        Refusal(Scene(Object(10, "A"), 11).Replace("m_Name: A", "m_Name: {")), Does.Match(
            @"^Assets/Scene\.unity:\d+: damaged YAML in object &10: .*: restore the file, or save it again in Unity$"));

    [Test]
    public void Yaml_NestedWithoutEnd_IsRefused() => Assert.That(
        Refusal(Scene(Object(10, "A"), 11).Replace("m_Name: A", "m_Name: " + new string('[', 100_000))),
        Does.Contain("nested more than 100 deep"));

    [Test]
    public void Yaml_OfAliases_IsRefused() => Assert.That(
        Refusal(Scene(Object(10, "A"), 11).Replace("m_Name: A", "a: &a [x, x]\n  b: &b [*a, *a]\n  m_Name: A")),
        Does.Contain("an anchor or alias"));

    [Test]
    public void Scene_CutBetweenObjects_IsRefused() => AssertRefused(
        Header + Object(10, "A") + Object(20, "B"),
        "Assets/Scene.unity: ends without SceneRoots, it has been cut short: restore the file");

    [Test]
    public void Parents_InARing_AreRefused() => Assert.That(
        Refusal(Scene(Object(10, "A", father: 21) + Object(20, "B", father: 11))), Does.Contain("is its own ancestor"));

    [Test]
    public void Component_NotInTheFile_IsRefused() => AssertRefused(
        Scene(Object(10, "A", components: Component(99)), 11),
        "Assets/Scene.unity: GameObject 'A' has a component &99, which is not in the file: restore the file");

    [Test]
    public void Project_WithoutManifest_IsRefused()
    {
        File.Delete(Path.Combine(_project.Root, "Packages/manifest.json"));
        Assert.Throws<GlintException>(() => _ = _project.Project);
    }

    // Every damaged file loads or is refused in one line: no other exception, no hang.
    [Test, MaxTime(120_000)]
    public void Scene_CutAnywhere_IsRefusedOrLoads()
    {
        byte[] whole = WriteWhole();
        System.Random random = new(1);
        for (int round = 0; round < 300; round++)
            AssertNoCrash(whole[..random.Next(whole.Length)], $"round {round}");
    }

    [Test, MaxTime(120_000)]
    public void Scene_WithFlippedBytes_IsRefusedOrLoads()
    {
        byte[] whole = WriteWhole();
        System.Random random = new(2);
        for (int round = 0; round < 300; round++)
        {
            byte[] damaged = (byte[])whole.Clone();
            for (int flips = random.Next(1, 8); flips > 0; flips--)
                damaged[random.Next(damaged.Length)] =
                    random.Next(3) == 0 ? (byte)random.Next(256) : (byte)" \n:{}[]-&!,'\"0123456789"[random.Next(23)];
            AssertNoCrash(damaged, $"round {round}");
        }
    }

    [Test, MaxTime(120_000)]
    public void Mesh_WithFlippedBytes_IsRefusedOrLoads()
    {
        byte[] whole = Encoding.UTF8.GetBytes(MeshText.Of([0, 0, 0, 1, 0, 0, 0, 0, 1], 0, 1, 2).ToString());
        System.Random random = new(3);
        for (int round = 0; round < 300; round++)
        {
            byte[] damaged = (byte[])whole.Clone();
            for (int flips = random.Next(1, 4); flips > 0; flips--)
                damaged[random.Next(damaged.Length)] = (byte)random.Next(32, 127);
            string path = $"Assets/Hull{round}.asset";
            _project.Write(path, "");
            File.WriteAllBytes(Path.Combine(_project.Root, path), damaged);
            AssertRefusedOrDone(() => _project.Project.LoadAsset(path, typeof(Mesh)), $"round {round}");
        }
    }

    byte[] WriteWhole()
    {
        _project.WriteScript(typeof(Marker), MarkerScript);
        _project.Write("Assets/Mast.prefab", Prefab(Object(100, "Mast", children: [111])
            + Object(110, "Radar", father: 101, components: Component(112)) + MeshFilter(112, 110)), Mast);
        string objects = Object(10, "Deck", children: [600, 21], components: Component(12, 13, 14))
            + MeshFilter(12, 10) + MeshRenderer(13, 10)
            + Script(14, 10, MarkerScript, "  Target: {fileID: 21}\n  Numbers:\n  - 1.5\n  Packed: 0100000002000000\n"
                + "  Main:\n    Length: 2\n    Label: a\n")
            + Object(20, "Rail", father: 11) + Instance(500, Mast, father: 11, modifications: "\n"
                + Change(101, Mast, "m_LocalPosition.y", "7.5") + Change(110, Mast, "m_Name", "Scanner"))
            + StandIn(4, 600, 101, Mast, 500);
        return Encoding.UTF8.GetBytes(Scene(objects, 11));
    }

    void AssertNoCrash(byte[] bytes, string round)
    {
        File.WriteAllBytes(Path.Combine(_project.Root, "Assets/Scene.unity"), bytes);
        AssertRefusedOrDone(() => _project.Load(), round);
        Engine.Reset();
    }

    static void AssertRefusedOrDone(Action load, string round)
    {
        try
        {
            load();
        }
        catch (GlintException refusal)
        {
            Assert.That(refusal.Message, Does.StartWith("Assets/").And.Not.Contain("\n"), round);
        }
        catch (Exception error)
        {
            Assert.Fail($"{round}: {error}");
        }
    }

    static string WithMesh(string mesh) => Scene(Object(10, "Ship", children: [21])
        + Object(20, "Hull", father: 11, components: Component(22, 23)) + MeshFilter(22, 20, mesh)
        + MeshRenderer(23, 20), 11);

    string Refusal(string scene) => Assert.Throws<GlintException>(() => _project.LoadScene(scene)).Message;

    void AssertRefused(string scene, string message) => Assert.That(Refusal(scene), Is.EqualTo(message));
}
