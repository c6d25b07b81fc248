using System;
using System.Runtime.InteropServices;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using static Unity.Mathematics.math;
// Types with the name of a method of math.
using Affine = Unity.Mathematics.float4x4;
using Rotation = Unity.Mathematics.quaternion;

namespace Glint.Host.Tests;

public class MathematicsTests
{
    static readonly quaternion _turn = Rotation.Euler(radians(15f), radians(25f), radians(35f));

    [Test]
    public void Min_OfANumberAndNaN_IsTheNumber()
    {
        Assert.That(min(1f, NAN), Is.EqualTo(1));
        Assert.That(min(NAN, 1f), Is.EqualTo(1));
        Assert.That(max(1.0, NAN_DBL), Is.EqualTo(1));
        Assert.That(max(NAN_DBL, 1.0), Is.EqualTo(1));
    }

    [TestCase(0.5f, 0)]
    [TestCase(1.5f, 2)]
    [TestCase(-2.5f, -2)]
    public void Round_OfAHalf_GoesToTheEvenNumber(float value, float expected)
    {
        Assert.That(round(value), Is.EqualTo(expected));
        Assert.That(round((double)value), Is.EqualTo(expected));
    }

    [Test]
    public void Frac_OfANegativeNumber_IsPositive()
    {
        Assert.That(frac(-1.25f), Is.EqualTo(0.75f));
        Assert.That(fmod(-1.25f, 1f), Is.EqualTo(-0.25f));
        Assert.That(modf(-1.25, out double whole), Is.EqualTo(-0.25));
        Assert.That(whole, Is.EqualTo(-1));
    }

    [Test]
    public void Select_ByATest_TakesTheSecondWhereTrue()
    {
        Assert.That(select(1, 2, true), Is.EqualTo(2));
        Assert.That(select(float3(1, 2, 3), float3(4, 5, 6), new bool3(true, false, true)).Equals(float3(4, 2, 6)));
    }

    [Test]
    public void Normalizesafe_OfZero_IsTheDefault()
    {
        Assert.That(normalizesafe(Unity.Mathematics.float3.zero, up()).Equals(up()));
        Assert.That(all(isfinite(normalizesafe(new double3(0)))));
        Assert.That(length(normalize(new double3(1, 2, 3))), Is.EqualTo(1).Within(1e-15));
    }

    [Test]
    public void Cross_OfTwoVectors_IsOrthogonalAsLongAsTheParallelogramIsLarge()
    {
        double3 a = double3(1, 2, 3), b = double3(-4, 5, 6);
        double3 c = cross(a, b);
        Assert.That(dot(a, c), Is.Zero.Within(1e-12));
        Assert.That(dot(b, c), Is.Zero.Within(1e-12));
        Assert.That(lengthsq(c), Is.EqualTo(lengthsq(a) * lengthsq(b) - square(dot(a, b))).Within(1e-9));
        Assert.That(cross(double3(1, 0, 0), double3(0, 1, 0)).Equals(double3(0, 0, 1)));
    }

    [Test]
    public void Reflect_OffAPlane_FlipsTheNormalComponent()
    {
        Assert.That(reflect(double3(1, -1, 2), double3(0, 1, 0)).Equals(double3(1, 1, 2)));
    }

    [Test]
    public void Refract_IntoGlass_ObeysSnellsLaw()
    {
        double angle = radians(40.0), ratio = 1 / 1.5;
        double3 ray = refract(double3(sin(angle), -cos(angle), 0), double3(0, 1, 0), ratio);
        Assert.That(ray.x, Is.EqualTo(sin(angle) * ratio).Within(1e-15));
        Assert.That(length(ray), Is.EqualTo(1).Within(1e-15));
        Assert.That(refract(double3(sin(angle), -cos(angle), 0), double3(0, 1, 0), 1.6).Equals(new double3(0)),
            "total reflection");
    }

    [Test]
    public void OrthonormalBasis_OfAnyNormal_CompletesIt()
    {
        foreach (double3 axis in new[] { double3(0, 0, 1), double3(0, 0, -1), double3(1, 2, -3), double3(-1, 0, 0) })
        {
            double3 normal = normalize(axis);
            orthonormal_basis(normal, out double3 a, out double3 b);
            Assert.That(dot(a, b), Is.Zero.Within(1e-15));
            Assert.That(distance(cross(a, b), normal), Is.Zero.Within(1e-15));
        }
    }

    [Test]
    public void Swizzles_ReadAndWritten_GoWhereTheirLettersSay()
    {
        float3 v = float3(1, 2, 3);
        Assert.That(v.zxy.Equals(float3(3, 1, 2)));
        Assert.That(v.yzx.Equals(float3(2, 3, 1)));
        Assert.That(v.xx.Equals(float2(1, 1)));
        v.xz = float2(7, 8);
        Assert.That(v.Equals(float3(7, 2, 8)));
        double4 w = double4(v.yzx, 9);
        Assert.That(w.wzy.Equals(double3(9, 7, 8)));
    }

    [Test]
    public void Operators_OnVectors_WorkComponentByComponent()
    {
        Assert.That((int3(7, -7, 5) / 2).Equals(int3(3, -3, 2)));
        Assert.That((uint3(5) << 1 | 1u).Equals(uint3(11)));
        Assert.That(float2(1, 5) < 3, Is.EqualTo(new bool2(true, false)));
        Assert.That(any(int3(0, 0, 4) == 4));
        Assert.That(csum(int3(1, 2, 3)), Is.EqualTo(6));
        Assert.That(cmax(double3(1, 3, 2)), Is.EqualTo(3));
        Assert.That(int3(float3(1.9f, -1.9f, 0)).Equals(int3(1, -1, 0)));
    }

    [Test]
    public void Indexer_OutOfRange_Throws()
    {
        float3 v = float3(1, 2, 3);
        v[1] = 9;
        Assert.That(v.y, Is.EqualTo(9));
        Assert.Throws<ArgumentException>(() => v[3] = 0);
    }

    [Test]
    public void Bits_OfNumbers_AreCounted()
    {
        Assert.That(countbits(0b1011u), Is.EqualTo(3));
        Assert.That(ceilpow2(33), Is.EqualTo(64));
        Assert.That(lzcnt(1), Is.EqualTo(31));
        Assert.That(tzcnt(8u), Is.EqualTo(3));
        Assert.That(reversebits(1u), Is.EqualTo(0x80000000u));
        Assert.That(asfloat(asuint(-2.5f)), Is.EqualTo(-2.5f));
        Assert.That(asdouble(aslong(0.1)), Is.EqualTo(0.1));
    }

    [Test]
    public void Types_ThatBuffersHold_HaveUnitysSizes()
    {
        Assert.That(Marshal.SizeOf<float3>(), Is.EqualTo(12));
        Assert.That(Marshal.SizeOf<float4x4>(), Is.EqualTo(64));
        Assert.That(Marshal.SizeOf<double3>(), Is.EqualTo(24));
        Assert.That(Marshal.SizeOf<bool3>(), Is.EqualTo(3));
    }

    [Test]
    public void ToString_OfAVector_NamesItsType()
    {
        Assert.That(float3(1, 2.5f, 3).ToString(), Is.EqualTo("float3(1f, 2.5f, 3f)"));
        Assert.That(int2(1, 2).ToString(), Is.EqualTo("int2(1, 2)"));
        Assert.That(Rotation.identity.ToString(), Is.EqualTo("quaternion(0f, 0f, 0f, 1f)"));
    }

    [Test]
    public void Quaternion_OfEulerAngles_IsUnitysAndTurnsAlike()
    {
        Quaternion unity = Quaternion.Euler(15, 25, 35);
        Vector3 turned = unity * new Vector3(1, 2, 3);
        Near.Point(mul(_turn, float3(1, 2, 3)), turned.x, turned.y, turned.z, 1e-6);
        Near.Point(mul(new float3x3(_turn), float3(1, 2, 3)), turned.x, turned.y, turned.z, 1e-6);
        Assert.That(unity == _turn);
    }

    [Test]
    public void Quaternion_OfAMatrix_GivesTheRotationBack()
    {
        var random = new System.Random(7);
        for (int i = 0; i < 100; i++)
        {
            quaternion q = Rotation.Euler((float)random.NextDouble() * 6, (float)random.NextDouble() * 6,
                (float)random.NextDouble() * 6);
            Assert.That(abs(dot(q, new quaternion(new float3x3(q)))), Is.EqualTo(1).Within(1e-6));
        }
    }

    [Test]
    public void Slerp_HalfWay_HasHalfTheAngle()
    {
        quaternion half = slerp(Rotation.identity, Rotation.RotateY(1.2f), 0.5f);
        Assert.That(angle(Rotation.identity, half), Is.EqualTo(0.6).Within(1e-6));
        Near.Point(mul(inverse(half), mul(half, float3(1, 2, 3))), 1, 2, 3, 1e-6);
    }

    [Test]
    public void LookRotation_AlongADirection_TurnsForwardToIt()
    {
        float3 ahead = normalize(float3(1, 2, 3));
        Near.Point(mul(Rotation.LookRotation(ahead, up()), forward()), ahead.x, ahead.y, ahead.z, 1e-6);
        Assert.That(Rotation.LookRotationSafe(up(), up()).Equals(Rotation.identity));
    }

    [Test]
    public void Trs_OfThePose_IsUnitysMatrix()
    {
        float4x4 m = Affine.TRS(float3(10, -20, 30), _turn, float3(2, 3, 0.5f));
        Matrix4x4 expected =
            Matrix4x4.TRS(new Vector3(10, -20, 30), Quaternion.Euler(15, 25, 35), new Vector3(2, 3, 0.5f));
        Near.Matrix((Matrix4x4)m, DoubleMatrix.Fill((i, j) => expected[i, j]), 1e-6);
        Vector3 moved = expected.MultiplyPoint3x4(new Vector3(1, 2, 3));
        Near.Point(transform(m, float3(1, 2, 3)), moved.x, moved.y, moved.z, 1e-5);
        float4x4 pose = float4x4(_turn, float3(1, 2, 3));
        Near.Matrix((Matrix4x4)mul(fastinverse(pose), pose), DoubleMatrix.Identity(), 1e-6);
    }

    [Test]
    public void Product_OfMatrices_IsTheTextbooks()
    {
        float4x4 a = Numbers(1), b = Numbers(2);
        Near.Matrix((Matrix4x4)mul(a, b), DoubleMatrix.Product(Cells(a), Cells(b)), 1e-6);
        float4 v = mul(a, float4(1, 2, 3, 4));
        var expected = DoubleMatrix.Apply(Cells(a), 1, 2, 3, 4);
        Near.Point(new Vector3(v.x, v.y, v.z), expected.X, expected.Y, expected.Z, 1e-5);
        Assert.That(v.w, Is.EqualTo(expected.W).Within(1e-5));
    }

    [Test]
    public void Inverse_OfMatrices_TimesThemIsOne()
    {
        for (int seed = 0; seed < 50; seed++)
        {
            float4x4 m = Numbers(seed);
            float tolerance = 1e-5f / min(1, abs(determinant(m)));
            Near.Matrix((Matrix4x4)mul(m, inverse(m)), DoubleMatrix.Identity(), tolerance);
            Assert.That(determinant(m), Is.EqualTo(((Matrix4x4)m).determinant).Within(1e-6));
            float3x3 part = float3x3(m.c0.xyz, m.c1.xyz, m.c2.xyz);
            float3 v = mul(inverse(part), mul(part, float3(1, 2, 3)));
            Assert.That(distance(v, float3(1, 2, 3)), Is.Zero.Within(1e-5f / min(1, abs(determinant(part)))));
        }
    }

    static float4x4 Numbers(int seed)
    {
        var random = new System.Random(seed);
        float4x4 m = default;
        for (int i = 0; i < 16; i++)
            m[i / 4][i % 4] = (float)random.NextDouble() * 2 - 1;
        return m;
    }

    static double[,] Cells(float4x4 m) => DoubleMatrix.Fill((row, column) => m[column][row]);
}
