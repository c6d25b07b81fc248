using NUnit.Framework;
using UnityEngine;

namespace Glint.Host.Tests;

/// <summary>Transforms against plain 4x4 matrix products in double precision.</summary>
public sealed class TransformTests : EngineFixture
{
    const double Tolerance = 2e-5;

    Transform _top, _centre, _bottom;

    [SetUp]
    public void BuildChain()
    {
        _top =
            Make("top", null, new Vector3(3f, -2f, 5f), Quaternion.Euler(20f, 70f, -35f), new Vector3(2f, 0.5f, -1.5f));
        _centre = Make("middle", _top, new Vector3(-1f, 4f, 0.5f), Quaternion.Euler(-50f, 10f, 120f),
            new Vector3(0.7f, 3f, 1.2f));
        _bottom = Make("bottom", _centre, new Vector3(0.3f, 0.2f, -2f), Quaternion.Euler(5f, -80f, 60f),
            new Vector3(1f, -2f, 1f));
    }

    [Test]
    public void LocalToWorldMatrix_WithShearAndMirror_IsTheProductOfTheChain()
    {
        double[,] expected = Product(Product(Local(_top), Local(_centre)), Local(_bottom));
        AssertClose(_bottom.localToWorldMatrix, expected);
        AssertClose(_bottom.worldToLocalMatrix * _bottom.localToWorldMatrix, Identity());
    }

    [Test]
    public void TransformPoint_IsTheMatrixAppliedAndItsInverseUndoesIt()
    {
        var point = new Vector3(0.4f, -1.1f, 2.3f);
        AssertClose(_bottom.TransformPoint(point), _bottom.localToWorldMatrix.MultiplyPoint3x4(point));
        AssertClose(_bottom.InverseTransformPoint(_bottom.TransformPoint(point)), point);
        AssertClose(_bottom.TransformVector(point), _bottom.localToWorldMatrix.MultiplyVector(point));
        AssertClose(_bottom.InverseTransformVector(_bottom.TransformVector(point)), point);
    }

    [Test]
    public void TransformDirection_KeepsLengthUnderAnyScale()
    {
        var direction = new Vector3(1f, 2f, -2f);
        Vector3 world = _bottom.TransformDirection(direction);
        Assert.That(world.magnitude, Is.EqualTo(3f).Within(Tolerance));
        AssertClose(_bottom.InverseTransformDirection(world), direction);
        AssertClose(_bottom.forward, _bottom.TransformDirection(Vector3.forward));
    }

    [Test]
    public void Rotation_UnderAMirroredParent_AgreesWithTheMatrix()
    {
        Transform mirror = Make("mirror", null, Vector3.zero, Quaternion.Euler(0f, 30f, 0f), new Vector3(-1f, 1f, 1f));
        Transform child = Make("child", mirror, Vector3.zero, Quaternion.Euler(0f, 40f, 10f), Vector3.one);
        // The matrix maps the child's axes to those of the rotation, except for the mirrored x axis of the parent.
        double[,] world = Product(Local(mirror), Local(child));
        double[,] rotated = Product(Rotation(child.rotation),
            new double[,] { { -1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 }, { 0, 0, 0, 1 } });
        for (int row = 0; row < 3; row++)
        {
            for (int column = 0; column < 3; column++)
                Assert.That(rotated[row, column], Is.EqualTo(world[row, column]).Within(Tolerance), $"m{row}{column}");
        }
    }

    [Test]
    public void WorldPoseSet_InAMirroredChain_IsReadBack()
    {
        var position = new Vector3(7f, -3f, 11f);
        Quaternion rotation = Quaternion.Euler(12f, 200f, -75f);
        _bottom.SetPositionAndRotation(position, rotation);
        AssertClose(_bottom.position, position);
        Assert.That(Quaternion.Angle(_bottom.rotation, rotation), Is.LessThan(0.05f));
    }

    [Test]
    public void LossyScale_WithoutRotation_IsTheProductOfScales()
    {
        Transform parent = Make("p", null, Vector3.one, Quaternion.Euler(0f, 25f, 0f), new Vector3(2f, 3f, -4f));
        Transform child = Make("c", parent, Vector3.one, Quaternion.identity, new Vector3(0.5f, -2f, 1f));
        AssertClose(child.lossyScale, new Vector3(1f, -6f, -4f));
    }

    [Test]
    public void SetParent_WorldPositionStays_KeepsThePose()
    {
        Transform parent =
            Make("p", null, new Vector3(1f, 2f, 3f), Quaternion.Euler(10f, 20f, 30f), new Vector3(2f, 2f, 2f));
        Transform child =
            Make("c", null, new Vector3(-4f, 0f, 2f), Quaternion.Euler(0f, 90f, 45f), new Vector3(1f, 3f, 5f));
        Matrix4x4 before = child.localToWorldMatrix;
        child.SetParent(parent);
        AssertClose(child.localToWorldMatrix, Doubles(before));
        AssertClose(child.localScale, new Vector3(0.5f, 1.5f, 2.5f));
        child.SetParent(null, true);
        AssertClose(child.localToWorldMatrix, Doubles(before));
    }

    [Test]
    public void SetParent_WorldPositionGoes_KeepsTheLocalValues()
    {
        Transform child =
            Make("c", null, new Vector3(-4f, 0f, 2f), Quaternion.Euler(0f, 90f, 45f), new Vector3(1f, 3f, 5f));
        child.SetParent(_bottom, false);
        Assert.That(child.localPosition, Is.EqualTo(new Vector3(-4f, 0f, 2f)));
        Assert.That(child.localScale, Is.EqualTo(new Vector3(1f, 3f, 5f)));
    }

    [Test]
    public void SetParent_ToADescendant_IsIgnored()
    {
        _top.SetParent(_bottom);
        Assert.That(_top.parent, Is.Null);
    }

    [Test]
    public void ZeroScale_InverseTransformPoint_IsZeroAlongThatAxis()
    {
        Transform flat = Make("flat", null, Vector3.zero, Quaternion.identity, new Vector3(1f, 0f, 2f));
        Assert.That(flat.InverseTransformPoint(new Vector3(3f, 4f, 8f)), Is.EqualTo(new Vector3(3f, 0f, 4f)));
    }

    [Test]
    public void Rotate_AboutSelfOrWorld_MultipliesOnThatSide()
    {
        Transform item = Make("i", null, Vector3.zero, Quaternion.Euler(30f, 40f, 50f), Vector3.one);
        Quaternion start = item.rotation, turn = Quaternion.Euler(0f, 25f, 0f);
        item.Rotate(0f, 25f, 0f);
        Assert.That(Quaternion.Angle(item.rotation, start * turn), Is.LessThan(0.05f));
        item.rotation = start;
        item.Rotate(0f, 25f, 0f, UnityEngine.Space.World);
        Assert.That(Quaternion.Angle(item.rotation, turn * start), Is.LessThan(0.05f));
        item.rotation = start;
        item.Rotate(Vector3.up, 25f);
        Assert.That(Quaternion.Angle(item.rotation, start * turn), Is.LessThan(0.05f));
    }

    [Test]
    public void RotateAround_QuarterTurnAboutUp_TakesForwardToRight()
    {
        // Left-handed: a positive rotation about y maps +z to +x.
        Transform item = Make("i", null, new Vector3(1f, 0f, 3f), Quaternion.identity, Vector3.one);
        item.RotateAround(new Vector3(1f, 0f, 1f), Vector3.up, 90f);
        AssertClose(item.position, new Vector3(3f, 0f, 1f));
        AssertClose(item.forward, Vector3.right);
    }

    [Test]
    public void Translate_ActsInTheAskedSpace()
    {
        Transform item = Make("i", null, Vector3.zero, Quaternion.Euler(0f, 90f, 0f), new Vector3(5f, 5f, 5f));
        item.Translate(Vector3.forward);
        AssertClose(item.position, Vector3.right);
        item.Translate(Vector3.forward, UnityEngine.Space.World);
        AssertClose(item.position, new Vector3(1f, 0f, 1f));
    }

    [Test]
    public void LookAt_PointsForwardAtTheTarget()
    {
        Transform item = Make("i", _top, new Vector3(1f, 2f, 3f), Quaternion.identity, Vector3.one);
        var target = new Vector3(40f, -7f, 12f);
        item.LookAt(target);
        AssertClose(item.forward, (target - item.position).normalized);
        Assert.That(Vector3.Dot(item.right, Vector3.up), Is.EqualTo(0f).Within(Tolerance));
    }

    [Test]
    public void Children_KeepTheirOrderAndMoveOnRequest()
    {
        Transform a = Make("a", _top, default, Quaternion.identity, Vector3.one);
        Transform b = Make("b", _top, default, Quaternion.identity, Vector3.one);
        Assert.That(_top.childCount, Is.EqualTo(3));
        Assert.That(b.GetSiblingIndex(), Is.EqualTo(2));
        b.SetAsFirstSibling();
        a.SetSiblingIndex(1);
        Assert.That(string.Join(" ", Names(_top)), Is.EqualTo("b a middle"));
        Assert.That(_top.Find("middle/bottom"), Is.SameAs(_bottom));
        Assert.That(_top.Find("bottom"), Is.Null);
        Assert.That(_bottom.root, Is.SameAs(_top));
        Assert.That(_bottom.IsChildOf(_top) && !_top.IsChildOf(_bottom) && _top.IsChildOf(_top));
        _top.DetachChildren();
        Assert.That(_top.childCount, Is.Zero);
        Assert.That(_centre.parent, Is.Null);
    }

    [Test]
    public void HasChanged_IsSetByAnAncestorsMove()
    {
        _bottom.hasChanged = false;
        _top.position += Vector3.up;
        Assert.That(_bottom.hasChanged);
    }

    static Transform Make(string name, Transform parent, Vector3 position, Quaternion rotation, Vector3 scale)
    {
        Transform item = new GameObject(name).transform;
        item.SetParent(parent, false);
        item.SetLocalPositionAndRotation(position, rotation);
        item.localScale = scale;
        return item;
    }

    static System.Collections.Generic.IEnumerable<string> Names(Transform parent)
    {
        foreach (Transform child in parent)
            yield return child.name;
    }

    static double[,] Local(Transform item)
    {
        double[,] matrix = Rotation(item.localRotation);
        Vector3 scale = item.localScale, position = item.localPosition;
        for (int row = 0; row < 3; row++)
        {
            for (int column = 0; column < 3; column++)
                matrix[row, column] *= scale[column];
            matrix[row, 3] = position[row];
        }
        return matrix;
    }

    static double[,] Rotation(Quaternion q)
    {
        double x = q.x, y = q.y, z = q.z, w = q.w;
        return new[,]
        {
            { 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), 0 },
            { 2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x), 0 },
            { 2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y), 0 },
            { 0, 0, 0, 1 },
        };
    }

    static double[,] Identity() => Rotation(Quaternion.identity);

    static double[,] Product(double[,] a, double[,] b)
    {
        var product = new double[4, 4];
        for (int row = 0; row < 4; row++)
        {
            for (int column = 0; column < 4; column++)
            {
                for (int k = 0; k < 4; k++)
                    product[row, column] += a[row, k] * b[k, column];
            }
        }
        return product;
    }

    static double[,] Doubles(Matrix4x4 matrix)
    {
        var values = new double[4, 4];
        for (int row = 0; row < 4; row++)
        {
            for (int column = 0; column < 4; column++)
                values[row, column] = matrix[row, column];
        }
        return values;
    }

    static void AssertClose(Matrix4x4 actual, double[,] expected)
    {
        for (int row = 0; row < 4; row++)
        {
            for (int column = 0; column < 4; column++)
                Assert.That(actual[row, column],
                    Is.EqualTo(expected[row, column]).Within(Tolerance), $"m{row}{column}");
        }
    }

    static void AssertClose(Vector3 actual, Vector3 expected) =>
        Assert.That((actual - expected).magnitude, Is.LessThan(Tolerance), $"{actual} is not {expected}");
}
