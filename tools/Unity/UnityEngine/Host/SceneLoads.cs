using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace Glint.Host;

/// <summary>
/// Scenes requested in play mode, synchronously or not: both are loaded at the start of the next frame.
/// </summary>
internal static class SceneLoads
{
    static readonly List<AsyncOperation> _operations = new();
    static readonly Dictionary<AsyncOperation, Action> _work = new();

    /// <summary>Scene paths of the build settings, which make a scene loadable by its name.</summary>
    internal static List<string> BuildScenes { get; } = new();

    /// <summary>The asset path for a name, a path without extension or a whole path; null if there is none.</summary>
    internal static string Resolve(string scene)
    {
        if (string.IsNullOrEmpty(scene))
            return null;
        foreach (string path in new[] { scene, scene + ".unity", "Assets/" + scene + ".unity" })
        {
            if (path.EndsWith(".unity", StringComparison.Ordinal) && Engine.Assets?.Exists(path) == true)
                return path;
        }
        return BuildScenes.FirstOrDefault(path =>
            string.Equals(System.IO.Path.GetFileNameWithoutExtension(path), scene, StringComparison.OrdinalIgnoreCase));
    }

    /// <summary>Null, with Unity's error in the log, if the scene does not exist.</summary>
    internal static (SceneData Scene, AsyncOperation Operation)? Load(string scene, LoadSceneMode mode)
    {
        string path = Resolve(scene);
        if (path is null)
        {
            Debug.LogError(
                $"Scene '{scene}' couldn't be loaded because it is neither a scene file of the project nor in "
                + "its build settings.");
            return null;
        }
        SceneData data = SceneRegistry.AddFile(path);
        return (data, Begin(() => Arrive(data, mode)));
    }

    internal static AsyncOperation Unload(SceneData scene)
    {
        if (scene is null)
            throw new ArgumentException("Scene to unload is invalid");
        if (SceneRegistry.Scenes.Count(other => other.IsLoaded) < 2)
        {
            Debug.LogWarning($"Unloading the last loaded scene {scene.Path} is not supported.");
            return null;
        }
        return Begin(() =>
        {
            SceneRegistry.Remove(scene);
            SceneManager.RaiseUnloaded(scene);
        });
    }

    /// <summary>Processes the requests of earlier frames.</summary>
    internal static void Complete()
    {
        foreach (AsyncOperation operation in _operations.ToArray())
        {
            if (!operation.allowSceneActivation)
                break;
            _operations.Remove(operation);
            _work.Remove(operation, out Action work);
            try
            {
                work();
            }
            catch (Exception exception)
            {
                Debug.LogException(exception);
            }
            operation.Finish();
        }
    }

    internal static void Clear()
    {
        _operations.Clear();
        _work.Clear();
    }

    static AsyncOperation Begin(Action work)
    {
        var operation = new AsyncOperation();
        _operations.Add(operation);
        _work.Add(operation, work);
        return operation;
    }

    static void Arrive(SceneData scene, LoadSceneMode mode)
    {
        if (mode == LoadSceneMode.Single)
        {
            SceneRegistry.Isolate(scene);
            Clock.MarkLevelLoad();
        }
        SceneRegistry.Fill(scene);
        SceneManager.RaiseLoaded(scene, mode);
    }
}
