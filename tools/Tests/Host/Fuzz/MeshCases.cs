using System;
using System.IO;
using System.Linq;
using System.Text;
using Glint.Core;
using Glint.Tests;
using Unity.Mathematics;

namespace Glint.Host.Tests;

/// <summary>Mesh files of random vertices, faces and statements, most of them damaged.</summary>
static class MeshCases
{
    static readonly float[] Coordinates =
    [
        0, -0f, 1, -1, 0.5f, 1.25f, 1e-3f, -3, 100, 1e-20f, 1e-30f, float.Epsilon, -1e-40f, 3e10f, 1e7f, -1.1e7f, 1e20f,
        float.MaxValue, float.MinValue, float.NaN, float.PositiveInfinity
    ];

    static readonly string[] ObjLines =
    [
        "# c \\\r\nmtllib a.mtl", "v 0 0 0 1", "v 1 0 0 .5 .5 .5", "v +1.5e-3 -1E2 .25", "vt 0 0", "vn 0 0 1", "vp 1",
        "f 1/1/1 2//1 \\\r\n3/1", "f -1 -2 -3 # d", "l 1 2", "p 1", "usemtl a b", "g", "s off",
        "f 1 2 3 4", "f 4 3 2 1 2", "\\", "curv 0 1 1 2"
    ];

    static readonly byte[][] Others = ObjLines.Select(Encoding.ASCII.GetBytes).ToArray();

    static readonly string[] Names = ["mesh.obj", "mesh.stl"];

    /// <summary>A file by name and content.</summary>
    public static (string Name, byte[] Content) Make(Random random)
    {
        // Most coordinates are valid; otherwise few files would be read to the end.
        bool isSane = random.Next(2) == 0;
        float Coordinate() =>
            isSane || random.Next(8) > 0 ? random.Next(-4, 5) * 0.5f : Coordinates[random.Next(Coordinates.Length)];
        var vertices = Enumerable.Range(0, random.Next(1, 12))
            .Select(_ => new float3(Coordinate(), Coordinate(), Coordinate())).ToArray();
        var indices = Enumerable.Range(0, 3 * random.Next(0, 12)).Select(_ => random.Next(vertices.Length)).ToArray();
        int form = random.Next(4);
        byte[] content = form switch
        {
            0 => MeshFileWriter.Obj(vertices, indices),
            1 => Encoding.UTF8.GetBytes(ObjOfAllForms(vertices.Length, random)
                + Encoding.ASCII.GetString(MeshFileWriter.Obj(vertices, indices))),
            2 => MeshFileWriter.StlText(vertices, indices),
            _ => MeshFileWriter.StlBinary(vertices, indices, random.Next(2) == 0 ? "solid" : "")
        };
        return (Names[form / 2], random.Next(4) == 0 ? content : Damage.Of(content, random, Others));
    }

    /// <summary>Reads a file; the result must be a valid mesh.</summary>
    public static Outcome Read(Random random)
    {
        var (name, content) = Make(random);
        var unit = LengthUnit.All[random.Next(LengthUnit.All.Count)];
        var up = random.Next(2) == 0 ? UpAxis.Y : UpAxis.Z;
        var outcome = Outcome.Of(() =>
        {
            var mesh = MeshFileReader.Read(new MemoryStream(content), name, unit, up);
            bool isSound = mesh.TriangleCount > 0 && mesh.Indices.Length % 3 == 0
                && mesh.Indices.All(index => index >= 0 && index < mesh.Vertices.Length)
                && mesh.Vertices.All(vertex => math.all(math.isfinite(vertex)))
                && mesh.CountDegenerate() <= mesh.TriangleCount;
            return isSound ? Outcome.Done : Outcome.Finding("read as a mesh that is none");
        }, [name]);
        return outcome.Verdict
            == Verdict.Finding ? Outcome.Finding($"{outcome.Text}\n{Convert.ToBase64String(content)}") : outcome;
    }

    static string ObjOfAllForms(int vertices, Random random)
    {
        var text = new StringBuilder(random.Next(2) == 0 ? "\ufeff" : "");
        for (int i = random.Next(6); i > 0; i--)
            text.Append(ObjLines[random.Next(ObjLines.Length)]).Append(random.Next(2) == 0 ? "\r\n" : "\n");
        // A polygon of many corners, which may be concave, folded or self-intersecting.
        text.Append('f');
        for (int i = random.Next(3, 30); i > 0; i--)
            text.Append(' ').Append(random.Next(1, vertices + 1));
        return text.Append('\n').ToString();
    }
}
