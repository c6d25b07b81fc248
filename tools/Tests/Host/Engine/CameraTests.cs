using System;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Host.Tests;

public sealed class CameraTests : EngineFixture
{
    const float Tolerance = 1e-4f;

    Camera _camera;

    [SetUp]
    public void PlaceCamera()
    {
        _camera = new GameObject("camera").AddComponent<Camera>();
        _camera.transform.SetPositionAndRotation(new Vector3(3f, 4f, -5f), Quaternion.Euler(10f, 30f, 0f));
        _camera.fieldOfView = 60f;
        _camera.aspect = 16f / 9f;
        _camera.nearClipPlane = 0.5f;
        _camera.farClipPlane = 200f;
    }

    [Test]
    public void WorldToCamera_LooksAlongNegativeZ()
    {
        Vector3 ahead = _camera.transform.TransformPoint(new Vector3(1f, 2f, 10f));
        AssertClose(_camera.worldToCameraMatrix.MultiplyPoint3x4(ahead), new Vector3(1f, 2f, -10f));
    }

    [Test]
    public void WorldToCamera_IgnoresTheScale()
    {
        Matrix4x4 before = _camera.worldToCameraMatrix;
        _camera.transform.localScale = new Vector3(2f, 3f, 4f);
        Assert.That(_camera.worldToCameraMatrix, Is.EqualTo(before));
    }

    [Test]
    public void ViewportCorner_Ray_LeavesAtHalfTheFieldOfView()
    {
        Ray top = _camera.ViewportPointToRay(new Vector3(0.5f, 1f, 0f));
        Ray right = _camera.ViewportPointToRay(new Vector3(1f, 0.5f, 0f));
        Assert.That(Vector3.Angle(top.direction, _camera.transform.forward), Is.EqualTo(30f).Within(1e-3f));
        double half = Math.Atan(Math.Tan(Math.PI / 6.0) * 16.0 / 9.0) * 180.0 / Math.PI;
        Assert.That(Vector3.Angle(right.direction, _camera.transform.forward), Is.EqualTo(half).Within(1e-3));
        Assert.That(Vector3.Dot(right.direction, _camera.transform.right), Is.Positive);
        Assert.That(Vector3.Dot(top.direction, _camera.transform.up), Is.Positive);
    }

    [Test]
    public void ViewportRay_BeginsOnTheNearPlane()
    {
        Ray ray = _camera.ViewportPointToRay(new Vector3(0.2f, 0.7f, 0f));
        Assert.That(_camera.transform.InverseTransformPoint(ray.origin).z, Is.EqualTo(0.5f).Within(Tolerance));
        Vector3 fromCamera = (ray.origin - _camera.transform.position).normalized;
        Assert.That(Vector3.Dot(fromCamera, ray.direction), Is.EqualTo(1f).Within(1e-5f));
    }

    [TestCase(false)]
    [TestCase(true)]
    public void WorldPoint_ToViewportAndBack_IsItself(bool orthographic)
    {
        _camera.orthographic = orthographic;
        Vector3 world = _camera.transform.TransformPoint(new Vector3(-2f, 1.5f, 20f));
        Vector3 viewport = _camera.WorldToViewportPoint(world);
        Assert.That(viewport.z, Is.EqualTo(20f).Within(Tolerance));
        AssertClose(_camera.ViewportToWorldPoint(viewport), world);
        AssertClose(_camera.ScreenToWorldPoint(_camera.WorldToScreenPoint(world)), world);
    }

    [Test]
    public void ViewportCentre_OfAPointAhead_IsHalf()
    {
        Vector3 ahead = _camera.transform.position + 7f * _camera.transform.forward;
        AssertClose(_camera.WorldToViewportPoint(ahead), new Vector3(0.5f, 0.5f, 7f));
    }

    [Test]
    public void OrthographicRay_IsParallelToForward()
    {
        _camera.orthographic = true;
        _camera.orthographicSize = 5f;
        Ray ray = _camera.ViewportPointToRay(new Vector3(0.5f, 1f, 0f));
        AssertClose(ray.direction, _camera.transform.forward);
        AssertClose(_camera.transform.InverseTransformPoint(ray.origin), new Vector3(0f, 5f, 0.5f));
    }

    [Test]
    public void Aspect_NotSet_IsThatOfTheView()
    {
        _camera.ResetAspect();
        Assert.That(_camera.aspect, Is.EqualTo((float)Screen.width / Screen.height).Within(1e-6f));
        Assert.That(_camera.pixelWidth, Is.EqualTo(Screen.width));
        _camera.rect = new Rect(0f, 0f, 0.5f, 1f);
        Assert.That(_camera.pixelWidth, Is.EqualTo(Screen.width / 2));
    }

    [Test]
    public void AllCameras_AreTheEnabledOnesByDepth()
    {
        var second = new GameObject("second").AddComponent<Camera>();
        second.depth = -1f;
        Assert.That(Camera.allCameras, Is.EqualTo(new[] { second, _camera }));
        second.enabled = false;
        Assert.That(Camera.allCameras, Is.EqualTo(new[] { _camera }));
    }

    static void AssertClose(Vector3 actual, Vector3 expected) =>
        Assert.That((actual - expected).magnitude, Is.LessThan(Tolerance), $"{actual} is not {expected}");
}
