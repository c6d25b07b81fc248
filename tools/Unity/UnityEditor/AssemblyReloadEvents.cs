using Glint.Host;

namespace UnityEditor;

/// <summary>Scripts are never reloaded here; a test says when Unity would.</summary>
public static class AssemblyReloadEvents
{
    public delegate void AssemblyReloadCallback();

    public static event AssemblyReloadCallback beforeAssemblyReload;

    public static event AssemblyReloadCallback afterAssemblyReload;

    /// <summary>
    /// The events and messages of a reload: OnDisable before it and OnEnable after it. All fields keep their values.
    /// </summary>
    internal static void Reload()
    {
        beforeAssemblyReload?.Invoke();
        PlayerLoop.Restart();
        afterAssemblyReload?.Invoke();
    }
}
