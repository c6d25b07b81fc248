using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using UnityEngine.SceneManagement;
using Object = UnityEngine.Object;

namespace Glint.Host.Tests;

/// <summary>Scenes made by code instead of loaded from files, awakened as by the loader.</summary>
internal sealed class FakeProject : IAssetSource
{
    internal Dictionary<string, Action<Scene>> Scenes { get; } = new();
    internal Dictionary<string, Object> Assets { get; } = new();

    public string ProjectRoot { get; init; } = "/project";

    public bool Exists(string assetPath) => Scenes.ContainsKey(assetPath) || Assets.ContainsKey(assetPath);

    public void LoadScene(string assetPath, Scene scene)
    {
        Scenes[assetPath](scene);
        ObjectFactory.Awaken(scene.Data.Roots.Select(root => root.gameObject).ToArray());
    }

    public Object LoadAsset(string assetPath, Type type) =>
        Assets.TryGetValue(assetPath, out Object asset) && type.IsInstanceOfType(asset) ? asset : null;

    public IEnumerable<KeyValuePair<string, Object>> DefaultReferences(Type script) =>
        Enumerable.Empty<KeyValuePair<string, Object>>();

    public string GuidToPath(string guid) => Assets.Keys.FirstOrDefault(path => PathToGuid(path) == guid);

    public string PathToGuid(string assetPath) => assetPath.GetHashCode(StringComparison.Ordinal).ToString("x32");

    public string ToPhysicalPath(string assetPath) => $"{ProjectRoot}/{assetPath}";

    internal static T Put<T>(Scene scene, string name)
        where T : Component
    {
        GameObject item = ObjectFactory.NewGameObject(name, scene);
        ObjectFactory.Attach(item, typeof(Transform));
        return (T)ObjectFactory.Attach(item, typeof(T));
    }
}
