using System.IO;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEditor.SceneManagement;
using UnityEngine;

namespace Glint.Host.Tests;

/// <summary>What a component finds by itself when it is added in edit mode.</summary>
public sealed class ResetTests
{
    [SetUp]
    public void OpenAnEmptyScene() => EditorSceneManager.NewScene(NewSceneSetup.EmptyScene, NewSceneMode.Single);

    [Test]
    public void Radar_AddedToACameraWithAReceiver_TakesIt()
    {
        var camera = new GameObject("Camera").AddComponent<Camera>();
        new GameObject("Other").transform.SetParent(camera.transform, false);
        var receiver = new GameObject("Receiver").transform;
        receiver.SetParent(camera.transform, false);

        Assert.That(camera.gameObject.AddComponent<RadarController>().Receiver, Is.SameAs(receiver));
    }

    [Test]
    public void Radar_AddedToAnEmptyObject_GetsACameraAndNoReceiver()
    {
        new GameObject("Receiver");
        var radar = new GameObject("Radar").AddComponent<RadarController>();

        Assert.That(radar.GetComponent<Camera>(), Is.Not.Null);
        Assert.That(radar.Receiver == null, "a receiver of another radar is not taken");
    }

    // The host does not read default references; Unity assigns them when a component is added.
    [TestCase("RadarController", "Trace")]
    [TestCase("RadarCrossSection", "Tubes")]
    public void Script_HasItsKernelAmongItsDefaultReferences(string script, string file)
    {
        string package = Path.Combine(Project.FindRoot(System.AppContext.BaseDirectory), "Packages/com.glint.radar");
        string kernel = Regex.Match(File.ReadAllText(Path.Combine(package, $"Shaders/{file}.compute.meta")),
            @"\nguid: (\w+)\n").Groups[1].Value;
        Assert.That(File.ReadAllText(Path.Combine(package, $"Runtime/Components/{script}.cs.meta")),
            Does.Contain($"\n  - _kernel: {{fileID: 7200000, guid: {kernel}, type: 3}}\n"));
    }

    [Test]
    public void CrossSection_AddedToAnObjectWithAMesh_TakesIt()
    {
        var target = new GameObject("Target");
        GameObject.CreatePrimitive(PrimitiveType.Cube).transform.SetParent(target.transform, false);

        Assert.That(target.AddComponent<RadarCrossSection>().Target, Is.SameAs(target.transform));
        Assert.That(new GameObject("Other").AddComponent<RadarCrossSection>().Target == null);
    }

    [Test]
    public void Sweep_AddedBesideOneRadar_TakesItAndItsOnlyRoot()
    {
        var radar = new GameObject("Radar").AddComponent<RadarController>();
        var target = new GameObject("Target").transform;
        radar.Roots.Add(target);

        var sweep = new GameObject("Sweep").AddComponent<Sweep>();

        Assert.That(sweep.Radar, Is.SameAs(radar));
        Assert.That(sweep.Target, Is.SameAs(target));
    }

    [Test]
    public void Sweep_WhereRadarOrTargetAreNotClear_LeavesThemEmpty()
    {
        Assert.That(new GameObject("Sweep").AddComponent<Sweep>().Radar == null, "there is none");
        var radar = new GameObject("Radar").AddComponent<RadarController>();
        radar.Roots.Add(new GameObject("Target").transform);
        radar.Roots.Add(new GameObject("Sea").transform);
        Assert.That(new GameObject("Sweep").AddComponent<Sweep>().Target == null, "there are two roots");
        new GameObject("Radar").AddComponent<RadarController>();
        Assert.That(new GameObject("Sweep").AddComponent<Sweep>().Radar == null, "there are two radars");
    }
}
