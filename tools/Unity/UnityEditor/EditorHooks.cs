using System;
using UnityEngine;

namespace Glint.Host;

/// <summary>Editor functions that the host may replace.</summary>
public static class EditorHooks
{
    /// <summary>Called by EditorApplication.Exit with the exit code; returns if the process continues.</summary>
    public static Action<int> Exit { get; set; } = Environment.Exit;

    /// <summary>
    /// Called with the state of a progress bar, null when it closes; returns true if cancel was pressed.
    /// </summary>
    public static Func<float?, bool> ProgressBar { get; set; } = _ => false;

    /// <summary>Where the Scene view would put a new object.</summary>
    public static Vector3 ScenePivot { get; set; }

    /// <summary>Called with position and direction of each handle; returns where the user drags it.</summary>
    public static Func<Vector3, Vector3, Vector3> Slide { get; set; } = (position, _) => position;

    /// <summary>Called with a path that the system's file browser would show.</summary>
    public static Action<string> Reveal { get; set; } = _ => { };

    /// <summary>Called with the dialog's title; returns the chosen path, empty for none.</summary>
    public static Func<string, string> FileDialog { get; set; } = _ => "";
}
