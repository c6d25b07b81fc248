using System;
using System.Linq;
using Glint.Host;
using UnityEngine.Events;

namespace UnityEngine.SceneManagement;

public class SceneManager
{
    public static event UnityAction<Scene, LoadSceneMode> sceneLoaded;

    public static event UnityAction<Scene> sceneUnloaded;

    public static event UnityAction<Scene, Scene> activeSceneChanged;

    public static int sceneCount => SceneRegistry.Scenes.Count;

    public static int loadedSceneCount => SceneRegistry.Scenes.Count(scene => scene.IsLoaded);

    public static int sceneCountInBuildSettings => SceneLoads.BuildScenes.Count;

    public static Scene GetActiveScene() => new(SceneRegistry.Active);

    public static bool SetActiveScene(Scene scene)
    {
        if (!scene.IsValid())
            throw new ArgumentException("SceneManager.SetActiveScene failed; the scene is invalid.");
        if (!scene.isLoaded)
            throw new ArgumentException(
                "SceneManager.SetActiveScene failed; "
                + $"scene '{scene.name}' is not loaded and therefore cannot be set active.");
        SceneRegistry.Activate(scene.Data);
        return true;
    }

    public static Scene GetSceneAt(int index)
    {
        if (index < 0 || index >= sceneCount)
            throw new IndexOutOfRangeException($"Scene index \"{index}\" is out of range.");
        return new Scene(SceneRegistry.Scenes[index]);
    }

    public static Scene GetSceneByName(string name) =>
        First(scene => string.Equals(scene.Name, name, StringComparison.OrdinalIgnoreCase));

    public static Scene GetSceneByPath(string scenePath) =>
        First(scene => string.Equals(scene.Path, scenePath, StringComparison.OrdinalIgnoreCase));

    public static Scene CreateScene(string sceneName) => CreateScene(sceneName, default);

    public static Scene CreateScene(string sceneName, CreateSceneParameters parameters)
    {
        if (string.IsNullOrEmpty(sceneName))
            throw new ArgumentException("The scene name cannot be empty.");
        if (!Engine.IsPlaying)
            throw new InvalidOperationException(
                "This cannot be used during edit mode, please use EditorSceneManager.NewScene() instead.");
        if (GetSceneByName(sceneName).IsValid())
            throw new ArgumentException($"Scene with name \"{sceneName}\" already exists.");
        SceneData scene = SceneRegistry.Add(sceneName, "");
        scene.IsLoaded = true;
        return new Scene(scene);
    }

    public static void MoveGameObjectToScene(GameObject go, Scene scene)
    {
        if (go.transform.parent is not null)
            throw new ArgumentException("Gameobject is not a root in a scene.");
        if (!scene.IsValid())
            throw new ArgumentException("The scene is invalid.");
        SceneRegistry.MoveRoot(go, scene.Data);
    }

    public static void LoadScene(string sceneName) => LoadScene(sceneName, LoadSceneMode.Single);

    public static void LoadScene(string sceneName, LoadSceneMode mode) =>
        LoadScene(sceneName, new LoadSceneParameters(mode));

    /// <summary>The scene exists immediately and is loaded in the next frame.</summary>
    public static Scene LoadScene(string sceneName, LoadSceneParameters parameters) =>
        Load(sceneName, parameters) is var (scene, _) ? new Scene(scene) : default;

    public static AsyncOperation LoadSceneAsync(string sceneName) => LoadSceneAsync(sceneName, LoadSceneMode.Single);

    public static AsyncOperation LoadSceneAsync(string sceneName, LoadSceneMode mode) =>
        LoadSceneAsync(sceneName, new LoadSceneParameters(mode));

    public static AsyncOperation LoadSceneAsync(string sceneName, LoadSceneParameters parameters) =>
        Load(sceneName, parameters) is var (_, operation) ? operation : null;

    public static AsyncOperation UnloadSceneAsync(string sceneName)
    {
        Scene scene = GetSceneByPath(sceneName);
        return UnloadSceneAsync(scene.IsValid() ? scene : GetSceneByName(sceneName));
    }

    public static AsyncOperation UnloadSceneAsync(Scene scene) => SceneLoads.Unload(scene.Data);

    public static AsyncOperation UnloadSceneAsync(Scene scene, UnloadSceneOptions options) => UnloadSceneAsync(scene);

    // Edit mode has separate events.
    internal static void RaiseLoaded(SceneData scene, LoadSceneMode mode)
    {
        if (Engine.IsPlaying)
            sceneLoaded?.Invoke(new Scene(scene), mode);
    }

    internal static void RaiseUnloaded(SceneData scene)
    {
        if (Engine.IsPlaying)
            sceneUnloaded?.Invoke(new Scene(scene));
    }

    internal static void RaiseActiveChanged(SceneData previous, SceneData next)
    {
        if (Engine.IsPlaying)
            activeSceneChanged?.Invoke(previous is null ? default : new Scene(previous), new Scene(next));
    }

    static (SceneData Scene, AsyncOperation Operation)? Load(string sceneName, LoadSceneParameters parameters)
    {
        if (!Engine.IsPlaying)
            throw new InvalidOperationException(
                "This cannot be used during edit mode, please use EditorSceneManager.OpenScene() instead.");
        return SceneLoads.Load(sceneName, parameters.loadSceneMode);
    }

    static Scene First(Func<SceneData, bool> which) =>
        SceneRegistry.Scenes.FirstOrDefault(which) is { } scene ? new Scene(scene) : default;
}
