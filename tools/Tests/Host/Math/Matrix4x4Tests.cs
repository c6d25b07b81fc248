using System;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Host.Tests;

public class Matrix4x4Tests
{
    static readonly Matrix4x4 _pose =
        Matrix4x4.TRS(new Vector3(10, -20, 30), Quaternion.Euler(15, 25, 35), new Vector3(2, 3, 0.5f));

    [Test]
    public void Trs_OfPositionAnglesAndScale_ScalesThenTurnsThenMoves()
    {
        double[,] expected = DoubleMatrix.Product(
            DoubleMatrix.Move(10, -20, 30), DoubleMatrix.Turn(1, 25), DoubleMatrix.Turn(0, 15),
            DoubleMatrix.Turn(2, 35), DoubleMatrix.Diagonal(2, 3, 0.5));
        Near.Matrix(_pose, expected, 1e-6);
    }

    [Test]
    public void MultiplyPointAndVector_OfAPose_DifferByTheTranslation()
    {
        var v = new Vector3(1, 2, 3);
        Vector3 point = _pose.MultiplyPoint3x4(v), vector = _pose.MultiplyVector(v);
        Near.Point(point - vector, 10, -20, 30, 1e-5);
        Assert.That(_pose.MultiplyPoint(v).Equals(point));
        Vector4 row = _pose * new Vector4(1, 2, 3, 1);
        Near.Point(row, point.x, point.y, point.z, 1e-6);
    }

    [Test]
    public void Product_OfMatrices_IsTheTextbooks()
    {
        Matrix4x4 a = Numbers(5), b = Numbers(6);
        double[,] expected =
            DoubleMatrix.Product(DoubleMatrix.Fill((i, j) => a[i, j]), DoubleMatrix.Fill((i, j) => b[i, j]));
        Near.Matrix(a * b, expected, 1e-6);
    }

    [Test]
    public void Inverse_OfAnyMatrix_TimesItIsOne()
    {
        for (int seed = 0; seed < 50; seed++)
        {
            Matrix4x4 m = Numbers(seed);
            double tolerance = 1e-5 / Math.Min(1, Math.Abs(m.determinant));
            Near.Matrix(m * m.inverse, DoubleMatrix.Identity(), tolerance);
            Assert.That(m.determinant * m.inverse.determinant, Is.EqualTo(1).Within(tolerance));
        }
    }

    [Test]
    public void Inverse_OfASingularMatrix_IsZero()
    {
        Assert.That(Matrix4x4.Scale(new Vector3(1, 0, 1)).inverse.Equals(Matrix4x4.zero));
    }

    [Test]
    public void Determinant_OfAPose_IsTheVolumeOfItsScale()
    {
        Assert.That(_pose.determinant, Is.EqualTo(2 * 3 * 0.5).Within(1e-5));
        Assert.That(Matrix4x4.Scale(new Vector3(-1, 2, 3)).determinant, Is.EqualTo(-6));
    }

    [Test]
    public void RotationAndLossyScale_OfAPose_AreThoseItWasMadeOf()
    {
        Assert.That(_pose.rotation == Quaternion.Euler(15, 25, 35));
        Near.Point(_pose.lossyScale, 2, 3, 0.5, 1e-6);
        Near.Point(_pose.GetPosition(), 10, -20, 30, 0);
        Assert.That(_pose.ValidTRS());
    }

    [Test]
    public void RotationAndLossyScale_OfAMirroringPose_MakeItAgain()
    {
        Matrix4x4 mirror = Matrix4x4.TRS(Vector3.one, Quaternion.Euler(15, 25, 35), new Vector3(2, -3, 4));
        Matrix4x4 again = Matrix4x4.TRS(mirror.GetPosition(), mirror.rotation, mirror.lossyScale);
        Near.Matrix(again, DoubleMatrix.Fill((i, j) => mirror[i, j]), 2e-6);
    }

    [Test]
    public void Perspective_PointsOnTheFrustum_GoToTheCubesFaces()
    {
        // 60 degrees high, twice as wide as high; the camera looks along -z.
        Matrix4x4 m = Matrix4x4.Perspective(60, 2, 0.5f, 100);
        double top = Math.Tan(Math.PI / 6);
        Near.Point(m.MultiplyPoint(new Vector3(0, 0, -0.5f)), 0, 0, -1, 1e-5);
        Near.Point(m.MultiplyPoint(new Vector3(0, 0, -100)), 0, 0, 1, 1e-5);
        Near.Point(m.MultiplyPoint(new Vector3((float)(2 * top), (float)top, -1) * 7), 1, 1,
            (100.5 - 100 / 7.0) / 99.5, 1e-5);
    }

    [Test]
    public void DecomposeProjection_OfAFrustum_GivesItsPlanesBack()
    {
        FrustumPlanes planes = Matrix4x4.Frustum(-1, 2, -3, 4, 0.5f, 50).decomposeProjection;
        Assert.That(new[] { planes.left, planes.right, planes.bottom, planes.top, planes.zNear, planes.zFar },
            Is.EqualTo(new[] { -1f, 2f, -3f, 4f, 0.5f, 50f }).Within(1e-4f));
    }

    [Test]
    public void Ortho_CornersOfTheBox_GoToTheCubesCorners()
    {
        Matrix4x4 m = Matrix4x4.Ortho(-2, 4, -1, 1, 1, 11);
        Near.Point(m.MultiplyPoint(new Vector3(-2, -1, -1)), -1, -1, -1, 1e-6);
        Near.Point(m.MultiplyPoint(new Vector3(4, 1, -11)), 1, 1, 1, 1e-6);
    }

    [Test]
    public void LookAt_FromHereToThere_PutsThereOnTheForwardAxis()
    {
        Matrix4x4 m = Matrix4x4.LookAt(new Vector3(1, 2, 3), new Vector3(4, 6, 3), Vector3.up);
        Near.Point(m.inverse.MultiplyPoint3x4(new Vector3(4, 6, 3)), 0, 0, 5, 1e-5);
    }

    [Test]
    public void TransformPlane_ByAPose_KeepsItsPointsOnIt()
    {
        var plane = new Plane(new Vector3(1, 2, 3), new Vector3(1, 0, 0));
        Plane moved =
            Matrix4x4.TRS(new Vector3(1, 2, 3), Quaternion.Euler(15, 25, 35), Vector3.one).TransformPlane(plane);
        Vector3 point = Matrix4x4.TRS(new Vector3(1, 2, 3), Quaternion.Euler(15, 25, 35), Vector3.one)
            .MultiplyPoint3x4(new Vector3(1, 0, 0));
        Assert.That(moved.GetDistanceToPoint(point), Is.Zero.Within(1e-5));
    }

    [Test]
    public void Indexer_ByNumber_GoesDownTheColumns()
    {
        Matrix4x4 m = Matrix4x4.identity;
        m[13] = 5;
        Assert.That(m.m13, Is.EqualTo(5));
        Assert.That(m[1, 3], Is.EqualTo(5));
        Assert.That(m.GetColumn(3).y, Is.EqualTo(5));
        Assert.That(m.GetRow(1).w, Is.EqualTo(5));
        Assert.Throws<IndexOutOfRangeException>(() => m[16] = 1);
    }

    [Test]
    public void ToString_ByDefault_IsFourRowsOfFiveDigits()
    {
        Assert.That(Matrix4x4.zero.ToString(), Does.StartWith("0.00000\t0.00000\t0.00000\t0.00000\n"));
    }

    static Matrix4x4 Numbers(int seed)
    {
        var random = new System.Random(seed);
        Matrix4x4 m = default;
        for (int i = 0; i < 16; i++)
            m[i] = (float)(random.NextDouble() * 2 - 1);
        return m;
    }
}
