using System;
using System.IO;
using System.Linq;
using System.Runtime.CompilerServices;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace Glint.Host.Tests;

/// <summary>The project's own scene, as the loader hands it to the product.</summary>
public sealed class CornerReflectorTests
{
    IAssetSource _before;
    GameObject[] _roots;

    [SetUp]
    public void Load()
    {
        _before = Engine.Assets;
        Engine.Reset(); // whatever tests before have left open
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
        Assert.That(_roots.Select(root => root.name), Is.EqualTo(new[] { "Radar Camera", "Directional Light", "Sweep", "Corner Reflector" }));

    [Test]
    public void Radar_StandsAsTheExperimentSays()
    {
        Transform radar = _roots[0].transform;
        double pitch = 10 * Math.PI / 180;
        Assert.That(radar.position.y, Is.EqualTo(41.08 * Math.Sin(pitch)).Within(1e-5));
        Assert.That(radar.position.z, Is.EqualTo(-41.08 * Math.Cos(pitch)).Within(1e-5));
        Assert.That(radar.forward.y, Is.EqualTo(-Math.Sin(pitch)).Within(1e-6));
        Assert.That(radar.GetComponent<Camera>().fieldOfView, Is.EqualTo(60f));

        RadarController controller = radar.GetComponent<RadarController>();
        Assert.That((controller.Settings.FrequencyHz, controller.Settings.RaysAcross, controller.Settings.RaysDown, controller.Settings.MaxBounces), Is.EqualTo((10e9, 1920, 1080, 4)));
        Assert.That(controller.Receiver, Is.SameAs(radar.Find("Receiver")));
        Assert.That((controller.ReceiverSize.x, controller.ReceiverSize.y, controller.Layers.value), Is.EqualTo((3f, 3f, -1)));
        Assert.That(controller.Kernel.name, Is.EqualTo("Trace"));
    }

    [Test]
    public void Reflector_VertexAndAxes_AreTheRecoveredGeometry()
    {
        // The inner corner, 8 m from the turning point along each axis of the object, at world (0, 3.349, 13.446).
        Transform frame = _roots[3].transform.Find("Frame");
        Vector3 vertex = frame.TransformPoint(new Vector3(-8f, -8f, -8f));
        Assert.That(vertex.x, Is.EqualTo(0f).Within(1e-4));
        Assert.That(vertex.y, Is.EqualTo(3.349f).Within(1e-3));
        Assert.That(vertex.z, Is.EqualTo(13.446f).Within(1e-3));
        Assert.That(frame.Cast<Transform>().Select(plate => plate.name), Is.EqualTo(new[] { "Plate X", "Plate Y", "Plate Z" }));
        foreach (Transform plate in frame)
        {
            Assert.That(plate.GetComponent<MeshFilter>().sharedMesh.GetIndices(0), Has.Length.EqualTo(36));
            Assert.That(plate.GetComponent<MeshRenderer>().enabled);
        }
    }

    [Test]
    public void Gatherer_FindsTheTrianglesOfThreeCubes() =>
        Assert.That(_roots[0].GetComponent<RadarController>().GatherScene().TriangleCount, Is.EqualTo(3 * 12));

    static string ThisFolder([CallerFilePath] string file = null) => Path.GetDirectoryName(file);
}
