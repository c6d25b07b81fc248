using System;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Host.Tests;

public class QuaternionTests
{
    // Matrix of a unit quaternion in float32: a few roundings of numbers up to 1.
    const double Tolerance = 5e-7;

    [TestCase(0, 90, 0, 0, 0, 1, 1, 0, 0, TestName = "Euler_PositiveYaw_TurnsForwardToTheRight")]
    [TestCase(90, 0, 0, 0, 0, 1, 0, -1, 0, TestName = "Euler_PositivePitch_TurnsForwardDown")]
    [TestCase(0, 0, 90, 1, 0, 0, 0, 1, 0, TestName = "Euler_PositiveRoll_TurnsRightUp")]
    public void Euler_QuarterTurn(float pitch, float yaw, float roll, float x, float y, float z,
        double toX, double toY, double toZ)
    {
        Near.Point(Quaternion.Euler(pitch, yaw, roll) * new Vector3(x, y, z), toX, toY, toZ, Tolerance);
    }

    [Test]
    public void Euler_AnyAngles_IsZThenXThenY()
    {
        var random = new System.Random(1);
        for (int i = 0; i < 200; i++)
        {
            float x = Angle(random), y = Angle(random), z = Angle(random);
            double[,] expected =
                DoubleMatrix.Product(DoubleMatrix.Turn(1, y), DoubleMatrix.Turn(0, x), DoubleMatrix.Turn(2, z));
            Near.Matrix(Matrix4x4.Rotate(Quaternion.Euler(x, y, z)), expected, Tolerance);
        }
    }

    [Test]
    public void EulerAngles_OfAnyRotation_GiveTheRotationBack()
    {
        var random = new System.Random(2);
        for (int i = 0; i < 200; i++)
        {
            Quaternion q = Quaternion.Euler(Angle(random), Angle(random), Angle(random));
            Vector3 angles = q.eulerAngles;
            Assert.That(Mathf.Abs(Quaternion.Dot(q, Quaternion.Euler(angles))), Is.EqualTo(1).Within(1e-5));
            for (int axis = 0; axis < 3; axis++)
                Assert.That(angles[axis], Is.InRange(-0.01f, 360f));
        }
    }

    [Test]
    public void EulerAngles_NegativeAngle_IsPositive()
    {
        Near.Point(Quaternion.Euler(-10, -20, -30).eulerAngles, 350, 340, 330, 1e-3);
    }

    [TestCase(90)]
    [TestCase(-90)]
    public void EulerAngles_LookingStraightUpOrDown_PutTheWholeTurnIntoYaw(float pitch)
    {
        Quaternion q = Quaternion.Euler(pitch, 70, 30);
        Vector3 angles = q.eulerAngles;
        Assert.That(angles.z, Is.Zero);
        Assert.That(Mathf.Abs(Quaternion.Dot(q, Quaternion.Euler(angles))), Is.EqualTo(1).Within(1e-6));
    }

    [Test]
    public void AngleAxis_AboutTheCubesDiagonal_PermutesTheAxes()
    {
        Quaternion q = Quaternion.AngleAxis(120, new Vector3(1, 1, 1));
        Near.Point(q * Vector3.right, 0, 1, 0, Tolerance);
        Near.Point(q * Vector3.up, 0, 0, 1, Tolerance);
    }

    [Test]
    public void ToAngleAxis_OfAngleAxis_GivesThemBack()
    {
        Quaternion.AngleAxis(75, new Vector3(0, 3, 4)).ToAngleAxis(out float angle, out Vector3 axis);
        Assert.That(angle, Is.EqualTo(75).Within(1e-4));
        Near.Point(axis, 0, 0.6, 0.8, Tolerance);
    }

    [Test]
    public void LookRotation_AnyDirection_TurnsForwardToItAndUpIntoItsPlane()
    {
        var random = new System.Random(3);
        for (int i = 0; i < 100; i++)
        {
            Vector3 forward = Direction(random), up = Direction(random);
            Quaternion q = Quaternion.LookRotation(forward * 5, up * 3);
            Near.Point(q * Vector3.forward, forward.x, forward.y, forward.z, 2e-6);
            Assert.That(Vector3.Dot(q * Vector3.right, up), Is.Zero.Within(2e-6));
            Assert.That(Vector3.Dot(q * Vector3.up, up), Is.GreaterThan(-2e-6f));
        }
    }

    [Test]
    public void LookRotation_ParallelToUp_StillTurnsForward()
    {
        Near.Point(Quaternion.LookRotation(Vector3.up) * Vector3.forward, 0, 1, 0, Tolerance);
        Near.Point(Quaternion.LookRotation(Vector3.down) * Vector3.forward, 0, -1, 0, Tolerance);
    }

    [Test]
    public void LookRotation_ZeroVector_IsNoRotation()
    {
        Assert.That(Quaternion.LookRotation(Vector3.zero).Equals(Quaternion.identity));
    }

    [Test]
    public void FromToRotation_AnyDirections_TurnsTheShortestWay()
    {
        var random = new System.Random(4);
        for (int i = 0; i < 100; i++)
        {
            Vector3 from = Direction(random), to = Direction(random);
            Quaternion q = Quaternion.FromToRotation(from, to);
            Near.Point(q * from, to.x, to.y, to.z, 2e-6);
            Assert.That(Quaternion.Angle(Quaternion.identity, q), Is.EqualTo(Vector3.Angle(from, to)).Within(0.05));
        }
    }

    [Test]
    public void FromToRotation_OppositeDirections_TurnsHalfWayRound()
    {
        foreach (Vector3 from in new[] { Vector3.right, Vector3.up, Vector3.forward, new Vector3(1, 2, 3).normalized })
            Near.Point(Quaternion.FromToRotation(from, -from) * from, -from.x, -from.y, -from.z, 1e-6);
    }

    [Test]
    public void Inverse_OfARotation_UndoesIt()
    {
        Quaternion q = Quaternion.Euler(10, 20, 30);
        Near.Point(Quaternion.Inverse(q) * (q * new Vector3(1, 2, 3)), 1, 2, 3, 1e-6);
    }

    [Test]
    public void Product_OfTwoRotations_AppliesTheRightFirst()
    {
        Quaternion a = Quaternion.Euler(10, 20, 30), b = Quaternion.Euler(-40, 50, 60);
        var v = new Vector3(1, 2, 3);
        Vector3 expected = a * (b * v);
        Near.Point(a * b * v, expected.x, expected.y, expected.z, 1e-6);
    }

    [Test]
    public void Slerp_AThirdOfTheWay_TurnsAThirdOfTheAngle()
    {
        Quaternion from = Quaternion.Euler(0, 10, 0), to = Quaternion.Euler(0, 100, 0);
        Assert.That(Quaternion.Slerp(from, to, 1f / 3f).eulerAngles.y, Is.EqualTo(40).Within(1e-3));
        Assert.That(Quaternion.Slerp(from, new Quaternion(-to.x, -to.y, -to.z, -to.w), 1f / 3f).eulerAngles.y,
            Is.EqualTo(40).Within(1e-3));
        Assert.That(Quaternion.Slerp(from, to, 2).eulerAngles.y, Is.EqualTo(100).Within(1e-3));
    }

    [Test]
    public void RotateTowards_SmallStep_TurnsByTheStep()
    {
        Quaternion q = Quaternion.RotateTowards(Quaternion.identity, Quaternion.Euler(0, 90, 0), 12);
        Assert.That(q.eulerAngles.y, Is.EqualTo(12).Within(1e-3));
    }

    [Test]
    public void ToString_ByDefault_HasFiveDigits()
    {
        Assert.That(Quaternion.identity.ToString(), Is.EqualTo("(0.00000, 0.00000, 0.00000, 1.00000)"));
    }

    static float Angle(System.Random random) => (float)(random.NextDouble() * 720 - 360);

    static Vector3 Direction(System.Random random)
    {
        double z = random.NextDouble() * 2 - 1, turn = random.NextDouble() * 2 * Math.PI, r = Math.Sqrt(1 - z * z);
        return new Vector3((float)(r * Math.Cos(turn)), (float)(r * Math.Sin(turn)), (float)z);
    }
}
