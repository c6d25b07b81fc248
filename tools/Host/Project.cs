using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Glint.Core;
using UnityEngine;
using UnityEngine.SceneManagement;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>A Unity project on disk, which provides scenes and assets to the stand-ins.</summary>
public sealed class Project : IAssetSource, IAssetStore
{
    const string SceneExtension = ".unity";

    // Unity has no asset at that path, since it ignores folders whose name ends in "~".
    const string WideShader = "Packages/com.glint.radar/Shaders/Wide~/TraceWide.compute";

    const int ShownScenes = 5;

    readonly ProjectFiles _files;
    readonly Flattener _flattener;
    readonly ScriptCatalog _scripts;
    readonly LoadWarnings _warnings = new();
    readonly AssetLibrary _assets;
    readonly AssetWriter _writer;

    Project(string root)
    {
        _files = new ProjectFiles(root);
        _flattener = new Flattener(_files);
        _scripts = new ScriptCatalog(_files);
        _assets = new AssetLibrary(_files, _flattener, _scripts, _warnings);
        _writer = new AssetWriter(_files, _scripts);
    }

    public string ProjectRoot => _files.Paths.Root;

    /// <summary>Maps paths on disk to asset paths and back, as in Unity's batch mode.</summary>
    public ProjectPaths Paths => _files.Paths;

    /// <summary>Opens the project in a folder; the stand-ins then load from it.</summary>
    /// <exception cref="GlintException">The folder holds no Unity project, or its settings are damaged.</exception>
    public static Project Open(string root)
    {
        Project project = new(root);
        ProjectSettings settings = new(project._files);
        TagManager.Set(settings.Tags, settings.Layers);
        SceneLoads.BuildScenes.Clear();
        SceneLoads.BuildScenes.AddRange(settings.BuildScenes);
        Engine.Assets = project;
        SoftwareDevice.LoadWideShader =
            () => (ComputeShader)project._assets.Load(WideShader, typeof(ComputeShader));
        return project;
    }

    /// <summary>The project that contains a folder; null if none does.</summary>
    public static string FindRoot(string startFolder) => ProjectPaths.FindRoot(startFolder);

    public bool Exists(string assetPath) => _files.Exists(assetPath);

    public void LoadScene(string assetPath, Scene scene)
    {
        RequireScene(assetPath);
        _warnings.Clear();
        LoadedFile file = new(_flattener.Read(assetPath));
        IReadOnlyList<HierarchyNode> roots = Hierarchy.Read(file.Table, isScene: true);
        IReadOnlyList<UnityEngine.GameObject> made =
            new ObjectBuilder(file, scene, _scripts, _warnings).Build(roots, new Links(file, _assets, _warnings));
        _warnings.Report();
        ObjectFactory.Awaken(made);
    }

    public Object LoadAsset(string assetPath, Type type)
    {
        _warnings.Clear();
        Object asset = _assets.Load(assetPath, type);
        _warnings.Report();
        return asset;
    }

    public void CreateAsset(Object asset, string path)
    {
        // A new asset gets the name of its file, as in Unity.
        asset.name = Path.GetFileNameWithoutExtension(path);
        _writer.WriteAsset(asset, path);
        _assets.Put(path, asset, AssetWriter.RecordOf(asset, _files.Shown(path)));
    }

    public void SaveAsset(Object asset)
    {
        // These objects are in no file.
        if (BuiltInAssets.GuidOf(asset.AssetPath) is not null)
            return;
        if (_assets.LostIfWritten(asset) is string lost)
            throw new UnityException($"{_files.Shown(asset.AssetPath)}: holds {lost}, "
                + "which only Unity writes: save it there");
        _writer.WriteAsset(asset, asset.AssetPath);
    }

    public GameObject SavePrefab(GameObject root, string path)
    {
        _writer.WritePrefab(root, path);
        _assets.ForgetPrefabs();
        return (GameObject)LoadAsset(path, typeof(GameObject));
    }

    public bool IsFolder(string path) => !string.IsNullOrEmpty(path) && path[^1] != '/'
        && (path == "Assets" || path.StartsWith("Assets/", StringComparison.Ordinal)
            || path.StartsWith("Packages/", StringComparison.Ordinal))
        && Directory.Exists(_files.Physical(path));

    public string CreateFolder(string path) => _writer.CreateFolder(path);

    public void Refresh() => _files.Guids.Forget();

    public IEnumerable<KeyValuePair<string, Object>> DefaultReferences(Type script)
    {
        foreach ((string field, ObjectReference reference) in _scripts.DefaultsOf(script))
        {
            if (_assets.Find(reference, out _) is Object asset)
                yield return new KeyValuePair<string, Object>(field, asset);
        }
    }

    public string GuidToPath(string guid) => _files.Guids.PathOf(guid.ToLowerInvariant());

    public string PathToGuid(string assetPath) => _files.Guids.GuidOf(assetPath);

    public string ToPhysicalPath(string assetPath) => _files.Physical(assetPath);

    void RequireScene(string assetPath)
    {
        string shown = _files.Shown(assetPath);
        if (!assetPath.EndsWith(SceneExtension, StringComparison.OrdinalIgnoreCase))
            throw new GlintException($"{shown}: is not a scene: give the path of a {SceneExtension} file");
        if (Exists(assetPath))
            return;
        List<string> scenes = _files.Guids.Paths.Where(
                path => path.EndsWith(SceneExtension, StringComparison.OrdinalIgnoreCase))
            .Select(_files.Shown).Order(StringComparer.Ordinal).ToList();
        string there = string.Join(", ", scenes.Take(ShownScenes)) + (scenes.Count > ShownScenes ? ", ..." : "");
        throw new GlintException($"{shown}: no such scene: "
            + $"{(scenes.Count > 0 ? $"the project has {there}" : "the project has none")}");
    }
}
