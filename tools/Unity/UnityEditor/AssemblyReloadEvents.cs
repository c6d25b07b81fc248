namespace UnityEditor;

/// <summary>Scripts are never reloaded here; a test raises the events itself.</summary>
public static class AssemblyReloadEvents
{
    public delegate void AssemblyReloadCallback();

    public static event AssemblyReloadCallback beforeAssemblyReload;

    public static event AssemblyReloadCallback afterAssemblyReload;

    internal static void RaiseBefore() => beforeAssemblyReload?.Invoke();

    internal static void RaiseAfter() => afterAssemblyReload?.Invoke();
}
