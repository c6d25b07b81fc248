using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Runtime.CompilerServices;
using Glint.Core;
using NUnit.Framework;
using UnityEngine;
using static Glint.Host.Tests.UnityText;

namespace Glint.Host.Tests;

/// <summary>A truncated file is refused by name or gives the same objects, never a smaller scene.</summary>
public sealed class TruncatedFileTests
{
    const int Guid = 1;
    const int Stride = 37;

    TemporaryProject _project;

    [SetUp]
    public void Create() => _project = new TemporaryProject();

    [TearDown]
    public void Delete() => _project.Dispose();

    [Test, MaxTime(300_000)]
    public void CornerReflector_CutAnywhere_IsRefusedOrHasItsThreePlates()
    {
        string whole = File.ReadAllText(
            Path.Combine(Project.FindRoot(ThisFolder()), "Meshes/CornerReflector/Corner Reflector.prefab"));
        string[] plates = Plates(whole, 0);
        Assert.That(plates, Has.Length.EqualTo(3));
        int refused = 0;
        foreach (int length in Cuts(whole))
        {
            if (Refusal(() => Assert.That(Plates(whole[..length], length), Is.EqualTo(plates), $"{length} bytes"))
                is not string message)
                continue;
            refused++;
            Assert.That(message, Does.StartWith($"Assets/{length}.prefab").And.Not.Contain("\n"), $"{length} bytes");
        }
        Assert.That(refused, Is.GreaterThan(100));
    }

    [Test]
    public void MeshAsset_CutAnywhere_IsRefusedOrIsTheSameMesh()
    {
        string whole = MeshText.Of([0, 0, 0, 1, 0, 0, 0, 0, 1], 0, 1, 2).ToString();
        foreach (int length in Enumerable.Range(1, whole.Length))
        {
            string path = $"Assets/{length}.asset";
            _project.Write(path, whole[..length]);
            string message = Refusal(() =>
            {
                Mesh mesh = (Mesh)_project.Project.LoadAsset(path, typeof(Mesh));
                Assert.That(mesh.vertices,
                    Is.EqualTo(new[] { Vector3.zero, Vector3.right, Vector3.forward }), $"{length} bytes");
                Assert.That(mesh.GetIndices(0), Is.EqualTo(new[] { 0, 1, 2 }), $"{length} bytes");
            });
            if (message is not null)
                Assert.That(message, Does.StartWith(path), $"{length} bytes");
        }
    }

    [TestCase("m_SubMeshes"), TestCase("m_IndexBuffer"), TestCase("m_VertexData")]
    public void Mesh_WithoutOneOfItsParts_IsRefused(string key)
    {
        _project.Write("Assets/Hull.asset", new MeshText().ToString().Replace($"  {key}:", "  unknown:"));
        Assert.That(Refusal(() => _project.Project.LoadAsset("Assets/Hull.asset", typeof(Mesh))),
            Is.EqualTo($"Assets/Hull.asset: Mesh 'Hull' has no {key}, the file has been cut short: restore the file"));
    }

    [Test]
    public void Mesh_ExplicitlyEmpty_Loads()
    {
        _project.Write("Assets/Hull.asset", new MeshText().ToString());
        Assert.That(((Mesh)_project.Project.LoadAsset("Assets/Hull.asset", typeof(Mesh))).vertexCount, Is.Zero);
    }

    [TestCase("m_GameObject"), TestCase("m_Father"), TestCase("m_Children")]
    public void Transform_WithoutOneOfItsLinks_IsRefused(string key)
    {
        string scene = Scene(Object(10, "A").Replace($"  {key}:", "  unknown:"), 11);
        Assert.That(Refusal(() => _project.LoadScene(scene)), Is.EqualTo("Assets/Scene.unity: "
            + $"Transform &11 has no {key}, the file has been cut short: restore the file"));
    }

    [Test]
    public void Transform_OfNoGameObject_IsRefused()
    {
        string loose = Object(20, "B", father: 11);
        string scene = Scene(Object(10, "A") + loose[loose.IndexOf("--- !u!4")..], 11);
        Assert.That(Refusal(() => _project.LoadScene(scene)),
            Is.EqualTo("Assets/Scene.unity: Transform &21 belongs to no GameObject: restore the file"));
    }

    string[] Plates(string text, int name)
    {
        string path = $"Assets/{name}.prefab";
        _project.Write(path, text);
        GameObject root = (GameObject)_project.Project.LoadAsset(path, typeof(GameObject));
        return root.GetComponentsInChildren<MeshFilter>(true)
            .Where(filter => filter.GetComponent<MeshRenderer>().enabled)
            .Select(filter => $"{filter.name} {filter.sharedMesh.name} {filter.transform.localToWorldMatrix}")
            .ToArray();
    }

    // Every line end, with and without the line break, and positions within lines.
    static IEnumerable<int> Cuts(string text) => Enumerable.Range(1, text.Length - 1)
        .Where(length => text[length] == '\n' || text[length - 1] == '\n' || length % Stride == 0);

    static string Refusal(TestDelegate load)
    {
        try
        {
            load();
            return null;
        }
        catch (GlintException error)
        {
            return error.Message;
        }
    }

    static string ThisFolder([CallerFilePath] string file = null) => Path.GetDirectoryName(file);
}
