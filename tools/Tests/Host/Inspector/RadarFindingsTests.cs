using System.Linq;
using Glint.Editor;
using Glint.Tests;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;
using UnityEngine.Rendering;

namespace Glint.Host.Tests;

/// <summary>
/// Findings that a test in Unity cannot produce: static batches, imported models, other devices, a radar without its
/// required component.
/// </summary>
public sealed class RadarFindingsTests
{
    RadarController _radar;
    GameObject _plate;
    RadarCheck _check;

    [SetUp]
    public void MakeScene()
    {
        _plate = GameObject.CreatePrimitive(PrimitiveType.Quad);
        (_plate.name, _plate.transform.position, _plate.transform.localScale) =
            ("Plate", new Vector3(0, 0, 20), new Vector3(4, 4, 1));
        _radar = new GameObject("Radar", typeof(Camera)).AddComponent<RadarController>();
        _radar.Receiver = MeshFileScene.MakeReceiver(_radar.transform, false);
        _radar.Kernel = TestKernels.Trace;
        _radar.Roots.Add(_plate.transform);
        _check = new RadarCheck(_radar);
    }

    [TearDown]
    public void RemoveScene()
    {
        AssetImporter.Known.Clear();
        GraphicsDevice.Type = GraphicsDeviceType.Vulkan;
        Object.DestroyImmediate(_radar.gameObject);
        Object.DestroyImmediate(_plate);
    }

    [Test]
    public void Update_WithoutGraphicsDevice_SaysToLeaveOutNographics()
    {
        GraphicsDevice.Type = GraphicsDeviceType.Null;
        Assert.That(Findings(), Has.Some.StartsWith("Error: there is no graphics device"));
    }

    [Test]
    public void Update_OnOpenGLES_SaysToUseVulkan()
    {
        GraphicsDevice.Type = GraphicsDeviceType.OpenGLES3;
        Assert.That(Findings(), Has.Some.Contains("has no 'precise': use Vulkan"));
    }

    [Test]
    public void Fix_OfARadarWithoutACamera_AddsOneAndUndoTakesItAway()
    {
        var bare = ObjectFactory.NewGameObject("Bare", _radar.gameObject.scene);
        ObjectFactory.Attach(bare, typeof(Transform));
        var radar = (RadarController)ObjectFactory.Attach(bare, typeof(RadarController));
        bare.ActiveCached = true;
        (radar.Kernel, radar.Receiver) = (_radar.Kernel, _radar.Receiver);
        radar.Roots.Add(_plate.transform);
        _check = new RadarCheck(radar);

        Assert.That(Findings(), Is.EqualTo(new[] { "Error: " + radar.HasNoCamera }));
        _check.Findings[0].Fix.Apply();
        Assert.That(Findings(), Has.None.Contains("Camera"));
        Undo.PerformUndo();
        Assert.That(Findings(), Has.Exactly(1).Contains("Camera"));
        Object.DestroyImmediate(bare);
    }

    [Test]
    public void Update_StaticBatch_IsRefusedInTheGatherersWords()
    {
        _plate.GetComponent<MeshRenderer>().StaticBatched = true;
        Assert.That(Findings().Single(), Is.EqualTo("Error: 'Plate' is part of a static batch, "
            + "whose meshes Unity has merged: clear Batching Static among the static flags of 'Plate'"));
    }

    [Test]
    public void Fix_OfObjectsMarkedBatchingStatic_ClearsTheFlagAndUndoBringsItBack()
    {
        var other = Object.Instantiate(_plate, _plate.transform);
        _plate.isStatic = other.isStatic = true;
        Assert.That(Findings().Single(),
            Does.StartWith("Warning: 'Plate' is marked Batching Static").And.EndWith("(and 1 more)"));
        _check.Findings[0].Fix.Apply();
        Assert.That(Findings(), Is.Empty);
        Undo.PerformUndo();
        Assert.That(Findings(), Has.Exactly(1).Items);
    }

    [TestCase(null)]
    [TestCase("Assets/Hull.asset")]
    public void Fix_OfAMeshOfItsOwnThatIsNotReadable_SetsItsFieldAndUndoBringsItBack(string path)
    {
        MakeModel(path);
        AssetImporter.Known.Clear();
        Assert.That(Findings().Single(),
            Is.EqualTo("Error: mesh 'Hull' of 'Plate' is not readable: tick Read/Write in the mesh's import settings"));
        _check.Findings[0].Fix.Apply();
        Assert.That(Findings(), Is.Empty);
        Undo.PerformUndo();
        Assert.That(Findings(), Has.Exactly(1).Items);
    }

    [Test]
    public void Fix_OfAModelThatIsNotReadable_ImportsItAnew()
    {
        var importer = MakeModel("Assets/Hull.fbx");
        _check.Update();
        _check.Findings.Single().Fix.Apply();
        Assert.That(importer.isReadable);
        Assert.That(Findings(), Is.Empty);
    }

    [Test]
    public void Update_AnUnreadableMeshOfAnotherImporter_HasNoFix()
    {
        MakeModel("Assets/Hull.fbx");
        AssetImporter.Known.Clear();
        _check.Update();
        Assert.That(_check.Findings.Single().Fix, Is.Null);
    }

    string[] Findings()
    {
        _check.Update();
        return _check.Findings.Select(finding => finding.ToString()).ToArray();
    }

    ModelImporter MakeModel(string path)
    {
        var mesh = Object.Instantiate(_plate.GetComponent<MeshFilter>().sharedMesh);
        (mesh.name, mesh.AssetPath) = ("Hull", path);
        mesh.UploadMeshData(true);
        _plate.GetComponent<MeshFilter>().sharedMesh = mesh;
        var importer = new ModelImporter();
        importer.Meshes.Add(mesh);
        if (path is not null)
            AssetImporter.Known[path] = importer;
        return importer;
    }
}
