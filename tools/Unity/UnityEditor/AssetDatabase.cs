using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Host;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>The open project's assets, by path and guid. Meshes and ScriptableObjects can be written.</summary>
public sealed class AssetDatabase
{
    public static T LoadAssetAtPath<T>(string assetPath)
        where T : Object => (T)LoadAssetAtPath(assetPath, typeof(T));

    /// <summary>Null if there is no asset.</summary>
    public static Object LoadAssetAtPath(string assetPath, Type type)
    {
        if (string.IsNullOrEmpty(assetPath) || !AssetPathExists(assetPath))
            return null;
        Object asset = Engine.Assets.LoadAsset(assetPath, type);
        if (asset is not null)
            asset.AssetPath ??= assetPath;
        return asset;
    }

    public static Object LoadMainAssetAtPath(string assetPath) => LoadAssetAtPath(assetPath, typeof(Object));

    /// <summary>Only the default material of new objects; null for others.</summary>
    public static T GetBuiltinExtraResource<T>(string path)
        where T : Object => (T)GetBuiltinExtraResource(typeof(T), path);

    public static Object GetBuiltinExtraResource(Type type, string path) =>
        path == BuiltinMaterial.ResourceName && type.IsAssignableFrom(typeof(Material)) ? BuiltinMaterial.Get() : null;

    public static bool AssetPathExists(string path) => Engine.Assets?.Exists(path) ?? false;

    public static bool IsValidFolder(string path) => Engine.Assets is IAssetStore store && store.IsFolder(path);

    public static string GetAssetPath(Object assetObject) =>
        Object.IsNull(assetObject) ? "" : assetObject.AssetPath ?? "";

    public static bool Contains(Object obj) => GetAssetPath(obj).Length > 0;

    public static string GUIDToAssetPath(string guid) => Engine.Assets?.GuidToPath(guid) ?? "";

    public static string AssetPathToGUID(string path) => Engine.Assets?.PathToGuid(path) ?? "";

    /// <summary>Writes immediately. The folder must exist; an existing asset is replaced and keeps its guid.</summary>
    /// <exception cref="UnityException">The asset cannot be written there.</exception>
    public static void CreateAsset(Object asset, string path)
    {
        if (Object.IsNull(asset))
            throw new ArgumentNullException(nameof(asset), "The asset to create is null.");
        if (Contains(asset))
            throw new UnityException($"Creating asset at path {path} failed: "
                + $"'{asset.name}' is the asset {asset.AssetPath} already: copy it first (Object.Instantiate)");
        OpenStore.CreateAsset(asset, path);
        GlobalArtifactDependencyVersion++;
    }

    /// <summary>
    /// The new folder's guid; empty, with an error in the log, if it could not be made. A number is added to a name in
    /// use.
    /// </summary>
    public static string CreateFolder(string parentFolder, string newFolderName)
    {
        try
        {
            string path = $"{parentFolder}/{newFolderName}";
            for (int number = 1; IsValidFolder(path); number++)
                path = $"{parentFolder}/{newFolderName} {number}";
            return OpenStore.CreateFolder(path);
        }
        catch (UnityException refusal)
        {
            Debug.LogError(refusal.Message);
            return "";
        }
    }

    public static void SaveAssetIfDirty(Object obj)
    {
        if (Object.IsNull(obj) || !obj.IsDirty || !Contains(obj))
            return;
        OpenStore.SaveAsset(obj);
        obj.DirtyCount = 0;
        GlobalArtifactDependencyVersion++;
    }

    public static void SaveAssets()
    {
        IEnumerable<Object> changed = ObjectRegistry.All().Where(item => item.IsDirty && Contains(item));
        foreach (Object asset in changed.OrderBy(asset => asset.AssetPath, StringComparer.Ordinal).ToList())
            SaveAssetIfDirty(asset);
    }

    public static void Refresh() => (Engine.Assets as IAssetStore)?.Refresh();

    /// <summary>Changes whenever an asset is written.</summary>
    public static uint GlobalArtifactDependencyVersion { get; private set; }

    internal static IAssetStore OpenStore =>
        Engine.Assets as IAssetStore ?? throw new UnityException("No project is open that assets could be written to.");
}
