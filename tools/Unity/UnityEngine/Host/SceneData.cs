using System.Collections.Generic;
using UnityEngine;

namespace Glint.Host;

/// <summary>What a Scene value refers to.</summary>
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

    /// <summary>Asset path; empty for a scene that no file holds.</summary>
    internal string Path { get; set; }

    internal bool IsLoaded { get; set; }
    internal bool IsDirty { get; set; }
    internal List<Transform> Roots { get; } = new();
}
