using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace Glint.Host;

/// <summary>The open scenes, at least one. The scene of DontDestroyOnLoad objects is separate.</summary>
internal static class SceneRegistry
{
    static readonly List<SceneData> _scenes = new();
    static readonly Dictionary<int, SceneData> _byHandle = new();
    static string[] _editModePaths = Array.Empty<string>();

    static SceneRegistry()
    {
        Persistent = new SceneData("DontDestroyOnLoad", "") { IsLoaded = true };
        _byHandle.Add(Persistent.Handle, Persistent);
        Clear();
    }

    internal static SceneData Persistent { get; }

    internal static SceneData Active { get; private set; }

    internal static IReadOnlyList<SceneData> Scenes => _scenes;

    internal static IEnumerable<SceneData> WithPersistent => _scenes.Append(Persistent).ToArray();

    internal static SceneData ByHandle(int handle) => _byHandle.GetValueOrDefault(handle);

    internal static SceneData Add(string name, string path)
    {
        var scene = new SceneData(name, path);
        _scenes.Add(scene);
        _byHandle.Add(scene.Handle, scene);
        return scene;
    }

    internal static SceneData AddFile(string path) => Add(Path.GetFileNameWithoutExtension(path), path);

    internal static void Activate(SceneData scene)
    {
        SceneData previous = Active;
        if (ReferenceEquals(previous, scene))
            return;
        Active = scene;
        SceneManager.RaiseActiveChanged(previous, scene);
    }

    /// <summary>Destroys the scene's objects and removes it.</summary>
    internal static void Remove(SceneData scene)
    {
        DestroyRoots(scene);
        scene.IsLoaded = false;
        _scenes.Remove(scene);
        _byHandle.Remove(scene.Handle);
        if (ReferenceEquals(Active, scene) && _scenes.Count > 0)
            Activate(_scenes[0]);
    }

    /// <summary>Destroys the scene's objects; the unloaded scene may remain in the list.</summary>
    internal static void Close(SceneData scene, bool remove)
    {
        if (remove)
        {
            Remove(scene);
            return;
        }
        DestroyRoots(scene);
        scene.IsLoaded = false;
    }

    /// <summary>Makes this the only scene, and the active one.</summary>
    internal static void Isolate(SceneData scene)
    {
        foreach (SceneData other in _scenes.Where(other => !ReferenceEquals(other, scene)).ToArray())
        {
            DestroyRoots(other);
            _scenes.Remove(other);
            SceneManager.RaiseUnloaded(other);
            _byHandle.Remove(other.Handle);
        }
        Activate(scene);
    }

    /// <summary>Loads the scene from the open project; a scene that fails to load is removed.</summary>
    internal static void Fill(SceneData scene)
    {
        if (Engine.Assets is null)
            throw new InvalidOperationException($"Scene '{scene.Path}' cannot be loaded: no project is open.");
        try
        {
            Engine.Assets.LoadScene(scene.Path, new Scene(scene));
        }
        catch
        {
            if (_scenes.Count == 1)
                Activate(AddUntitled());
            Remove(scene);
            throw;
        }
        scene.IsLoaded = true;
    }

    internal static void MoveRoot(GameObject root, SceneData scene)
    {
        root.SceneData?.Roots.Remove(root.Node);
        scene.Roots.Add(root.Node);
        foreach (Transform node in root.Node.Descendants())
            node.Owner.SceneData = scene;
    }

    /// <summary>
    /// Enters play mode: scenes with a file are reloaded if Play does that, and objects of the others wake unchanged.
    /// </summary>
    internal static void Reload()
    {
        _editModePaths = _scenes.Select(scene => scene.Path).Where(path => path.Length > 0).ToArray();
        foreach (SceneData scene in _scenes.ToArray())
        {
            if (scene.Path.Length == 0 || !Engine.ReloadsScenes)
            {
                Activation.Rewake(scene.Roots.Select(root => root.Owner).ToList());
                continue;
            }
            DestroyRoots(scene);
            scene.IsLoaded = false;
            Fill(scene);
            SceneManager.RaiseLoaded(scene, LoadSceneMode.Additive);
        }
    }

    /// <summary>Leaves play mode: reloads the scenes that were open before it from their files.</summary>
    internal static void RestoreEditMode()
    {
        string[] paths = _editModePaths;
        Clear();
        if (paths.Length == 0)
            return;
        SceneData untitled = Active;
        foreach (string path in paths)
            Fill(AddFile(path));
        Remove(untitled);
    }

    internal static void DestroyAll()
    {
        foreach (SceneData scene in WithPersistent)
            DestroyRoots(scene);
    }

    internal static void Clear()
    {
        DestroyAll();
        foreach (SceneData scene in _scenes)
            _byHandle.Remove(scene.Handle);
        _scenes.Clear();
        _editModePaths = Array.Empty<string>();
        Active = AddUntitled();
    }

    internal static SceneData AddUntitled()
    {
        SceneData scene = Add("", "");
        scene.IsLoaded = true;
        return scene;
    }

    static void DestroyRoots(SceneData scene)
    {
        foreach (Transform root in scene.Roots.ToArray())
            Destruction.Now(root.Owner);
    }
}
