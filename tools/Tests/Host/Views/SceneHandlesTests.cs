using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Glint.Editor.Views;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Glint.Host.Tests;

/// <summary>Dragged handles in Scene view change the settings, and Undo restores them.</summary>
public sealed class SceneHandlesTests
{
    readonly List<(Vector3 Position, Vector3 Direction)> _handles = new();
    RadarController _radar;
    Sweep _sweep;
    int _dragged;
    float _by;

    [SetUp]
    public void MakeRadar()
    {
        _radar = new GameObject("Radar", typeof(Camera)).AddComponent<RadarController>();
        _radar.transform.SetPositionAndRotation(new Vector3(3, 4, -20), Quaternion.Euler(8, 25, 0));
        _radar.Receiver = MeshFileScene.MakeReceiver(_radar.transform, false);
        _radar.ReceiverSize = new Vector2(3, 2);
        _radar.Settings = new RadarSettings { FrequencyHz = 10e9, RaysAcross = 200, RaysDown = 100, MaxBounces = 4 };
        _sweep = new GameObject("Sweep").AddComponent<Sweep>();
        (_sweep.Target, _sweep.Angles) = (new GameObject("Target").transform, "0:45:5");
        EditorHooks.Slide = (position, direction) =>
        {
            _handles.Add((position, direction));
            return _handles.Count - 1 == _dragged ? position + _by * direction : position;
        };
        _handles.Clear();
        Drag(-1, 0);
    }

    [TearDown]
    public void Remove()
    {
        EditorHooks.Slide = (position, _) => position;
        foreach (GameObject made in new[] { _radar.gameObject, _sweep.Target.gameObject, _sweep.gameObject })
            Object.DestroyImmediate(made);
    }

    [Test]
    public void Handles_ThatNobodyDrags_ChangeNothing()
    {
        SceneHandles.Draw(_radar);
        SceneHandles.Draw(_sweep);
        Assert.That(_handles, Has.Count.EqualTo(8));
        Assert.That((_radar.Settings.Region.IsWhole, _radar.ReceiverSize.x, _sweep.Angles),
            Is.EqualTo((true, 3f, "0:45:5")));
    }

    // Both edges move: the receiver keeps its centre.
    [TestCase(0, 3, 3)]
    [TestCase(1, 4, 2)]
    public void Receiver_EdgeDraggedByHalfAMetre_IsAMetreLarger(int handle, float width, float height)
    {
        Drag(handle, 0.5f);
        SceneHandles.Draw(_radar);
        // float32 at coordinates of 20 m
        Assert.That(_radar.ReceiverSize.x, Is.EqualTo(width).Within(1e-5));
        Assert.That(_radar.ReceiverSize.y, Is.EqualTo(height).Within(1e-5));
        Undo.PerformUndo();
        Assert.That((_radar.ReceiverSize.x, _radar.ReceiverSize.y), Is.EqualTo((3f, 2f)));
    }

    [Test]
    public void Aperture_TopDraggedByAMetre_IsTwoMetresHigher()
    {
        var camera = _radar.GetComponent<Camera>();
        (camera.orthographic, camera.orthographicSize, _radar.ReceiverSize) = (true, 5, Vector2.zero);
        Drag(0, 1);
        SceneHandles.Draw(_radar);
        Assert.That(camera.orthographicSize, Is.EqualTo(6).Within(1e-5));
    }

    [Test]
    public void Receiver_WithoutSizeAtAPerspectiveCamera_IsEnlarged()
    {
        _radar.ReceiverSize = Vector2.zero;
        float size = _radar.GetComponent<Camera>().orthographicSize;
        Drag(0, 0.5f);
        SceneHandles.Draw(_radar);
        Assert.That(_radar.ReceiverSize.y, Is.EqualTo(1).Within(1e-5));
        Assert.That(_radar.GetComponent<Camera>().orthographicSize, Is.EqualTo(size));
    }

    // The handles of a whole picture are at its edges: left, right, bottom and top.
    [TestCase(0, 0.25f, 50, 0, 150, 100)]
    [TestCase(1, -0.5f, 0, 0, 100, 100)]
    [TestCase(2, 0.1f, 0, 10, 200, 90)]
    [TestCase(3, -0.9f, 0, 0, 200, 10)]
    [TestCase(1, -5, 0, 0, 1, 100)]
    public void Region_EdgeDraggedByAPartOfThePicture_IsThatSmaller(int edge, float part, int left, int bottom,
        int width, int height)
    {
        SceneHandles.Draw(_radar);
        var edges = _handles.Skip(2).ToArray();
        _handles.Clear();
        float size = Vector3.Distance(edges[edge < 2 ? 0 : 2].Position, edges[edge < 2 ? 1 : 3].Position);
        Drag(2 + edge, part * size);
        SceneHandles.Draw(_radar);
        RayRegion region = _radar.Settings.Region;
        Assert.That((region.Left, region.Bottom, region.Width, region.Height),
            Is.EqualTo((left, bottom, width, height)));
        Undo.PerformUndo();
        Assert.That(_radar.Settings.Region.IsWhole);
    }

    // The camera's own rays through the edge of its picture.
    [Test]
    public void Region_HandlesOfTheWholePicture_AreOnTheRimOfTheCameras()
    {
        var camera = _radar.GetComponent<Camera>();
        SceneHandles.Draw(_radar);
        Vector3 top = _handles[5].Position - _radar.transform.position,
            bottom = _handles[4].Position - _radar.transform.position;
        Assert.That(Vector3.Angle(top, _radar.transform.forward), Is.EqualTo(camera.fieldOfView / 2).Within(1e-3));
        Assert.That(Vector3.Angle(top, bottom), Is.EqualTo(camera.fieldOfView).Within(1e-3));
    }

    // The tangent of 10 degrees on the arc, of radius 2 for handles of size 1.
    [TestCase(0, 0.3526540f, "10:45:5")]
    [TestCase(1, 0.3526540f, "0:55:5")]
    [TestCase(1, -100, "0:45:5", Description = "FROM is not above TO")]
    public void Angles_EndDragged_IsMovedInWholeSteps(int end, float by, string angles)
    {
        Drag(end, by);
        SceneHandles.Draw(_sweep);
        Assert.That(_sweep.Angles, Is.EqualTo(angles));
    }

    [Test]
    public void Angles_AsAList_HaveNoHandles()
    {
        _sweep.Angles = "0,5,20";
        SceneHandles.Draw(_sweep);
        Assert.That(_handles, Is.Empty);
    }

    void Drag(int handle, float by) => (_dragged, _by) = (handle, by);
}
