using Glint.Host;
using Object = UnityEngine.Object;

namespace UnityEditor;

/// <summary>There is no window to draw a progress bar in, and nothing is saved.</summary>
public class EditorUtility
{
    public static void DisplayProgressBar(string title, string info, float progress)
    {
    }

    /// <summary>Nobody can press cancel.</summary>
    public static bool DisplayCancelableProgressBar(string title, string info, float progress) => false;

    public static void ClearProgressBar()
    {
    }

    public static void SetDirty(Object target)
    {
    }

    public static bool IsPersistent(Object target) => AssetDatabase.Contains(target);

    public static Object InstanceIDToObject(int instanceID) => ObjectRegistry.Find(instanceID);
}
