using System.IO;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Glint.Host.Tests;

/// <summary>A project with a local package, for product code that writes to it in the editor.</summary>
public abstract class WritingFixture : EngineFixture
{
    private protected TemporaryProject Project { get; private set; }

    [SetUp]
    public void OpenProject()
    {
        Project = new TemporaryProject();
        Project.Write("Packages/manifest.json", """{ "dependencies": { "com.glint.meshes": "file:../Meshes" } }""");
        Project.Write("Meshes/package.json", """{ "name": "com.glint.meshes", "version": "1.0.0" }""");
        _ = Project.Project;
    }

    [TearDown]
    public void CloseProject() => Project.Dispose();

    protected string Text(string path) => File.ReadAllText(Path.Combine(Project.Root, path));

    /// <summary>The asset in a newly opened project.</summary>
    protected T Reopened<T>(string assetPath)
        where T : Object
    {
        Glint.Host.Project.Open(Project.Root);
        return AssetDatabase.LoadAssetAtPath<T>(assetPath);
    }

    protected static Mesh Triangle(string name = "Triangle")
    {
        var mesh =
            new Mesh { name = name, vertices = [Vector3.zero, Vector3.up, Vector3.right], triangles = [0, 1, 2] };
        mesh.RecalculateNormals();
        return mesh;
    }
}
