using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Host;

namespace UnityEngine.SceneManagement;

public struct Scene
{
    readonly int m_Handle;

    internal Scene(SceneData data) => m_Handle = data.Handle;

    public int handle => m_Handle;

    public string path => Data?.Path ?? "";

    public string name
    {
        get => Data?.Name ?? "";
        set
        {
            if (Data is { } data)
                data.Name = value;
        }
    }

    public bool isLoaded => Data?.IsLoaded ?? false;

    public bool isDirty => Data?.IsDirty ?? false;

    public int rootCount => Data?.Roots.Count ?? 0;

    /// <summary>-1 for a scene that is not in the build settings.</summary>
    public int buildIndex => Data is { Path.Length: > 0 } data ? SceneLoads.BuildScenes.IndexOf(data.Path) : -1;

    internal SceneData Data => SceneRegistry.ByHandle(m_Handle);

    public static bool operator ==(Scene lhs, Scene rhs) => lhs.m_Handle == rhs.m_Handle;

    public static bool operator !=(Scene lhs, Scene rhs) => lhs.m_Handle != rhs.m_Handle;

    public bool IsValid() => Data is not null;

    public GameObject[] GetRootGameObjects()
    {
        if (!IsValid())
            throw new ArgumentException("The scene is invalid.");
        if (!isLoaded && !Application.isPlaying)
            throw new ArgumentException("The scene is not loaded.");
        return Data.Roots.Select(root => root.Owner).ToArray();
    }

    public void GetRootGameObjects(List<GameObject> rootGameObjects)
    {
        rootGameObjects.Clear();
        rootGameObjects.AddRange(GetRootGameObjects());
    }

    public override int GetHashCode() => m_Handle;

    public override bool Equals(object other) => other is Scene scene && this == scene;
}
