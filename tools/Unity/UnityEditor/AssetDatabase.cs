using System;
using Glint.Host;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>The open project's assets, by path and guid. Nothing is imported or written.</summary>
public sealed class AssetDatabase
{
    public static T LoadAssetAtPath<T>(string assetPath)
        where T : Object => (T)LoadAssetAtPath(assetPath, typeof(T));

    /// <summary>Null where there is no such asset.</summary>
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

    public static bool AssetPathExists(string path) => Engine.Assets?.Exists(path) ?? false;

    public static string GetAssetPath(Object assetObject) =>
        Object.IsNull(assetObject) ? "" : assetObject.AssetPath ?? "";

    public static bool Contains(Object obj) => GetAssetPath(obj).Length > 0;

    public static string GUIDToAssetPath(string guid) => Engine.Assets?.GuidToPath(guid) ?? "";

    public static string AssetPathToGUID(string path) => Engine.Assets?.PathToGuid(path) ?? "";

    public static void Refresh()
    {
    }

    public static void SaveAssets()
    {
    }
}
