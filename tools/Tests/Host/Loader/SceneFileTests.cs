using System.Linq;
using Glint.Core;
using NUnit.Framework;
using UnityEngine;
using static Glint.Host.Tests.UnityText;

namespace Glint.Host.Tests;

public sealed class SceneFileTests
{
    TemporaryProject _project;

    [SetUp]
    public void Create() => _project = new TemporaryProject();

    [TearDown]
    public void Delete() => _project.Dispose();

    [Test]
    public void Roots_ListedInSceneRoots_ComeInThatOrder()
    {
        GameObject[] roots = _project.LoadScene(Scene(Object(10, "A") + Object(20, "B") + Object(30, "C"), 31, 11, 21));
        Assert.That(roots.Select(root => root.name), Is.EqualTo(new[] { "C", "A", "B" }));
    }

    [Test]
    public void Children_ListedByTheParent_ComeInThatOrder()
    {
        GameObject root = _project.LoadScene(Scene(
            Object(10, "Root", children: [31, 21]) + Object(20, "First", father: 11)
                + Object(30, "Second", father: 11), 11)).Single();
        Assert.That(root.transform.Cast<Transform>().Select(child => child.name),
            Is.EqualTo(new[] { "Second", "First" }));
    }

    [Test]
    public void Transform_PositionRotationScale_AreTheFiles()
    {
        string text = Object(10, "A", position: "{x: 1, y: -2.5, z: 1e-07}")
            .Replace("{x: 0, y: 0, z: 0, w: 1}", "{x: 0, y: 0.6, z: 0, w: 0.8}")
            .Replace("m_LocalScale: {x: 1, y: 1, z: 1}", "m_LocalScale: {x: 2, y: -3, z: 4}");
        Transform transform = _project.LoadScene(Scene(text, 11)).Single().transform;
        Assert.That((transform.localPosition.x, transform.localPosition.y, transform.localPosition.z),
            Is.EqualTo((1f, -2.5f, 1e-07f)));
        Assert.That((transform.localRotation.y, transform.localRotation.w), Is.EqualTo((0.6f, 0.8f)).Within(1e-6f));
        Assert.That((transform.localScale.x, transform.localScale.y, transform.localScale.z),
            Is.EqualTo((2f, -3f, 4f)));
    }

    [Test]
    public void GameObject_LayerTagAndActiveFlag_AreTheFiles()
    {
        _project.Write("ProjectSettings/TagManager.asset", Header + "--- !u!78 &1\nTagManager:\n  serializedVersion: "
            + "2\n  tags:\n  - Buoy\n  layers:\n  - Default\n  - \n  - \n  - \n  - \n  - \n  - \n  - \n  - Sea\n");
        string text = Object(10, "A").Replace("m_Layer: 0", "m_Layer: 8").Replace("Untagged", "Buoy")
            .Replace("m_IsActive: 1", "m_IsActive: 0");
        GameObject item = _project.LoadScene(Scene(text, 11)).Single();
        Assert.That(item.activeSelf, Is.False);
        Assert.That(LayerMask.LayerToName(item.layer), Is.EqualTo("Sea"));
        Assert.That(item.CompareTag("Buoy"));
    }

    [Test]
    public void Camera_FieldOfViewAndProjection_AreTheFiles()
    {
        string camera = "--- !u!20 &12\nCamera:\n  m_GameObject: {fileID: 10}\n  m_Enabled: 0\n  near clip plane: 0.5\n"
            + "  far clip plane: 2000\n  field of view: 47.5\n  orthographic: 1\n  m_CullingMask:\n"
            + "    serializedVersion: 2\n    m_Bits: 4294967295\n";
        Camera loaded = _project.LoadScene(Scene(Object(10, "Eye", components: Component(12)) + camera, 11))
            .Single().GetComponent<Camera>();
        Assert.That((loaded.fieldOfView, loaded.nearClipPlane, loaded.farClipPlane, loaded.orthographic,
            loaded.enabled, loaded.cullingMask),
            Is.EqualTo((47.5f, 0.5f, 2000f, true, false, -1)));
    }

    [Test]
    public void Renderer_DisabledWithBuiltInMaterial_IsSo()
    {
        string renderer = MeshRenderer(13, 10,
            "  m_Enabled: 0\n  m_Materials:\n  - {fileID: 10303, guid: 0000000000000000f000000000000000, type: 0}\n");
        GameObject item = _project.LoadScene(
            Scene(Object(10, "Box", components: Component(12, 13)) + MeshFilter(12, 10) + renderer, 11)).Single();
        Assert.That(item.GetComponent<MeshRenderer>().enabled, Is.False);
        Assert.That(item.GetComponent<MeshRenderer>().sharedMaterial.name, Is.EqualTo("Default-Material"));
        Assert.That(item.GetComponent<MeshFilter>().sharedMesh.name, Is.EqualTo("Cube"));
        Assert.That(_project.Warnings, Is.Empty);
    }

    [Test]
    public void Renderer_PartOfAStaticBatch_SaysSo()
    {
        string renderer =
            MeshRenderer(13, 10, "  m_Enabled: 1\n  m_StaticBatchInfo:\n    firstSubMesh: 0\n    subMeshCount: 1\n");
        Assert.That(_project.LoadScene(Scene(Object(10, "Box", components: Component(13)) + renderer, 11)).Single()
            .GetComponent<MeshRenderer>().isPartOfStaticBatch);
    }

    [Test]
    public void LodGroup_TwoLevels_HoldsTheirRenderers()
    {
        string group = "--- !u!205 &12\nLODGroup:\n  m_GameObject: {fileID: 10}\n  serializedVersion: 2\n  m_LODs:\n"
            + "  - screenRelativeHeight: 0.5\n    fadeTransitionWidth: 0\n    renderers:\n"
            + "    - renderer: {fileID: 22}\n  - screenRelativeHeight: 0.1\n    fadeTransitionWidth: 0\n"
            + "    renderers:\n    - renderer: {fileID: 32}\n  m_Enabled: 1\n";
        GameObject root = _project.LoadScene(Scene(
            Object(10, "Ship", children: [21, 31], components: Component(12)) + group
            + Object(20, "Fine", father: 11, components: Component(22)) + MeshRenderer(22, 20)
            + Object(30, "Coarse", father: 11, components: Component(32)) + MeshRenderer(32, 30), 11)).Single();
        LOD[] levels = root.GetComponent<LODGroup>().GetLODs();
        Assert.That(levels.Select(level => level.renderers.Single().name), Is.EqualTo(new[] { "Fine", "Coarse" }));
    }

    [Test]
    public void Component_OfUnknownClass_IsSkippedQuietly()
    {
        string light = "--- !u!108 &12\nLight:\n  m_GameObject: {fileID: 10}\n  m_Intensity: 1\n";
        GameObject item = _project.LoadScene(Scene(Object(10, "Sun", components: Component(12)) + light, 11)).Single();
        Assert.That(item.GetComponents<Component>(), Has.Length.EqualTo(1));
        Assert.That(_project.Warnings, Is.Empty);
    }

    [Test]
    public void SceneOfBuildSettings_DisabledOne_IsLeftOut()
    {
        _project.Write("ProjectSettings/EditorBuildSettings.asset", Header + "--- !u!1045 &1\nEditorBuildSettings:\n"
            + "  m_Scenes:\n  - enabled: 0\n    path: Assets/Old.unity\n  - enabled: 1\n    path: Assets/New.unity\n");
        _ = _project.Project;
        Assert.That(SceneLoads.BuildScenes, Is.EqualTo(new[] { "Assets/New.unity" }));
    }

    [Test]
    public void SceneBeforeSceneRoots_WithRootOrder_IsOrderedByIt()
    {
        string Rooted(long id, string name, int order) => Object(id, name) + $"  m_RootOrder: {order}\n";
        GameObject[] roots = _project.LoadScene(Header + Rooted(10, "Last", 1) + Rooted(20, "First", 0));
        Assert.That(roots.Select(root => root.name), Is.EqualTo(new[] { "First", "Last" }));
    }

    [Test]
    public void WindowsLineEnds_InAScene_AreRead()
    {
        GameObject item = _project.LoadScene(Scene(Object(10, "Box", components: Component(12)) + MeshFilter(12, 10),
            11).Replace("\n", "\r\n")).Single();
        Assert.That(item.name, Is.EqualTo("Box"));
        Assert.That(item.GetComponent<MeshFilter>().sharedMesh, Is.Not.Null);
    }

    [Test]
    public void Scene_NotThere_IsRefusedWithThoseThatAre()
    {
        _project.Write("Assets/Sea.unity", Scene(""), 7);
        GlintException error = Assert.Throws<GlintException>(() => _project.Load("Assets/See.unity"));
        Assert.That(error.Message, Is.EqualTo("Assets/See.unity: no such scene: the project has Assets/Sea.unity"));
    }

    [Test]
    public void Scene_OfALocalPackage_IsFoundByItsAssetPath()
    {
        _project.Write("Packages/manifest.json", """{ "dependencies": { "com.example.scenes": "file:../Scenes" } }""");
        _project.Write("Scenes/package.json", """{ "name": "com.example.scenes", "version": "1.0.0" }""");
        _project.Write("Scenes/Harbour.unity", Scene(Object(10, "Quay"), 11), 7);
        Assert.That(_project.Load("Packages/com.example.scenes/Harbour.unity").Single().name, Is.EqualTo("Quay"));
        Assert.That(_project.Project.GuidToPath(TemporaryProject.Guid(7)),
            Is.EqualTo("Packages/com.example.scenes/Harbour.unity"));
        Assert.That(_project.Project.PathToGuid("Packages/com.example.scenes/Harbour.unity"),
            Is.EqualTo(TemporaryProject.Guid(7)));
    }
}
