using System;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>Prefabs are written as plain hierarchies without nested instances.</summary>
public sealed class PrefabUtility
{
    const string Extension = ".prefab";

    /// <summary>The host has no overrides to record: an instance is a plain copy.</summary>
    public static void RecordPrefabInstancePropertyModifications(Object targetObject)
    {
        if (Object.IsNull(targetObject))
            throw new ArgumentNullException(nameof(targetObject));
    }

    public static GameObject SaveAsPrefabAsset(GameObject instanceRoot, string assetPath) =>
        SaveAsPrefabAsset(instanceRoot, assetPath, out _);

    /// <summary>The prefab; null, with an error in the log, if it could not be written.</summary>
    public static GameObject SaveAsPrefabAsset(GameObject instanceRoot, string assetPath, out bool success)
    {
        if (Object.IsNull(instanceRoot))
            throw new ArgumentNullException(nameof(instanceRoot), "Parameter root is null");
        if (AssetDatabase.Contains(instanceRoot))
            throw new ArgumentException("Can't save persistent object as a Prefab asset: "
                + $"'{instanceRoot.name}' is of {instanceRoot.AssetPath}");
        if (string.IsNullOrEmpty(assetPath) || !assetPath.EndsWith(Extension, StringComparison.OrdinalIgnoreCase))
            throw new ArgumentException($"Given path is not valid: '{assetPath}': a prefab's path ends in {Extension}");
        try
        {
            GameObject prefab = AssetDatabase.OpenStore.SavePrefab(instanceRoot, assetPath);
            success = true;
            return prefab;
        }
        catch (UnityException refusal)
        {
            Debug.LogError(refusal.Message, instanceRoot);
            success = false;
            return null;
        }
    }
}
