using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using FsCheck;
using FsCheck.Fluent;
using Glint.Core;
using Glint.Tests;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Host.Tests;

/// <summary>Meshes written in any format read back bit for bit.</summary>
public sealed class MeshFileProperties
{
    sealed record Triangles(float3[] Vertices, int[] Indices);

    static readonly Gen<float> FiniteFloats = Gen.OneOf(
        Gen.Choose(int.MinValue, int.MaxValue).Select(BitConverter.Int32BitsToSingle).Where(float.IsFinite),
        Gen.Choose(-1000, 1000).Select(number => number / 8f),
        Gen.Elements(0f, -0f, float.Epsilon, -float.MaxValue, float.MaxValue, 1e-38f));

    static readonly Gen<Triangles> Meshes =
        from vertexCount in Gen.Choose(1, 40)
        from numbers in FiniteFloats.ArrayOf(3 * vertexCount)
        from triangleCount in Gen.Choose(1, 60)
        from indices in Gen.Choose(0, vertexCount - 1).ArrayOf(3 * triangleCount)
        select new Triangles(Enumerable.Range(0, vertexCount)
            .Select(i => new float3(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2])).ToArray(), indices);

    [Test]
    public void Obj_WrittenAndRead_IsTheSame() => ForAllMeshes(mesh =>
    {
        var read = Read("mesh.obj", MeshFileWriter.Obj(mesh.Vertices, mesh.Indices));
        return read.Vertices.Select(Bits).SequenceEqual(mesh.Vertices.Select(Bits))
            && read.Indices.SequenceEqual(mesh.Indices);
    });

    [Test]
    public void StlText_WrittenAndRead_HasTheSameCorners() =>
        ForAllMeshes(mesh => HasCornersOf(mesh, Read("mesh.stl", MeshFileWriter.StlText(mesh.Vertices, mesh.Indices))));

    [Test]
    public void StlBinary_WrittenAndRead_HasTheSameCorners() =>
        ForAllMeshes(mesh =>
            HasCornersOf(mesh, Read("mesh.stl", MeshFileWriter.StlBinary(mesh.Vertices, mesh.Indices, "solid"))));

    [Test]
    public void Coordinate_AnyDoubleInAnyNotation_IsRoundedOnce() => Prop.ForAll(Arb.From(Decimals), text =>
    {
        // The runtime's own parser rounds correctly; an inch is 0.0254 m.
        float expected = (float)(double.Parse(text, CultureInfo.InvariantCulture) * 0.0254);
        if (!float.IsFinite(expected))
            return true;
        var mesh = MeshFileReader.Read(new MemoryStream(Encoding.ASCII.GetBytes($"v {text} 0 0\nf 1 1 1")), "mesh.obj",
            LengthUnit.Parse("in"), UpAxis.Y);
        return BitConverter.SingleToInt32Bits(mesh.Vertices[0].x) == BitConverter.SingleToInt32Bits(expected);
    }).Check(Config.QuickThrowOnFailure.WithMaxTest(5000));

    static readonly Gen<string> Decimals =
        from value in Gen.OneOf(FiniteFloats.Select(value => (double)value),
            ArbMap.Default.GeneratorFor<double>().Where(double.IsFinite))
        from format in Gen.Elements("R", "G9", "G17", "G25", "E3", "E20", "F6", "F12")
        select value.ToString(format, CultureInfo.InvariantCulture);

    static void ForAllMeshes(Func<Triangles, bool> holds) =>
        Prop.ForAll(Arb.From(Meshes), holds).Check(Config.QuickThrowOnFailure.WithMaxTest(200));

    static MeshFile Read(string name, byte[] content) =>
        MeshFileReader.Read(new MemoryStream(content), name, LengthUnit.Parse("m"), UpAxis.Y);

    static bool HasCornersOf(Triangles mesh, MeshFile read) =>
        read.Indices.Select(index => Bits(read.Vertices[index]))
            .SequenceEqual(mesh.Indices.Select(index => Bits(mesh.Vertices[index])));

    // Compared as bits, since -0 equals 0.
    static (int, int, int) Bits(float3 point) =>
        (BitConverter.SingleToInt32Bits(point.x), BitConverter.SingleToInt32Bits(point.y),
            BitConverter.SingleToInt32Bits(point.z));
}
