using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using static Unity.Mathematics.math;

namespace Glint.Host.Tests;

public class BuiltinMeshTests
{
    // Sums in double over the triangles, with float32 coordinates below 1 m.
    const double Tolerance = 1e-6;

    [TestCase(PrimitiveType.Cube, 24, 12)]
    [TestCase(PrimitiveType.Plane, 121, 200)]
    [TestCase(PrimitiveType.Quad, 4, 2)]
    [TestCase(PrimitiveType.Sphere, 486, 768)]
    [TestCase(PrimitiveType.Capsule, 522, 832)]
    [TestCase(PrimitiveType.Cylinder, 84, 80)]
    public void Counts_OfEachPrimitive_AreAsDescribed(PrimitiveType type, int vertices, int triangles)
    {
        Mesh mesh = BuiltinMeshes.Get(type);
        Assert.That(mesh.vertexCount, Is.EqualTo(vertices));
        Assert.That(mesh.triangles.Length / 3, Is.EqualTo(triangles));
        Assert.That(mesh.name, Is.EqualTo(type.ToString()));
        Assert.That(mesh.normals.Length, Is.EqualTo(vertices));
    }

    [TestCase(PrimitiveType.Cube)]
    [TestCase(PrimitiveType.Sphere)]
    [TestCase(PrimitiveType.Capsule)]
    [TestCase(PrimitiveType.Cylinder)]
    public void Edges_OfASolid_AreSharedByTwoTrianglesInOppositeSense(PrimitiveType type)
    {
        Mesh mesh = BuiltinMeshes.Get(type);
        var edges = new HashSet<(Vector3, Vector3)>();
        foreach ((Vector3 a, Vector3 b, Vector3 c) in Triangles(mesh))
        {
            foreach ((Vector3, Vector3) edge in new[] { (a, b), (b, c), (c, a) })
                Assert.That(edges.Add(edge), "an edge is there twice");
        }
        foreach ((Vector3 from, Vector3 to) in edges)
            Assert.That(edges.Contains((to, from)), $"edge {(from, to)} is open");
    }

    [Test]
    public void Cube_OfSideOne_HasItsVolumeAndArea()
    {
        Mesh cube = BuiltinMeshes.Get(PrimitiveType.Cube);
        Assert.That(Volume(cube), Is.EqualTo(1).Within(Tolerance));
        Assert.That(Area(cube), Is.EqualTo(6).Within(Tolerance));
        Near.Point(cube.bounds.size, 1, 1, 1, 0);
    }

    [Test]
    public void Sphere_OfRadiusHalf_IsInscribed()
    {
        Mesh sphere = BuiltinMeshes.Get(PrimitiveType.Sphere);
        foreach (Vector3 vertex in sphere.vertices)
            Assert.That(vertex.magnitude, Is.EqualTo(0.5).Within(1e-7));
        // Facets of about 90/8 degrees reduce the volume by about (angle^2)/4.
        double whole = 4.0 / 3.0 * Math.PI * 0.125;
        Assert.That(Volume(sphere), Is.InRange(whole * 0.98, whole));
        Assert.That(Area(sphere), Is.InRange(Math.PI * 0.98, Math.PI));
    }

    [Test]
    public void Capsule_OfHeightTwo_IsTheSphereAndItsBandOf32Sides()
    {
        // The equator's 32 points are a regular polygon.
        double polygon = 32 / 2.0 * 0.25 * Math.Sin(2 * Math.PI / 32);
        Assert.That(Volume(BuiltinMeshes.Get(PrimitiveType.Capsule)),
            Is.EqualTo(Volume(BuiltinMeshes.Get(PrimitiveType.Sphere)) + polygon).Within(Tolerance));
        Near.Point(BuiltinMeshes.Get(PrimitiveType.Capsule).bounds.size, 1, 2, 1, 1e-6);
    }

    [Test]
    public void Cylinder_OfTwentySides_HasThePrismsVolume()
    {
        double polygon = 20 / 2.0 * 0.25 * Math.Sin(2 * Math.PI / 20);
        Mesh cylinder = BuiltinMeshes.Get(PrimitiveType.Cylinder);
        Assert.That(Volume(cylinder), Is.EqualTo(2 * polygon).Within(Tolerance));
        Assert.That(cylinder.bounds.size.y, Is.EqualTo(2));
    }

    [Test]
    public void Plane_OfTenMetres_FacesUp()
    {
        Mesh plane = BuiltinMeshes.Get(PrimitiveType.Plane);
        Assert.That(Area(plane), Is.EqualTo(100).Within(1e-4));
        Assert.That(Triangles(plane).All(t => Normal(t).y > 0));
        Near.Point(plane.bounds.size, 10, 0, 10, 0);
    }

    [Test]
    public void Quad_OfOneMetre_FacesBack()
    {
        Mesh quad = BuiltinMeshes.Get(PrimitiveType.Quad);
        Assert.That(Area(quad), Is.EqualTo(1).Within(Tolerance));
        Assert.That(Triangles(quad).All(t => Normal(t).z < 0));
    }

    [TestCase(PrimitiveType.Cube)]
    [TestCase(PrimitiveType.Plane)]
    [TestCase(PrimitiveType.Quad)]
    [TestCase(PrimitiveType.Sphere)]
    [TestCase(PrimitiveType.Capsule)]
    [TestCase(PrimitiveType.Cylinder)]
    public void Normals_OfEachPrimitive_PointOutOfItsTriangles(PrimitiveType type)
    {
        Mesh mesh = BuiltinMeshes.Get(type);
        Vector3[] normals = mesh.normals;
        int[] corners = mesh.triangles;
        List<(Vector3, Vector3, Vector3)> triangles = Triangles(mesh).ToList();
        for (int i = 0; i < corners.Length; i++)
        {
            Assert.That(normals[corners[i]].magnitude, Is.EqualTo(1).Within(1e-6));
            Assert.That(dot(Normal(triangles[i / 3]), new double3((float3)normals[corners[i]])), Is.GreaterThan(0.9));
        }
    }

    [TestCase(10202, "Cube")]
    [TestCase(10206, "Cylinder")]
    [TestCase(10207, "Sphere")]
    [TestCase(10208, "Capsule")]
    [TestCase(10209, "Plane")]
    [TestCase(10210, "Quad")]
    public void ByFileId_OfAPrimitive_IsIt(long fileId, string name)
    {
        Assert.That(BuiltinMeshes.ByFileId(fileId).name, Is.EqualTo(name));
        Assert.That(BuiltinMeshes.ByFileId(10303), Is.Null);
    }

    static IEnumerable<(Vector3 A, Vector3 B, Vector3 C)> Triangles(Mesh mesh)
    {
        Vector3[] vertices = mesh.vertices;
        int[] corners = mesh.triangles;
        for (int i = 0; i < corners.Length; i += 3)
            yield return (vertices[corners[i]], vertices[corners[i + 1]], vertices[corners[i + 2]]);
    }

    // Clockwise corners in left-handed axes have the same cross product as counter-clockwise ones in right-handed
    // axes.
    static double3 Normal((Vector3 A, Vector3 B, Vector3 C) t) => normalize(Cross(t));

    static double3 Cross((Vector3 A, Vector3 B, Vector3 C) t)
    {
        double3 a = (float3)t.A, b = (float3)t.B, c = (float3)t.C;
        return cross(b - a, c - a);
    }

    static double Area(Mesh mesh) => Triangles(mesh).Sum(t => 0.5 * length(Cross(t)));

    // Positive if the triangles face outwards.
    static double Volume(Mesh mesh) => Triangles(mesh).Sum(t => dot((float3)t.A, Cross(t)) / 6);
}
