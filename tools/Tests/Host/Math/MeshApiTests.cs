using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Rendering;

namespace Glint.Host.Tests;

public class MeshApiTests
{
    static readonly Vector3[] _square = { new(0, 0, 0), new(0, 0, 2), new(2, 0, 2), new(2, 0, 0) };

    [Test]
    public void Mesh_Fresh_IsEmptyAndReadable()
    {
        var mesh = new Mesh();
        Assert.That((mesh.vertexCount, mesh.subMeshCount, mesh.triangles.Length, mesh.indexFormat),
            Is.EqualTo((0, 1, 0, IndexFormat.UInt16)));
        Assert.That(mesh.isReadable);
    }

    [Test]
    public void Triangles_Set_MeasureTheBounds()
    {
        Mesh mesh = Square();
        Near.Point(mesh.bounds.center, 1, 0, 1, 0);
        Near.Point(mesh.bounds.size, 2, 0, 2, 0);
        SubMeshDescriptor part = mesh.GetSubMesh(0);
        Assert.That((part.indexStart, part.indexCount, part.firstVertex, part.vertexCount), Is.EqualTo((0, 6, 0, 4)));
    }

    [Test]
    public void Triangles_BeyondTheVertices_AreRefusedWithUnitysError()
    {
        Mesh mesh = Square();
        Assert.That(Errors(() => mesh.triangles = new[] { 0, 1, 4 }).Single(),
            Does.StartWith("Failed setting triangles. Some indices are referencing out of bounds vertices."));
        Assert.That(mesh.triangles, Has.Length.EqualTo(6));
        Assert.That(Errors(() => mesh.SetTriangles(new[] { 0, 1, -1 }, 0)), Has.Count.EqualTo(1));
    }

    [TestCase(2, 0, "The number of supplied triangle indices must be a multiple of 3.")]
    [TestCase(3, 1, "Submesh index is out of bounds.")]
    public void Triangles_Malformed_AreRefused(int count, int subMesh, string message)
    {
        Mesh mesh = Square();
        Assert.That(Errors(() => mesh.SetTriangles(new int[count], subMesh)).Single(),
            Is.EqualTo("Failed setting triangles. " + message));
    }

    [Test]
    public void Indices_BeyondSixteenBits_NeedTheWideFormat()
    {
        var mesh = new Mesh();
        mesh.SetVertices(new Vector3[70000]);
        Assert.That(Errors(() => mesh.SetTriangles(new[] { 0, 1, 69999 }, 0)).Single(), Does.Contain("UInt32"));
        mesh.indexFormat = IndexFormat.UInt32;
        mesh.SetTriangles(new[] { 0, 1, 69999 }, 0);
        Assert.That(mesh.GetIndices(0)[2], Is.EqualTo(69999));
    }

    [Test]
    public void Vertices_FewerThanReferenced_AreRefused()
    {
        Mesh mesh = Square();
        Assert.That(Errors(() => mesh.vertices = new Vector3[3]).Single(),
            Does.StartWith("Mesh.vertices is too small."));
        Assert.That(mesh.vertexCount, Is.EqualTo(4));
    }

    [Test]
    public void Normals_OfAnotherCount_AreRefused()
    {
        Mesh mesh = Square();
        Assert.That(Errors(() => mesh.normals = new Vector3[3]).Single(),
            Is.EqualTo("Mesh.normals is out of bounds. "
                + "The supplied array needs to be the same size as the Mesh.vertices array."));
    }

    [Test]
    public void NotReadable_Read_LogsUnitysErrorAndGivesNothing()
    {
        Mesh mesh = Square();
        mesh.name = "X";
        mesh.UploadMeshData(true);
        Vector3[] vertices = null;
        Assert.That(Errors(() => vertices = mesh.vertices).Single(),
            Is.EqualTo("Not allowed to access vertices on mesh 'X' (isReadable is false; "
                + "Read/Write must be enabled in import settings)"));
        Assert.That(vertices, Is.Empty);
        Assert.That(Errors(() => Assert.That(mesh.triangles, Is.Empty)), Has.Count.EqualTo(1));
        Assert.That(Errors(() => mesh.vertices = new Vector3[9]), Has.Count.EqualTo(1));
        Assert.That(Assert.Throws<InvalidOperationException>(() => Mesh.AcquireReadOnlyMeshData(mesh)).Message,
            Does.Contain("mesh 'X'"));
        Assert.That((mesh.vertexCount, mesh.GetIndexCount(0)), Is.EqualTo((4, 6u)), "counts stay known");
    }

    [Test]
    public void SubMeshes_SetOneByOne_ShareOneIndexBuffer()
    {
        Mesh mesh = Square();
        mesh.subMeshCount = 3;
        mesh.SetIndices(new[] { 0, 1, 2, 3 }, MeshTopology.Quads, 2);
        mesh.SetIndices(new[] { 0, 2 }, MeshTopology.Lines, 1);
        Assert.That(Enumerable.Range(0, 3).Select(i => (mesh.GetIndexStart(i), mesh.GetIndexCount(i))),
            Is.EqualTo(new[] { (0u, 6u), (6u, 2u), (8u, 4u) }));
        Assert.That(mesh.GetIndices(2), Is.EqualTo(new[] { 0, 1, 2, 3 }));
        Assert.That(mesh.GetTriangles(2), Is.EqualTo(new[] { 0, 1, 2, 0, 2, 3 }));
        Assert.That(mesh.triangles, Has.Length.EqualTo(12), "without the lines");
        Assert.That(Errors(() => mesh.GetTriangles(1)).Single(),
            Is.EqualTo("Failed getting triangles. Submesh topology is lines or points."));
        mesh.SetTriangles(new[] { 0, 1, 2 }, 0);
        Assert.That(mesh.GetIndices(2), Is.EqualTo(new[] { 0, 1, 2, 3 }));
        Assert.Throws<IndexOutOfRangeException>(() => mesh.GetSubMesh(3));
    }

    [Test]
    public void BaseVertex_OfASubMesh_IsAddedWhenAsked()
    {
        Mesh mesh = Square();
        mesh.SetTriangles(new[] { 0, 1, 2 }, 0, true, 1);
        Assert.That(mesh.GetTriangles(0), Is.EqualTo(new[] { 1, 2, 3 }));
        Assert.That(mesh.GetTriangles(0, false), Is.EqualTo(new[] { 0, 1, 2 }));
        Assert.That(mesh.GetSubMesh(0).firstVertex, Is.EqualTo(1));
        Assert.That(Errors(() => mesh.SetTriangles(new[] { 0, 1, 2 }, 0, true, 2)), Has.Count.EqualTo(1));
    }

    [Test]
    public void RecalculateNormals_OfClockwiseTriangles_FaceTheViewer()
    {
        Mesh mesh = Square();
        mesh.RecalculateNormals();
        Assert.That(mesh.normals, Is.All.EqualTo(Vector3.up));
    }

    [Test]
    public void RecalculateBounds_AfterMovingVertices_FollowThem()
    {
        Mesh mesh = Square();
        mesh.SetVertices(_square.Select(v => v + Vector3.up * 3).ToList());
        Assert.That(mesh.bounds.center.y, Is.Zero);
        mesh.RecalculateBounds();
        Assert.That(mesh.bounds.center.y, Is.EqualTo(3));
    }

    [Test]
    public void MeshData_OfAMesh_IsASnapshot()
    {
        Mesh mesh = Square();
        mesh.SetTriangles(new[] { 0, 1, 2 }, 0, true, 1);
        using Mesh.MeshDataArray array = Mesh.AcquireReadOnlyMeshData(mesh);
        mesh.Clear();
        Mesh.MeshData data = array[0];
        using var vertices = new NativeArray<Vector3>(data.vertexCount, Allocator.Temp);
        using var indices = new NativeArray<int>(data.GetSubMesh(0).indexCount, Allocator.Temp);
        using var tooFew = new NativeArray<int>(2, Allocator.Temp);
        data.GetVertices(vertices);
        data.GetIndices(indices, 0);
        Assert.That(vertices.ToArray(), Is.EqualTo(_square));
        Assert.That(indices.ToArray(), Is.EqualTo(new[] { 1, 2, 3 }));
        data.GetIndices(indices, 0, false);
        Assert.That(indices.ToArray(), Is.EqualTo(new[] { 0, 1, 2 }));
        Assert.Throws<InvalidOperationException>(() => data.GetIndices(tooFew, 0));
    }

    [Test]
    public void NativeArrays_OfOtherTypesOfTheRightSize_AreTaken()
    {
        using var points = new NativeArray<Unity.Mathematics.float3>(4, Allocator.Temp);
        using var indices = new NativeArray<ushort>(new ushort[] { 0, 1, 2 }, Allocator.Temp);
        using var wrong = new NativeArray<Vector4>(4, Allocator.Temp);
        var mesh = new Mesh();
        mesh.SetVertices(points);
        mesh.SetIndices(indices, MeshTopology.Triangles, 0);
        Assert.That((mesh.vertexCount, mesh.triangles.Length), Is.EqualTo((4, 3)));
        Assert.Throws<ArgumentException>(() => mesh.SetVertices(wrong));
    }

    [Test]
    public void Uvs_OfThreeComponents_KeepThem()
    {
        Mesh mesh = Square();
        mesh.SetUVs(1, new List<Vector3>(_square));
        var read = new List<Vector3>();
        mesh.GetUVs(1, read);
        Assert.That(read, Is.EqualTo(_square));
        Assert.That(mesh.uv2[2].Equals(new Vector2(2, 0)));
        Assert.That(mesh.HasVertexAttribute(VertexAttribute.TexCoord1));
        Assert.That(mesh.HasVertexAttribute(VertexAttribute.TexCoord0), Is.False);
    }

    [Test]
    public void Instantiate_OfAMesh_CopiesItsContents()
    {
        Mesh mesh = Square();
        Mesh copy = UnityEngine.Object.Instantiate(mesh);
        copy.SetVertices(new Vector3[4]);
        copy.subMeshCount = 2;
        Assert.That(mesh.vertices, Is.EqualTo(_square));
        Assert.That(mesh.subMeshCount, Is.EqualTo(1));
        Assert.That(copy.triangles, Is.EqualTo(mesh.triangles));
    }

    [Test]
    public void Load_OfBrokenContents_KeepsThemAsTheyAre()
    {
        var mesh = new Mesh();
        mesh.Load(new MeshContents
        {
            Vertices = new[] { new Vector3(float.NaN, 0, 0) },
            Indices = new[] { 0, 7, -1 },
            SubMeshes = { [0] = new SubMeshDescriptor(0, 3) },
            Bounds = new Bounds(Vector3.one, Vector3.one),
            IsReadable = true,
        });
        Assert.That(mesh.vertices[0].x, Is.NaN);
        Assert.That(mesh.GetIndices(0), Is.EqualTo(new[] { 0, 7, -1 }));
        Assert.That(mesh.bounds.center == Vector3.one);
    }

    static Mesh Square()
    {
        var mesh = new Mesh { name = "Square" };
        mesh.vertices = _square;
        mesh.triangles = new[] { 0, 1, 2, 0, 2, 3 };
        return mesh;
    }

    static List<string> Errors(Action action)
    {
        var errors = new List<string>();
        Application.LogCallback listen = (message, _, type) =>
        {
            if (type == LogType.Error)
                errors.Add(message);
        };
        Application.logMessageReceivedThreaded += listen;
        try
        {
            action();
        }
        finally
        {
            Application.logMessageReceivedThreaded -= listen;
        }
        return errors;
    }
}
