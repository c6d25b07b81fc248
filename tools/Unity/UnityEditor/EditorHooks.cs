using System;
using UnityEngine;

namespace Glint.Host;

/// <summary>What the host may replace of the editor's doings.</summary>
public static class EditorHooks
{
    /// <summary>Called by EditorApplication.Exit with the exit code; returns when the process is to live on.</summary>
    public static Action<int> Exit { get; set; } = Environment.Exit;

    /// <summary>
    /// Told how far a progress bar is, null when it goes; whether somebody pressed its cancel button.
    /// </summary>
    public static Func<float?, bool> ProgressBar { get; set; } = _ => false;

    /// <summary>Where the Scene view would put a new object.</summary>
    public static Vector3 ScenePivot { get; set; }

    /// <summary>Given what is asked for; the path that somebody chose, empty for none.</summary>
    public static Func<string, string> FileDialog { get; set; } = _ => "";
}
