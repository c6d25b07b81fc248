using Glint.Host;
using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>The host has no window for a progress bar; a test may examine it and press its button.</summary>
public class EditorUtility
{
    internal static GameObject DefaultParent { get; private set; }

    public static void DisplayProgressBar(string title, string info, float progress) =>
        EditorHooks.ProgressBar(progress);

    /// <summary>True when cancel was pressed.</summary>
    public static bool DisplayCancelableProgressBar(string title, string info, float progress) =>
        EditorHooks.ProgressBar(progress);

    /// <summary>Empty when the dialog was cancelled.</summary>
    public static string OpenFolderPanel(string title, string folder, string defaultName) =>
        EditorHooks.FileDialog(title);

    /// <summary>Empty when the dialog was cancelled.</summary>
    public static string SaveFilePanel(string title, string directory, string defaultName, string extension) =>
        EditorHooks.FileDialog(defaultName);

    public static void RevealInFinder(string path) => EditorHooks.Reveal(path);

    public static void ClearProgressBar() => EditorHooks.ProgressBar(null);

    /// <summary>AssetDatabase writes the asset when it next saves.</summary>
    public static void SetDirty(Object target) => target.DirtyCount++;

    public static bool IsDirty(Object target) => !Object.IsNull(target) && target.IsDirty;

    public static int GetDirtyCount(Object target) => Object.IsNull(target) ? 0 : target.DirtyCount;

    public static void ClearDirty(Object target) => target.DirtyCount = 0;

    /// <summary>Copies all serialized content including the name; the target becomes dirty.</summary>
    public static void CopySerialized(Object source, Object dest)
    {
        if (source.GetType() != dest.GetType() || source is GameObject)
        {
            Debug.LogError($"Source and Destination Types do not match, or are GameObjects: {source} and {dest}");
            return;
        }
        dest.CopyFrom(source, new CloneMap());
        dest.DirtyCount++;
    }

    public static void SetDefaultParentObject(GameObject defaultParentObject) => DefaultParent = defaultParentObject;

    public static void ClearDefaultParentObject() => DefaultParent = null;

    public static bool IsPersistent(Object target) => AssetDatabase.Contains(target);

    public static Object InstanceIDToObject(int instanceID) => ObjectRegistry.Find(instanceID);
}
