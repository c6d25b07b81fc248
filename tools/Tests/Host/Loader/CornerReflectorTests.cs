using System;
using System.IO;
using System.Linq;
using System.Runtime.CompilerServices;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace Glint.Host.Tests;

/// <summary>The project's own scene, as loaded for the product.</summary>
public sealed class CornerReflectorTests
{
    IAssetSource _before;
    GameObject[] _roots;

    [SetUp]
    public void Load()
    {
        _before = Engine.Assets;
        Engine.Reset(); // closes scenes that earlier tests left open
        Project.Open(Project.FindRoot(ThisFolder()));
        SceneData scene = SceneRegistry.AddFile("Packages/com.glint.scenes/CornerReflector.unity");
        SceneRegistry.Fill(scene);
        _roots = new Scene(scene).GetRootGameObjects();
    }

    [TearDown]
    public void Unload()
    {
        Engine.Reset();
        Engine.Assets = _before;
    }

    [Test]
    public void Roots_AreInTheScenesOrder() =>
        Assert.That(_roots.Select(root => root.name),
            Is.EqualTo(new[] { "Corner Reflector Radar", "Directional Light", "Sweep", "Corner Reflector" }));

    [Test]
    public void Radar_StandsAsTheExperimentSays()
    {
        Transform radar = _roots[0].transform.Find("Radar Camera");
        double elevation = 9.974 * Math.PI / 180;
        Assert.That(radar.position.y, Is.EqualTo(41.112 * Math.Sin(elevation)).Within(1e-5));
        Assert.That(radar.position.z, Is.EqualTo(-41.112 * Math.Cos(elevation)).Within(1e-5));
        Assert.That(radar.forward.y, Is.EqualTo(-Math.Sin(9.985 * Math.PI / 180)).Within(1e-6));
        Assert.That(radar.GetComponent<Camera>().fieldOfView, Is.EqualTo(60f));

        RadarController controller = radar.GetComponent<RadarController>();
        Assert.That((controller.Settings.FrequencyHz, controller.Settings.RaysAcross, controller.Settings.RaysDown,
            controller.Settings.MaxBounces), Is.EqualTo((10e9, 1920, 1080, 4)));
        Assert.That(controller.Receiver, Is.SameAs(radar.Find("Receiver")));
        Assert.That((controller.ReceiverSize.x, controller.ReceiverSize.y, controller.Layers.value),
            Is.EqualTo((3f, 3f, -1)));
        Assert.That(controller.Kernel.name, Is.EqualTo("Trace"));
    }

    [Test]
    public void Reflector_VertexAndAxes_AreTheRecoveredGeometry()
    {
        // The inner corner is the frame's origin: sqrt(2) 7.871 sin b - 8.052 cos b up,
        // sqrt(2) 7.871 cos b + 8.052 sin b back, b = 49.132 degrees.
        Transform frame = _roots[3].transform.Find("Frame");
        Vector3 vertex = frame.position;
        Assert.That(vertex.x, Is.EqualTo(0f).Within(1e-4));
        Assert.That(vertex.y, Is.EqualTo(3.1491f).Within(1e-4));
        Assert.That(vertex.z, Is.EqualTo(13.3725f).Within(1e-4));
        Assert.That(frame.Cast<Transform>().Select(plate => plate.name),
            Is.EqualTo(new[] { "Plate X", "Plate Y", "Plate Z" }));
        foreach (Transform plate in frame)
        {
            Assert.That(plate.GetComponent<MeshFilter>().sharedMesh.GetIndices(0), Has.Length.EqualTo(36));
            Assert.That(plate.GetComponent<MeshRenderer>().enabled);
        }
    }

    [Test]
    public void Gatherer_FindsTheTrianglesOfThreeCubes() =>
        Assert.That(_roots[0].GetComponentInChildren<RadarController>().Gather().Scene.TriangleCount,
            Is.EqualTo(3 * 12));

    static string ThisFolder([CallerFilePath] string file = null) => Path.GetDirectoryName(file);
}
