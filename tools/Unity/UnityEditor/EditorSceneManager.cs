using System;
using System.Linq;
using Glint.Host;
using UnityEngine;
using UnityEngine.Events;
using UnityEngine.SceneManagement;

namespace UnityEditor.SceneManagement;

public enum OpenSceneMode
{
    Single,
    Additive,
    AdditiveWithoutLoading,
}

public enum NewSceneMode
{
    Single,
    Additive,
}

public enum NewSceneSetup
{
    EmptyScene,
    DefaultGameObjects,
}

public sealed class EditorSceneManager : SceneManager
{
    public delegate void NewSceneCreatedCallback(Scene scene, NewSceneSetup setup, NewSceneMode mode);

    public delegate void SceneOpeningCallback(string path, OpenSceneMode mode);

    public delegate void SceneOpenedCallback(Scene scene, OpenSceneMode mode);

    public delegate void SceneSavingCallback(Scene scene, string path);

    public delegate void SceneClosingCallback(Scene scene, bool removingScene);

    public delegate void SceneClosedCallback(Scene scene);

    public static event NewSceneCreatedCallback newSceneCreated;

    public static event SceneOpeningCallback sceneOpening;

    public static event SceneOpenedCallback sceneOpened;

    /// <summary>Scenes are never saved by the host; a test raises the event.</summary>
    public static event SceneSavingCallback sceneSaving;

    public static event SceneClosingCallback sceneClosing;

    public static event SceneClosedCallback sceneClosed;

    public static event UnityAction<Scene, Scene> activeSceneChangedInEditMode;

    public static Scene OpenScene(string scenePath) => OpenScene(scenePath, OpenSceneMode.Single);

    /// <summary>For edit mode: the scene is open on return. Its path is an asset path.</summary>
    public static Scene OpenScene(string scenePath, OpenSceneMode mode)
    {
        RequireEditMode("OpenScene", "SceneManager.LoadScene() or EditorSceneManager.LoadSceneInPlayMode()");
        if (SceneLoads.Resolve(scenePath) != scenePath)
            throw new ArgumentException($"Scene file not found: '{scenePath}'.");
        Scene known = GetSceneByPath(scenePath);
        if (mode != OpenSceneMode.Single && known.isLoaded)
            return known;

        sceneOpening?.Invoke(scenePath, mode);
        SceneData scene =
            known.IsValid() && mode != OpenSceneMode.Single ? known.Data : SceneRegistry.AddFile(scenePath);
        if (mode == OpenSceneMode.Single)
            Isolate(scene);
        if (mode != OpenSceneMode.AdditiveWithoutLoading)
            SceneRegistry.Fill(scene);
        var opened = new Scene(scene);
        sceneOpened?.Invoke(opened, mode);
        return opened;
    }

    public static Scene NewScene(NewSceneSetup setup) => NewScene(setup, NewSceneMode.Single);

    public static Scene NewScene(NewSceneSetup setup, NewSceneMode mode)
    {
        RequireEditMode("NewScene", "SceneManager.CreateScene()");
        SceneData scene = SceneRegistry.AddUntitled();
        if (mode == NewSceneMode.Single)
            Isolate(scene);
        var created = new Scene(scene);
        if (setup == NewSceneSetup.DefaultGameObjects)
            MoveGameObjectToScene(DefaultCamera(), created);
        newSceneCreated?.Invoke(created, setup, mode);
        return created;
    }

    /// <summary>False for the only scene, which remains open.</summary>
    public static bool CloseScene(Scene scene, bool removeScene)
    {
        if (!scene.IsValid() || sceneCount < 2)
            return false;
        sceneClosing?.Invoke(scene, removeScene);
        SceneRegistry.Close(scene.Data, removeScene);
        sceneClosed?.Invoke(scene);
        return true;
    }

    /// <summary>By asset path, whatever the build settings list; the scene is loaded in the next frame.</summary>
    public static Scene LoadSceneInPlayMode(string path, LoadSceneParameters parameters) =>
        LoadScene(path, parameters);

    public static AsyncOperation LoadSceneAsyncInPlayMode(string path, LoadSceneParameters parameters) =>
        LoadSceneAsync(path, parameters);

    /// <summary>There are no other scenes than those that SceneManager knows.</summary>
    public static bool IsPreviewSceneObject(UnityEngine.Object obj) => false;

    public static bool MarkSceneDirty(Scene scene) => scene.IsValid() && (scene.Data.IsDirty = true);

    internal static void RaiseSaving(Scene scene) => sceneSaving?.Invoke(scene, scene.path);

    static void Isolate(SceneData scene)
    {
        Scene previous = GetActiveScene();
        Scene[] closing = SceneRegistry.Scenes.Where(other => other != scene)
            .Select(other => new Scene(other)).ToArray();
        foreach (Scene other in closing)
            sceneClosing?.Invoke(other, true);
        SceneRegistry.Isolate(scene);
        foreach (Scene other in closing)
            sceneClosed?.Invoke(other);
        activeSceneChangedInEditMode?.Invoke(previous, new Scene(scene));
    }

    static GameObject DefaultCamera()
    {
        var camera = new GameObject("Main Camera", typeof(Camera)) { tag = "MainCamera" };
        camera.transform.position = new Vector3(0f, 1f, -10f);
        return camera;
    }

    static void RequireEditMode(string what, string instead)
    {
        if (Engine.IsPlaying)
            throw new InvalidOperationException($"{what} cannot be used during play mode, "
                + $"please use {instead} instead.");
    }
}
