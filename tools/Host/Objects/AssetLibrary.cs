using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Glint.Core;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>The assets loaded so far. Each is loaded once.</summary>
internal sealed class AssetLibrary
{
    static readonly HashSet<string> _models = new(StringComparer.OrdinalIgnoreCase)
    {
        ".fbx", ".obj", ".dae", ".blend", ".3ds", ".dxf", ".max", ".ma", ".mb", ".glb", ".gltf", ".stl"
    };

    readonly ProjectFiles _files;
    readonly Flattener _flattener;
    readonly ScriptCatalog _scripts;
    readonly LoadWarnings _warnings;
    readonly Dictionary<string, LoadedFile> _loaded = new();
    readonly Dictionary<string, Object> _imported = new();

    internal AssetLibrary(ProjectFiles files, Flattener flattener, ScriptCatalog scripts, LoadWarnings warnings)
    {
        _files = files;
        _flattener = flattener;
        _scripts = scripts;
        _warnings = warnings;
    }

    /// <summary>The object of a reference with a guid.</summary>
    /// <param name="problem">
    /// Why there is no object, as the end of "refers to ..."; null for objects that the host leaves out on purpose.
    /// </param>
    internal Object Find(ObjectReference reference, out string problem)
    {
        problem = null;
        if (BuiltInAssets.IsOne(reference))
            return BuiltInAssets.Find(reference);
        string path = _files.Guids.PathOf(reference.Guid);
        if (path is null)
        {
            problem = $"guid {reference.Guid}, which no .meta in the project has";
            return null;
        }
        if (!_files.Exists(path))
        {
            problem = $"{_files.Shown(path)}, of which only the .meta is there";
            return null;
        }
        if (_models.Contains(Path.GetExtension(path)))
        {
            problem = $"{_files.Shown(path)}, a model, which only Unity reads";
            return null;
        }
        if (!IsObjectFile(path))
            return Import(path);
        LoadedFile file = Open(path);
        ObjectRecord record = file.Table.Find(reference.FileId);
        if (record is null && !file.Table.IsSkipped(reference.FileId))
            problem = $"object &{reference.FileId} of {_files.Shown(path)}, which is not in it";
        return record is null ? null : file.Find(record);
    }

    /// <summary>The asset's object of a type, preferably its main object; null if there is none.</summary>
    internal Object Load(string path, Type type)
    {
        if (!_files.Exists(path))
            return null;
        if (!IsObjectFile(path))
            return Import(path) is Object imported && type.IsInstanceOfType(imported) ? imported : null;
        LoadedFile file = Open(path);
        if (!IsPrefab(path))
            return file.Objects.Values.FirstOrDefault(type.IsInstanceOfType);
        GameObject root = file.Objects.Values.OfType<GameObject>().First();
        return type.IsInstanceOfType(root) ? root : typeof(Component)
            .IsAssignableFrom(type) ? root.GetComponent(type) : null;
    }

    /// <summary>Sets the object of the asset at a path.</summary>
    internal void Put(string path, Object asset, ObjectRecord record)
    {
        LoadedFile file = new(new ObjectTable(_files.Shown(path), _files.Guids.GuidOf(path)));
        file.Table.Add(record);
        file.Add(record, asset);
        _loaded[path] = file;
        (asset.AssetPath, asset.FileId) = (path, record.Id);
    }

    /// <summary>
    /// Content of the asset's file that the host does not read or write, and so would lose; null without any.
    /// </summary>
    internal string LostIfWritten(Object asset)
    {
        LoadedFile file = Open(asset.AssetPath);
        if (file.Table.Records.Count + file.Table.Skipped.Count > 1)
            return "further objects";
        FieldMap fields = file.Table.Records[0].Fields;
        if (asset is not Mesh)
            return null;
        return fields.Map("m_Shapes")
            .Maps("vertices").Count > 0 ? "blend shapes" : fields.Maps("m_BindPose").Count > 0 ? "a skin" : null;
    }

    /// <summary>Discards the prefabs; they are rebuilt when next requested.</summary>
    internal void ForgetPrefabs()
    {
        _flattener.ForgetPrefabs();
        foreach (string path in _loaded.Keys.Where(IsPrefab).ToList())
            _loaded.Remove(path);
    }

    LoadedFile Open(string path)
    {
        if (_loaded.TryGetValue(path, out LoadedFile file))
            return file;
        file = new LoadedFile(IsPrefab(path) ? _flattener.Prefab(path) : _flattener.Read(path));
        // Added before it is filled, since its references may lead back to it.
        _loaded.Add(path, file);
        try
        {
            Links links = new(file, this, _warnings);
            if (IsPrefab(path))
                new ObjectBuilder(file, default, _scripts, _warnings)
                    .Build(Hierarchy.Read(file.Table, isScene: false), links);
            else
                new AssetBuilder(file, _scripts, _warnings).Build(links);
        }
        catch (GlintException)
        {
            _loaded.Remove(path);
            throw;
        }
        foreach ((ObjectRecord record, Object made) in file.Objects)
            (made.AssetPath, made.FileId) = (path, record.Id);
        return file;
    }

    Object Import(string path)
    {
        if (!_imported.TryGetValue(path, out Object made))
        {
            made = ImportedAssets.Make(_files, path);
            if (made is not null)
            {
                made.name = Path.GetFileNameWithoutExtension(path);
                made.AssetPath = path;
            }
            _imported.Add(path, made);
        }
        return made;
    }

    static bool IsPrefab(string path) => path.EndsWith(".prefab", StringComparison.OrdinalIgnoreCase);

    static bool IsObjectFile(string path) =>
        Path.GetExtension(path).ToLowerInvariant() is ".prefab" or ".asset" or ".mat" or ".mesh";
}
