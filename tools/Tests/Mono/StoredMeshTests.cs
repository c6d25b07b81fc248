using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Tests.Mono;

/// <summary>Mono makes the stored meshes, which .NET made, bit for bit.</summary>
public sealed class StoredMeshTests
{
    [Test]
    public void Snapshots_OfEachStoredSea_AreTheStoredBits([Values(0, 1)] int number)
    {
        var recipe = StoredSeas.All[number];
        var surface = new SeaSurface(recipe.Settings);
        for (int i = 0; i < recipe.Times.Count; i++)
        {
            var mesh = surface.Mesh(recipe.Times[i]);
            AssertStored($"{recipe.Name}/Snapshot {i + 1:00}", mesh.Vertices, mesh.Indices);
        }
    }

    [Test]
    public void Ship_IsTheStoredBits()
    {
        var ship = ShipModel.Build(ShipSettings.Default);
        AssertStored("Ship/Ship", ship.Vertices, ship.Indices);
    }

    static void AssertStored(string name, IReadOnlyList<float3> vertices, IReadOnlyList<int> indices)
    {
        var fields = File.ReadLines(Path.Combine(ProjectFolder.FullPath, "Meshes", name + ".asset"))
            .Select(line => line.Trim().Split(new[] { ": " }, 2, StringSplitOptions.None))
            .Where(field => field.Length == 2).ToLookup(field => field[0], field => field[1]);
        Assert.That(vertices.Count, Is.EqualTo(int.Parse(fields["m_VertexCount"].Single())), name);
        byte[] data = Bytes(fields["_typelessdata"].Single());
        int stride = data.Length / vertices.Count;
        for (int i = 0; i < vertices.Count; i++)
            for (int axis = 0; axis < 3; axis++)
                if (BitConverter.SingleToInt32Bits(vertices[i][axis])
                    != BitConverter.ToInt32(data, i * stride + 4 * axis))
                    Assert.Fail($"{name}, vertex {i}, axis {axis}: {vertices[i][axis]:R}, and stored is "
                        + $"{BitConverter.ToSingle(data, i * stride + 4 * axis):R}");

        byte[] stored = Bytes(fields["m_IndexBuffer"].Single());
        Assert.That(fields["m_IndexFormat"].Single(), Is.EqualTo("0"), "indices of 16 bits");
        Assert.That(indices, Is.EqualTo(
            Enumerable.Range(0, stored.Length / 2).Select(i => (int)BitConverter.ToUInt16(stored, 2 * i))), name);
    }

    static byte[] Bytes(string hexadecimal) => Enumerable.Range(0, hexadecimal.Length / 2)
        .Select(i => Convert.ToByte(hexadecimal.Substring(2 * i, 2), 16)).ToArray();
}
