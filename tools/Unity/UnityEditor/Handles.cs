using Glint.Host;
using UnityEngine;

namespace UnityEditor;

/// <summary>Handles of the Scene view: they are not drawn, and <see cref="EditorHooks.Slide"/> drags them.</summary>
public sealed class Handles
{
    public delegate void CapFunction(int controlID, Vector3 position, Quaternion rotation, float size,
        EventType eventType);

    public static Color color { get; set; }

    public static void DrawWireArc(Vector3 center, Vector3 normal, Vector3 from, float angle, float radius)
    {
    }

    public static void DrawPolyLine(params Vector3[] points)
    {
    }

    public static void DotHandleCap(int controlID, Vector3 position, Quaternion rotation, float size,
        EventType eventType)
    {
    }

    public static Vector3 Slider(Vector3 position, Vector3 direction, float size, CapFunction capFunction, float snap)
    {
        Vector3 moved = EditorHooks.Slide(position, direction);
        EditorGUI.Changed |= moved != position;
        return moved;
    }
}

public sealed class HandleUtility
{
    public static float GetHandleSize(Vector3 position) => 1;
}

public sealed class EditorGUI
{
    internal static bool Changed { get; set; }

    public static void BeginChangeCheck() => Changed = false;

    public static bool EndChangeCheck() => Changed;
}
