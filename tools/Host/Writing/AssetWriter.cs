using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using UnityEngine;
using YamlDotNet.RepresentationModel;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>Writes meshes, ScriptableObjects, prefabs and folders with their .meta into the project.</summary>
internal sealed class AssetWriter
{
    const long MeshFileId = 4300000, ScriptFileId = 11400000;

    readonly ProjectFiles _files;
    readonly ScriptCatalog _scripts;

    internal AssetWriter(ProjectFiles files, ScriptCatalog scripts)
    {
        _files = files;
        _scripts = scripts;
    }

    /// <summary>A record of the object as in its file, without fields.</summary>
    internal static ObjectRecord RecordOf(Object asset, string shownPath)
    {
        (int classId, long fileId) = IdsOf(asset);
        return new ObjectRecord(shownPath, classId, asset.GetType().Name, fileId, new YamlMappingNode());
    }

    // Class and id of an asset in its file.
    static (int ClassId, long FileId) IdsOf(Object asset) => asset switch
    {
        Mesh => (ClassId.Mesh, MeshFileId),
        ScriptableObject => (ClassId.MonoBehaviour, ScriptFileId),
        _ => throw new UnityException($"the {asset.GetType().Name} '{asset.name}' is not written outside of Unity: "
            + "only meshes, ScriptableObjects and prefabs are"),
    };

    internal void WriteAsset(Object asset, string path)
    {
        (_, long id) = IdsOf(asset);
        string extension = Path.GetExtension(path);
        if (extension != ".asset" && !(asset is Mesh && extension == ".mesh"))
            throw new UnityException($"{path}: an asset's name ends in .asset");
        string physical = PhysicalPath(path);
        Dictionary<Object, long> ids = new(ReferenceEqualityComparer.Instance) { [asset] = id };
        WholeFile.Write(physical, _files.Shown(path), text => WriteObject(new YamlWriter(text), asset, ids, id));
        WriteMeta(path, guid => MetaText.OfObject(guid, id));
    }

    internal void WritePrefab(GameObject root, string path)
    {
        string physical = PhysicalPath(path);
        Dictionary<Object, long> ids = PrefabIds.Of(root);
        WholeFile.Write(physical, _files.Shown(path), text =>
        {
            ComponentWriter writer = new(new YamlWriter(text), new ReferenceText(_files.Guids, ids), ids, _scripts);
            foreach (Object item in ids.Keys)
            {
                // The root always has the file's name.
                if (item is GameObject node)
                    writer.Write(node, node == root ? Path.GetFileNameWithoutExtension(path) : node.name);
                else
                    writer.Write((Component)item, ((Component)item).gameObject == root);
            }
        });
        WriteMeta(path, MetaText.OfPrefab);
    }

    internal string CreateFolder(string path)
    {
        string physical = PhysicalPath(path);
        try
        {
            Directory.CreateDirectory(physical);
        }
        catch (Exception error) when (error is IOException or UnauthorizedAccessException)
        {
            throw new UnityException($"{_files.Shown(path)}: the folder cannot be made: {error.Message}", error);
        }
        return WriteMeta(path, MetaText.OfFolder);
    }

    void WriteObject(YamlWriter yaml, Object asset, IReadOnlyDictionary<Object, long> ids, long id)
    {
        if (asset is Mesh mesh)
        {
            yaml.Object(ClassId.Mesh, id, "Mesh");
            ComponentWriter.Head(yaml, mesh);
            yaml.Field("m_Name", ScalarText.Of(mesh.name));
            MeshWriter.Write(yaml, mesh);
            return;
        }
        yaml.Object(ClassId.MonoBehaviour, id, "MonoBehaviour");
        ComponentWriter.Head(yaml, asset);
        yaml.Field("m_GameObject", ReferenceText.None);
        ComponentWriter.Script(yaml, asset, true, _scripts.GuidOf(asset.GetType()), asset.name);
        FieldWriter.Write(yaml, new ReferenceText(_files.Guids, ids), asset);
    }

    // The path on disk of an asset path, if assets can be made there.
    string PhysicalPath(string path)
    {
        string[] parts = (path ?? "").Split('/');
        bool isBelowRoot = parts[0] == "Assets" && parts.Length > 1
            || parts[0] == "Packages" && parts.Length > 2 && _files.Paths.Packages.ContainsKey(parts[1]);
        if (!isBelowRoot || parts.Any(part => part is "" or "." or ".." || part.Contains('\\')))
            throw new UnityException($"'{path}': no place for an asset: give a path below Assets, "
                + "or below Packages and the name of an embedded or local package");
        string folder = path[..path.LastIndexOf('/')];
        if (!Directory.Exists(_files.Physical(folder)))
            throw new UnityException($"{path}: its folder is not there: "
                + $"make {folder} first (AssetDatabase.CreateFolder)");
        foreach (string above in FoldersAbove(parts))
            WriteMeta(above, MetaText.OfFolder);
        return _files.Physical(path);
    }

    // Assets itself and a package's own folder have no .meta.
    static IEnumerable<string> FoldersAbove(string[] parts)
    {
        int root = parts[0] == "Assets" ? 1 : 2;
        for (int count = root + 1; count < parts.Length; count++)
            yield return string.Join('/', parts.Take(count));
    }

    // An existing .meta is kept, and so are references to the asset.
    string WriteMeta(string path, Func<string, string> text)
    {
        if (_files.Guids.GuidOf(path) is string known)
            return known;
        string guid = MetaText.NewGuid(path, _files.Guids.IsTaken);
        string meta = path + MetaFile.Extension;
        WholeFile.Write(_files.Physical(meta), _files.Shown(meta), writer => writer.Write(text(guid)));
        _files.Guids.Add(guid, path);
        return guid;
    }
}
