using System;
using System.Globalization;
using System.Runtime.CompilerServices;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Host.Tests;

public class VectorTests
{
    [Test]
    public void Equality_WithinRounding_HoldsForTheOperatorOnly()
    {
        var a = new Vector3(1, 2, 3);
        var b = new Vector3(1.000001f, 2, 3);
        Assert.That(a == b);
        Assert.That(a.Equals(b), Is.False);
        Assert.That(a != new Vector3(1.0001f, 2, 3));
    }

    [Test]
    public void ToString_ByDefault_HasTwoDigitsInAnyCulture()
    {
        CultureInfo before = CultureInfo.CurrentCulture;
        try
        {
            CultureInfo.CurrentCulture = new CultureInfo("") { NumberFormat = { NumberDecimalSeparator = "," } };
            Assert.That(new Vector3(1, 2.345f, -3).ToString(),
                Is.EqualTo("(1.00, 2.35, -3.00)").Or.EqualTo("(1.00, 2.34, -3.00)"));
            Assert.That(new Vector2(1, 2).ToString("F1"), Is.EqualTo("(1.0, 2.0)"));
            Assert.That(new Vector3Int(1, -2, 3).ToString(), Is.EqualTo("(1, -2, 3)"));
            Assert.That(new Bounds(Vector3.zero, Vector3.one).ToString(),
                Is.EqualTo("Center: (0.00, 0.00, 0.00), Extents: (0.50, 0.50, 0.50)"));
            Assert.That(Color.red.ToString(), Is.EqualTo("RGBA(1.000, 0.000, 0.000, 1.000)"));
        }
        finally
        {
            CultureInfo.CurrentCulture = before;
        }
    }

    [Test]
    public void Cross_OfRightAndUp_IsForward()
    {
        Near.Point(Vector3.Cross(Vector3.right, Vector3.up), 0, 0, 1, 0);
    }

    [Test]
    public void SignedAngle_AboutUp_IsPositiveForAPositiveYaw()
    {
        Assert.That(Vector3.SignedAngle(Vector3.forward, Vector3.right, Vector3.up), Is.EqualTo(90).Within(1e-4));
        Assert.That(Vector3.SignedAngle(Vector3.right, Vector3.forward, Vector3.up), Is.EqualTo(-90).Within(1e-4));
    }

    [Test]
    public void Normalize_OfATinyVector_IsZero()
    {
        Assert.That(new Vector3(0, 5e-6f, 0).normalized.Equals(Vector3.zero));
        Near.Point(new Vector3(0, 3, 4).normalized, 0, 0.6, 0.8, 1e-7);
    }

    [Test]
    public void Reflect_OffAPlane_FlipsTheNormalComponent()
    {
        Near.Point(Vector3.Reflect(new Vector3(1, -1, 2), Vector3.up), 1, 1, 2, 0);
    }

    [Test]
    public void Slerp_HalfWay_BisectsAngleAndLength()
    {
        Near.Point(Vector3.Slerp(Vector3.right * 2, Vector3.up * 4, 0.5f), 3 / Math.Sqrt(2), 3 / Math.Sqrt(2), 0, 1e-6);
    }

    [Test]
    public void OrthoNormalize_OfSkewVectors_KeepsTheNormalsDirection()
    {
        Vector3 normal = new Vector3(0, 5, 0), tangent = new Vector3(3, 4, 0);
        Vector3.OrthoNormalize(ref normal, ref tangent);
        Near.Point(normal, 0, 1, 0, 0);
        Near.Point(tangent, 1, 0, 0, 1e-7);
    }

    [Test]
    public void Types_ThatBuffersHold_HaveUnitysSizes()
    {
        Assert.That(Unsafe.SizeOf<Vector2>(), Is.EqualTo(8));
        Assert.That(Unsafe.SizeOf<Vector3>(), Is.EqualTo(12));
        Assert.That(Unsafe.SizeOf<Vector4>(), Is.EqualTo(16));
        Assert.That(Unsafe.SizeOf<Quaternion>(), Is.EqualTo(16));
        Assert.That(Unsafe.SizeOf<Matrix4x4>(), Is.EqualTo(64));
        Assert.That(Unsafe.SizeOf<Color32>(), Is.EqualTo(4));
        Assert.That(Unsafe.SizeOf<Bounds>(), Is.EqualTo(24));
    }

    [Test]
    public void Bounds_GrownByPoints_ContainThem()
    {
        var bounds = new Bounds(new Vector3(1, 1, 1), Vector3.zero);
        bounds.Encapsulate(new Vector3(-1, 2, 5));
        Near.Point(bounds.min, -1, 1, 1, 1e-6);
        Near.Point(bounds.max, 1, 2, 5, 1e-6);
        Assert.That(bounds.Contains(new Vector3(0, 1.5f, 3)));
        Assert.That(bounds.SqrDistance(new Vector3(3, 2, 5)), Is.EqualTo(4).Within(1e-5));
    }

    [TestCase(0, 0, -5, 0, 0, 1, true, 4)]
    [TestCase(0, 0, 0, 0, 0, 1, true, -1)]
    [TestCase(0, 2, -5, 0, 0, 1, false, 0)]
    [TestCase(0, 0, 5, 0, 0, 1, false, 0)]
    public void IntersectRay_OfTheCube_GivesTheWayIn(float x, float y, float z, float dx, float dy,
        float dz, bool hits, float enters)
    {
        bool hit = new Bounds(Vector3.zero, Vector3.one * 2)
            .IntersectRay(new Ray(new Vector3(x, y, z), new Vector3(dx, dy, dz)), out float distance);
        Assert.That(hit, Is.EqualTo(hits));
        Assert.That(distance, Is.EqualTo(enters));
    }

    [Test]
    public void PlaneRaycast_FromAbove_GivesTheDistance()
    {
        var ground = new Plane(Vector3.up, new Vector3(0, 1, 0));
        Assert.That(ground.Raycast(new Ray(new Vector3(0, 4, 0), Vector3.down), out float enter));
        Assert.That(enter, Is.EqualTo(3));
        Assert.That(ground.Raycast(new Ray(new Vector3(0, 4, 0), Vector3.up), out enter), Is.False);
        Assert.That(enter, Is.EqualTo(-3));
    }

    [Test]
    public void Plane_ThroughClockwisePoints_FacesTheViewer()
    {
        Near.Point(new Plane(Vector3.zero, Vector3.forward, Vector3.right).normal, 0, 1, 0, 0);
    }

    [Test]
    public void LayerMask_OfDefaultLayers_HasTheirBits()
    {
        Assert.That(LayerMask.GetMask("Default", "Water", "no such layer"), Is.EqualTo(1 | 16));
        Assert.That(LayerMask.NameToLayer("UI"), Is.EqualTo(5));
        Assert.That(LayerMask.NameToLayer("no such layer"), Is.EqualTo(-1));
        LayerMask mask = 48;
        Assert.That((int)mask, Is.EqualTo(48));
    }
}
