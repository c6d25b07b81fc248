using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Text;
using Glint.Core;
using Glint.Tests;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Host.Tests;

/// <summary>
/// Damaged files are read, or refused in one line: no other exception, no long wait, no allocation by a size that the
/// file claims.
/// </summary>
public sealed class MeshFileFuzzTests
{
    const int Cases = 4000;
    const long MaxBytes = 100_000_000;
    static readonly TimeSpan LongestTime = TimeSpan.FromSeconds(1);

    static readonly float3[] Vertices = { new(0, 0, 0), new(1.25f, 0, 0), new(0, -3e10f, 0), new(0, 0, 1e-20f) };
    static readonly int[] Indices = { 0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 2, 3 };

    static readonly string[] Splinters =
    {
        "nan", "-", "1e999", "-1e-999", "99999999999999999999", "\0", "\\\n", "\\",
        "\r", "\n", "#", "/", "//", "-1", "0", "\ufeff",
        "f 1 2 3 4 5\n", "v 1 2 3\n", "solid ", "endsolid", "facet normal 0 0 0", "\uffff\uffff"
    };

    [Test]
    public void Obj_Damaged_IsReadOrRefused() => Fuzz("mesh.obj", MeshFileWriter.Obj(Vertices, Indices), 1);

    [Test]
    public void ObjOfAllForms_Damaged_IsReadOrRefused() => Fuzz("mesh.obj", Encoding.UTF8.GetBytes(
        "\ufeff# c \\\r\nmtllib a.mtl\r\nv 0 0 0 1\r\nv 1 0 0 .5 .5 .5\r\nv +1.5e-3 -1E2 .25\r\nvt 0 0\r\nvn 0 0 1\r\n"
        + "f 1/1/1 2//1 \\\r\n3/1\r\nf -1 -2 -3 # d\r\nl 1 2"), 2);

    [Test]
    public void StlText_Damaged_IsReadOrRefused() => Fuzz("mesh.stl", MeshFileWriter.StlText(Vertices, Indices), 3);

    [Test]
    public void StlBinary_Damaged_IsReadOrRefused() => Fuzz("mesh.stl", MeshFileWriter.StlBinary(Vertices, Indices), 4);

    [Test]
    public void StlBinaryBeginningWithSolid_Damaged_IsReadOrRefused() =>
        Fuzz("mesh.stl", MeshFileWriter.StlBinary(Vertices, Indices, "solid"), 5);

    static void Fuzz(string name, byte[] good, int seed)
    {
        var random = new Random(seed);
        for (int i = 0; i < Cases; i++)
        {
            byte[] content = good;
            for (int damage = random.Next(1, 4); damage > 0; damage--)
                content = Damage(content, random);
            AssertReadOrRefused(name, content, $"seed {seed}, case {i}: {Convert.ToBase64String(content)}");
        }
    }

    static byte[] Damage(byte[] content, Random random)
    {
        int at = random.Next(content.Length + 1);
        int length = random.Next(Math.Min(60, content.Length - at) + 1);
        var before = content.Take(at);
        switch (random.Next(6))
        {
            case 0:
                return content.Select(
                value => random.Next(content.Length) < 3 ? (byte)(value ^ 1 << random.Next(8)) : value).ToArray();
            case 1: return before.ToArray();
            case 2: return before.Concat(content.Skip(at + length)).ToArray();
            case 3: return before.Concat(content.Skip(at).Take(length)).Concat(content.Skip(at)).ToArray();
            case 4:
                return before.Concat(Encoding.UTF8.GetBytes(Splinters[random.Next(Splinters.Length)]))
                .Concat(content.Skip(at)).ToArray();
            default:
                return before.Concat(content.Skip(at).Take(length).Select(_ => (byte)random.Next(256)))
                .Concat(content.Skip(at + length)).ToArray();
        }
    }

    static void AssertReadOrRefused(string name, byte[] content, string which)
    {
        long before = GC.GetAllocatedBytesForCurrentThread();
        var watch = Stopwatch.StartNew();
        try
        {
            var mesh = MeshFileReader.Read(new MemoryStream(content), name, LengthUnit.Parse("m"), UpAxis.Z);
            bool sound = mesh.TriangleCount > 0 && mesh.Indices.Length % 3 == 0
                && mesh.Indices.All(index => index >= 0 && index < mesh.Vertices.Length)
                && mesh.Vertices.All(vertex => float.IsFinite(vertex.x) && float.IsFinite(vertex.y)
                    && float.IsFinite(vertex.z));
            if (!sound)
                Assert.Fail($"{which} was read as a mesh that is none");
        }
        catch (GlintException error) when (error.Message.StartsWith(name) && !error.Message.Any(char.IsControl))
        {
        }
        catch (Exception error) when (error is not AssertionException)
        {
            Assert.Fail($"{which}: {error}");
        }
        if (watch.Elapsed > LongestTime || GC.GetAllocatedBytesForCurrentThread() - before > MaxBytes)
            Assert.Fail($"{which} took {watch.ElapsedMilliseconds} ms and "
                + $"{GC.GetAllocatedBytesForCurrentThread() - before} bytes");
    }
}
