using Glint.Core;
using Glint.Host.Tests.Vulkan;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Host.Tests;

/// <summary>The lines that Ray Paths gives to a camera.</summary>
public sealed class RayPathsTests
{
    [Test]
    public void Camera_OfTheSceneOrTheGame_IsGivenTheLinesWhereTheyStand()
    {
        GameObject wall = GameObject.CreatePrimitive(PrimitiveType.Quad), holder = new("Radar", typeof(Camera));
        wall.transform.position = new Vector3(0f, 0f, 10f);
        var radar = holder.AddComponent<RadarController>();
        radar.Kernel =
            UnityEditor.AssetDatabase.LoadAssetAtPath<ComputeShader>("Packages/com.glint.radar/Shaders/Trace.compute");
        var receiver = radar.Receiver = new GameObject("Receiver").transform;
        receiver.position = new Vector3(0f, 0f, -1f);
        radar.Settings = RadarSettings.Default with { RaysAcross = 64, RaysDown = 36 };
        radar.Roots.Add(wall.transform);
        radar.Roots.Add(receiver);
        var paths = holder.AddComponent<RayPaths>();
        var camera = holder.GetComponent<Camera>();

        var before = Graphics.LastDrawn;
        Camera.onPreCull(camera);
        Assert.That(Graphics.LastDrawn, Is.EqualTo(before), "nothing is traced yet");
        radar.Trace();
        camera.cameraType = CameraType.Preview;
        Camera.onPreCull(camera);
        Assert.That(Graphics.LastDrawn, Is.EqualTo(before), "a preview");
        camera.cameraType = CameraType.SceneView;
        Camera.onPreCull(camera);
        var drawn = Graphics.LastDrawn.Value;
        Assert.That((drawn.Mesh, drawn.Parameters.camera), Is.EqualTo((paths.Lines(), camera)));
        // From the receiver at -1 m to the wall at 10 m.
        Assert.That(drawn.Parameters.worldBounds.center.z, Is.EqualTo(4.5f).Within(1e-4));
        Assert.That(drawn.Place.MultiplyPoint3x4(drawn.Mesh.bounds.max).z, Is.EqualTo(10f).Within(1e-4));

        // The scene changes, but the lines remain those of the pose.
        radar.Trace();
        int shown = paths.Lines().vertexCount;
        wall.SetActive(false);
        radar.Release();
        Camera.onPreCull(camera);
        Assert.That(Graphics.LastDrawn.Value.Mesh.vertexCount, Is.EqualTo(shown).And.GreaterThan(8));
        wall.SetActive(true);

        // A pose is updated immediately if the lines were visible before, otherwise when a camera shows them again.
        radar.Trace();
        int seen = paths.Count;
        wall.SetActive(false);
        radar.Trace();
        Assert.That(paths.Count, Is.EqualTo(seen).And.GreaterThan(0), "no camera shows them");
        Camera.onPreCull(camera);
        Assert.That(paths.Count, Is.Zero);
        wall.SetActive(true);
        radar.Trace();
        Assert.That(paths.Count, Is.EqualTo(seen), "before the scene changes");

        using (var log = new LogCapture())
        {
            radar.Receiver = null;
            paths.Every = 2;
            Camera.onPreCull(camera);
            Camera.onPreCull(camera);
            Assert.That(log.Messages,
                Is.EqualTo(new[] { (LogType.Warning, "Ray Paths of 'Radar': RadarController of 'Radar' has no "
                    + "receiver: assign a Transform behind the camera to its field Receiver") }), "said once");
        }
        paths.enabled = false;
        Assert.That(Camera.onPreCull, Is.Null);
        Object.DestroyImmediate(wall);
        Object.DestroyImmediate(holder);
        Object.DestroyImmediate(receiver.gameObject);
    }

    // Unity leaves out what has its bounds outside the view. A wall turned by 45 degrees sends all rays to one side.
    [Test]
    public void Bounds_OfRaysThatLeaveToOneSide_ContainEveryLine()
    {
        GameObject wall = GameObject.CreatePrimitive(PrimitiveType.Quad), holder = new("Radar", typeof(Camera));
        wall.transform.position = new Vector3(0f, 0f, 10f);
        wall.transform.rotation = Quaternion.Euler(0f, 45f, 0f);
        var radar = holder.AddComponent<RadarController>();
        radar.Kernel =
            UnityEditor.AssetDatabase.LoadAssetAtPath<ComputeShader>("Packages/com.glint.radar/Shaders/Trace.compute");
        radar.Receiver = new GameObject("Receiver").transform;
        radar.Receiver.SetParent(holder.transform, false);
        radar.Receiver.localPosition = new Vector3(0f, 0f, -0.2f);
        radar.Settings = RadarSettings.Default with { RaysAcross = 64, RaysDown = 36 };
        radar.Roots.Add(wall.transform);
        var paths = holder.AddComponent<RayPaths>();
        paths.ReceivedOnly = false;
        radar.Trace();
        var camera = holder.GetComponent<Camera>();
        camera.cameraType = CameraType.SceneView;
        Camera.onPreCull(camera);
        var drawn = Graphics.LastDrawn.Value;
        Bounds bounds = drawn.Parameters.worldBounds;
        bounds.Expand(1e-4f); // rounding
        Assert.That(drawn.Mesh.vertexCount, Is.GreaterThan(8));
        foreach (Vector3 corner in drawn.Mesh.vertices)
            Assert.That(bounds.Contains(drawn.Place.MultiplyPoint3x4(corner)), Is.True, $"{corner}");
        radar.Release();
        Object.DestroyImmediate(holder);
        Object.DestroyImmediate(wall);
    }
}
