using System.Collections.Generic;
using UnityEngine;

namespace Glint.Host;

/// <summary>The data behind a Scene value.</summary>
internal sealed class SceneData
{
    static int _handles;

    internal SceneData(string name, string path)
    {
        Handle = ++_handles;
        Name = name;
        Path = path;
    }

    internal int Handle { get; }
    internal string Name { get; set; }

    /// <summary>Asset path; empty for a scene without a file.</summary>
    internal string Path { get; set; }

    internal bool IsLoaded { get; set; }
    internal bool IsDirty { get; set; }
    internal List<Transform> Roots { get; } = new();
}
