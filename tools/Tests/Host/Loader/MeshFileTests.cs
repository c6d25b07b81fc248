using System;
using System.Diagnostics;
using System.Linq;
using Glint.Core;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Host.Tests;

public sealed class MeshFileTests
{
    const int Guid = 3;
    const string Path = "Assets/Hull.asset";
    static readonly float[] _triangle = [0, 0, 0, 1, 0, 0, 0, 0, 1];

    TemporaryProject _project;

    [SetUp]
    public void Create() => _project = new TemporaryProject();

    [TearDown]
    public void Delete() => _project.Dispose();

    [Test]
    public void Plate_WithNormalsAndTexture_IsTheFiles()
    {
        // Two triangles, 2 m x 2 m, facing +y: position, normal, texture coordinates; 32 bytes a vertex.
        MeshText plate = new() { Name = "Plate", VertexCount = 4, Indices = [0, 1, 2, 0, 2, 3] };
        plate.Channels[0] = (0, 0, 0, 3);
        plate.Channels[1] = (0, 12, 0, 3);
        plate.Channels[4] = (0, 24, 0, 2);
        plate.VertexData = MeshText.Floats(
            -1, 0, -1, 0, 1, 0, 0, 0,
            -1, 0, 1, 0, 1, 0, 0, 1,
            1, 0, 1, 0, 1, 0, 1, 1,
            1, 0, -1, 0, 1, 0, 1, 0);
        plate.SubMeshes.Add((0, 6, 0, 0));
        Mesh mesh = Load(plate);
        Assert.That(mesh.name, Is.EqualTo("Plate"));
        Assert.That(mesh.vertices.Select(v => (v.x, v.y, v.z)),
            Is.EqualTo(new[] { (-1f, 0f, -1f), (-1f, 0f, 1f), (1f, 0f, 1f), (1f, 0f, -1f) }));
        Assert.That(mesh.normals.Select(n => n.y), Is.All.EqualTo(1f));
        Assert.That(mesh.GetIndices(0), Is.EqualTo(new[] { 0, 1, 2, 0, 2, 3 }));
        Assert.That((mesh.bounds.center.z, mesh.bounds.extents.x, mesh.isReadable), Is.EqualTo((3f, 4f, true)),
            "Unity takes the bounds from the file");
    }

    [TestCase(1, "0000003c", 0f, 1f, TestName = "Float16")]
    [TestCase(2, "00ff", 0f, 1f, TestName = "UNorm8")]
    [TestCase(3, "7f80", 1f, -1f, TestName = "SNorm8")]
    [TestCase(4, "ffff0000", 1f, 0f, TestName = "UNorm16")]
    [TestCase(5, "ff7f0080", 1f, -1f, TestName = "SNorm16")]
    [TestCase(6, "00c8", 0f, 200f, TestName = "UInt8")]
    [TestCase(7, "00c8", 0f, -56f, TestName = "SInt8")]
    [TestCase(8, "0100ffff", 1f, 65535f, TestName = "UInt16")]
    [TestCase(9, "0100ffff", 1f, -1f, TestName = "SInt16")]
    [TestCase(10, "01000000feffffff", 1f, 4294967294f, TestName = "UInt32")]
    [TestCase(11, "01000000feffffff", 1f, -2f, TestName = "SInt32")]
    public void NumberFormat_OfAChannel_IsDecoded(int format, string hex, float first, float second)
    {
        VertexChannel channel = new(0, 0, format, 2);
        byte[] data = Convert.FromHexString(hex);
        Assert.That(channel.End, Is.EqualTo(data.Length));
        Assert.That(channel.Read(data, data.Length, 1), Is.EqualTo(new[] { first, second }));
    }

    [Test]
    public void TwoStreams_WithHalfFloats_AreReadEachFromItsStart()
    {
        // Stream 0: three half floats padded to 8 bytes, three vertices: 24 bytes. Stream 1 starts at 32.
        MeshText text = new() { VertexCount = 3, Indices = [0, 1, 2] };
        text.Channels[0] = (0, 0, 1, 3);
        text.Channels[3] = (1, 0, 2, 4);
        byte[] data = new byte[32 + 12];
        for (int vertex = 0; vertex < 3; vertex++)
        {
            BitConverter.TryWriteBytes(data.AsSpan(8 * vertex), (Half)(vertex + 0.5f));
            data[32 + 4 * vertex] = (byte)(51 * vertex);
        }
        text.VertexData = data;
        text.SubMeshes.Add((0, 3, 0, 0));
        Mesh mesh = Load(text);
        Assert.That(mesh.vertices.Select(v => v.x), Is.EqualTo(new[] { 0.5f, 1.5f, 2.5f }));
        Assert.That(mesh.colors.Select(c => c.r), Is.EqualTo(new[] { 0f, 0.2f, 0.4f }).Within(1e-6f));
    }

    [Test]
    public void SubMeshes_WithBaseVertexAndWideIndices_HaveTheirOwn()
    {
        MeshText text = MeshText.Of([.. _triangle, .. _triangle, 5, 5, 5], 0, 1, 2, 0, 1, 2, 3);
        text.WideIndices = true;
        text.SubMeshes = [(0, 3, 0, 3), (12, 4, 2, 0)];
        Mesh mesh = Load(text);
        Assert.That(mesh.GetIndices(0), Is.EqualTo(new[] { 3, 4, 5 }));
        Assert.That(mesh.GetIndices(1), Is.EqualTo(new[] { 0, 1, 2, 3 }));
        Assert.That((mesh.GetTopology(0), mesh.GetTopology(1)),
            Is.EqualTo((MeshTopology.Triangles, MeshTopology.Quads)));
    }

    [Test]
    public void Mesh_NotReadable_SaysSo()
    {
        MeshText text = MeshText.Of(_triangle, 0, 1, 2);
        text.IsReadable = false;
        Assert.That(Load(text).isReadable, Is.False);
    }

    [Test]
    public void Mesh_AskedForTwice_IsOneObject()
    {
        Mesh first = Load(MeshText.Of(_triangle, 0, 1, 2));
        Assert.That(_project.Project.LoadAsset(Path, typeof(Mesh)), Is.SameAs(first));
        string scene = UnityText.Object(10, "A", components: UnityText.Component(12))
            + UnityText.MeshFilter(12, 10, UnityText.Asset(4300000, Guid, 2));
        Assert.That(_project.LoadScene(UnityText.Scene(scene, 11)).Single().GetComponent<MeshFilter>().sharedMesh,
            Is.SameAs(first));
    }

    [Test]
    public void Index_BeyondTheVertices_IsRefused() => AssertRefused(MeshText.Of(_triangle, 0, 1, 3).ToString(),
        "Assets/Hull.asset: Mesh 'Hull': submesh 0 has index 3, and the mesh has 3 vertices: correct the mesh");

    [Test]
    public void IndexBuffer_ShorterThanTheSubMesh_IsRefused()
    {
        MeshText text = MeshText.Of(_triangle, 0, 1, 2);
        text.SubMeshes = [(0, 6, 0, 0)];
        AssertRefused(text.ToString(), "Assets/Hull.asset: Mesh 'Hull': submesh 0 has 6 indices from number 0 on, "
            + "and m_IndexBuffer holds 3: restore the file");
    }

    [Test]
    public void VertexData_OfTheWrongSize_AreRefused()
    {
        AssertRefused(MeshText.Of(_triangle, 0, 1, 2).ToString().Replace("m_DataSize: 36", "m_DataSize: 40"),
            "Assets/Hull.asset: Mesh 'Hull': its vertex data are 36 bytes long, "
                + "and m_DataSize says 40: restore the file");
        AssertRefused(MeshText.Of(_triangle, 0, 1, 2).ToString()
            .Replace("m_VertexCount: 3", "m_VertexCount: 2000000000"),
            "Assets/Hull.asset: Mesh 'Hull': 2000000000 vertices need 24000000000 bytes, "
                + "and the file has 36: restore the file");
        AssertRefused(MeshText.Of(_triangle, 0, 1, 2).ToString().Replace("_typelessdata: 0", "_typelessdata: g"),
            "Assets/Hull.asset: Mesh 'Hull': _typelessdata is not hexadecimal text: restore the file");
    }

    [Test]
    public void CompressedMesh_IsRefusedWithTheRemedy() => AssertRefused(MeshText.Of(_triangle, 0, 1, 2).ToString()
        .Replace("m_MeshCompression: 0", "m_MeshCompression: 2"),
        "Assets/Hull.asset: Mesh 'Hull' is compressed: set its Mesh Compression to Off");

    [Test]
    public void Mesh_Of9000Vertices_LoadsInUnder200Milliseconds()
    {
        Load(Grid(8));
        string text = Grid(95).ToString();
        _project.Write("Assets/Sea.asset", text, 4);
        Stopwatch watch = Stopwatch.StartNew();
        Mesh mesh = (Mesh)_project.Project.LoadAsset("Assets/Sea.asset", typeof(Mesh));
        Assert.That(watch.ElapsedMilliseconds, Is.LessThan(200));
        Assert.That(mesh.vertexCount, Is.EqualTo(9025));
    }

    [Test]
    public void Mesh_OfHalfAMillionVertices_Loads()
    {
        Mesh mesh = Load(Grid(708));
        Assert.That(mesh.vertexCount, Is.EqualTo(501264));
        Assert.That(mesh.GetIndices(0), Has.Length.EqualTo(6 * 707 * 707));
    }

    static MeshText Grid(int side)
    {
        float[] positions = new float[3 * side * side];
        for (int i = 0; i < side * side; i++)
            (positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]) = (i % side, 0.001f * i, i / side);
        uint[] indices = (from row in Enumerable.Range(0, side - 1)
                          from column in Enumerable.Range(0, side - 1)
                          let corner = (uint)(row * side + column)
                          from index in new[]
                          {
                              corner, corner + (uint)side, corner + 1, corner + 1, corner + (uint)side,
                              corner + (uint)side + 1
                          }
                          select index).ToArray();
        MeshText text = MeshText.Of(positions, indices);
        text.WideIndices = true;
        return text;
    }

    Mesh Load(MeshText text)
    {
        _project.Write(Path, text.ToString(), Guid);
        return (Mesh)_project.Project.LoadAsset(Path, typeof(Mesh));
    }

    void AssertRefused(string text, string message)
    {
        _project.Write(Path, text, Guid);
        Assert.That(Assert.Throws<GlintException>(() => _project.Project.LoadAsset(Path, typeof(Mesh))).Message,
            Is.EqualTo(message));
    }
}
