using System;
using System.Collections.Generic;
using System.IO;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace Glint.Host.Tests;

/// <summary>
/// A small Unity project in its own folder, and the log of loading it. Dispose reopens the previous project.
/// </summary>
public sealed class TemporaryProject : IDisposable
{
    readonly IAssetSource _before = Engine.Assets;
    readonly Func<ComputeShader> _wideShaderBefore = SoftwareDevice.LoadWideShader;
    readonly List<string> _warnings = new();
    Project _project;

    public TemporaryProject()
    {
        // Scenes that other tests left open would be traced too.
        Engine.Reset();
        Root = Directory.CreateTempSubdirectory("glint-loader-").FullName;
        Directory.CreateDirectory(Path.Combine(Root, "Assets"));
        Directory.CreateDirectory(Path.Combine(Root, "ProjectSettings"));
        Write("Packages/manifest.json", """{ "dependencies": {} }""");
        Application.logMessageReceived += Listen;
    }

    public string Root { get; }

    public IReadOnlyList<string> Warnings => _warnings;

    /// <summary>The project. It is opened on first use, so that files written before are found.</summary>
    public Project Project => _project ??= Project.Open(Root);

    public static string Guid(int number) => number.ToString("x32");

    public void Write(string path, string text)
    {
        string physical = Path.Combine(Root, path);
        Directory.CreateDirectory(Path.GetDirectoryName(physical));
        File.WriteAllText(physical, text);
    }

    /// <summary>A file with its .meta.</summary>
    public void Write(string path, string text, int guid)
    {
        Write(path, text);
        Write(path + ".meta", $"fileFormatVersion: 2\nguid: {Guid(guid)}\n");
    }

    /// <summary>A script whose class is in this assembly. The first also adds the .asmdef.</summary>
    public void WriteScript(Type type, int guid)
    {
        Write("Assets/Scripts/Scripts.asmdef", $$"""{ "name": "{{type.Assembly.GetName().Name}}" }""");
        Write($"Assets/Scripts/{type.Name}.cs", $"namespace {type.Namespace}; class {type.Name} {{ }}", guid);
    }

    /// <summary>The roots of the loaded scene.</summary>
    public GameObject[] Load(string assetPath = "Assets/Scene.unity")
    {
        _ = Project;
        SceneData scene = SceneRegistry.AddFile(assetPath);
        SceneRegistry.Fill(scene);
        return new Scene(scene).GetRootGameObjects();
    }

    public GameObject[] LoadScene(string text)
    {
        Write("Assets/Scene.unity", text);
        return Load();
    }

    public void Dispose()
    {
        Application.logMessageReceived -= Listen;
        Engine.Reset();
        Engine.Assets = null;
        SoftwareDevice.LoadWideShader = _wideShaderBefore;
        if (_before is not null)
            Project.Open(_before.ProjectRoot);
        Directory.Delete(Root, true);
    }

    void Listen(string message, string stackTrace, LogType type)
    {
        if (type == LogType.Warning)
            _warnings.Add(message);
    }
}
