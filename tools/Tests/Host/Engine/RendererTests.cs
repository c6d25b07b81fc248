using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Host.Tests;

public sealed class RendererTests : EngineFixture
{
    [Test]
    public void Bounds_OfATurnedAndScaledBox_AreThoseOfItsCorners()
    {
        GameObject box = GameObject.CreatePrimitive(PrimitiveType.Cube);
        box.transform.SetPositionAndRotation(new Vector3(4f, -1f, 2f), Quaternion.Euler(20f, 45f, -70f));
        box.transform.localScale = new Vector3(2f, -3f, 0.5f);
        Bounds expected = new(box.transform.position, Vector3.zero);
        for (int corner = 0; corner < 8; corner++)
        {
            var local = new Vector3((corner & 1) - 0.5f, (corner >> 1 & 1) - 0.5f, (corner >> 2) - 0.5f);
            expected.Encapsulate(box.transform.TransformPoint(local));
        }
        Bounds actual = box.GetComponent<MeshRenderer>().bounds;
        Assert.That((actual.min - expected.min).magnitude, Is.LessThan(1e-5f));
        Assert.That((actual.max - expected.max).magnitude, Is.LessThan(1e-5f));
    }

    [TestCase(PrimitiveType.Cube, 12)]
    [TestCase(PrimitiveType.Plane, 200)]
    [TestCase(PrimitiveType.Quad, 2)]
    public void CreatePrimitive_BringsItsMesh(PrimitiveType type, int triangles)
    {
        GameObject item = GameObject.CreatePrimitive(type);
        Assert.That(item.name, Is.EqualTo(type.ToString()));
        Assert.That(item.GetComponent<MeshFilter>().sharedMesh.triangles.Length, Is.EqualTo(3 * triangles));
        Assert.That(item.GetComponent<MeshRenderer>().enabled);
    }

    [Test]
    public void MeshFilter_MeshRead_CopiesTheSharedOneOnce()
    {
        GameObject item = GameObject.CreatePrimitive(PrimitiveType.Cube);
        var filter = item.GetComponent<MeshFilter>();
        Mesh shared = filter.sharedMesh;
        Mesh own = filter.mesh;
        Assert.That(own, Is.Not.SameAs(shared));
        Assert.That(filter.mesh, Is.SameAs(own));
        Assert.That(filter.sharedMesh, Is.SameAs(own));
        Assert.That(own.vertices, Is.EqualTo(shared.vertices));
    }

    [Test]
    public void Material_Read_IsTheRenderersOwn()
    {
        var renderer = new GameObject("a").AddComponent<MeshRenderer>();
        var shared = ObjectFactory.NewAsset<Material>();
        renderer.sharedMaterials = new[] { shared, null };
        Assert.That(renderer.sharedMaterial, Is.SameAs(shared));
        Material own = renderer.material;
        Assert.That(own != shared && renderer.material == own && renderer.sharedMaterial == own);
        Assert.That(renderer.sharedMaterials.Length, Is.EqualTo(2));
    }

    [Test]
    public void StaticBatch_IsWhatTheFileSays()
    {
        var renderer = new GameObject("a").AddComponent<MeshRenderer>();
        Assert.That(renderer.isPartOfStaticBatch, Is.False);
        renderer.StaticBatched = true;
        Assert.That(Object.Instantiate(renderer).isPartOfStaticBatch);
    }
}
