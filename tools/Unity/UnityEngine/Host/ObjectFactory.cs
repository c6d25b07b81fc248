using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.SceneManagement;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>Makes objects for a loader: construct and attach, fill the fields, then awaken all together.</summary>
internal static class ObjectFactory
{
    /// <summary>
    /// A GameObject without components. Without a scene (default) it is a prefab asset and never awakens.
    /// </summary>
    internal static GameObject NewGameObject(string name, Scene scene) =>
        ObjectRegistry.Make(true, () => new GameObject(name, scene.Data));

    /// <summary>Constructs a component without any message; the Transform comes first.</summary>
    internal static Component Attach(GameObject owner, Type type) => Attach(owner, type, true);

    internal static Component Attach(GameObject owner, Type type, bool fromFile)
    {
        var component = (Component)ObjectRegistry.Make(fromFile, () => ScriptReflection.New(type));
        owner.Add(component);
        return component;
    }

    /// <summary>An asset object (Mesh, Material, ComputeShader, ScriptableObject) without any message.</summary>
    internal static T NewAsset<T>()
        where T : Object => (T)NewAsset(typeof(T));

    internal static Object NewAsset(Type type) =>
        (Object)ObjectRegistry.Make(true, () => ScriptReflection.New(type));

    /// <summary>
    /// Ends loading after all fields are filled: OnValidate for all, then Awake and OnEnable of active objects, in
    /// execution order. In edit mode only types that run there receive more than OnValidate.
    /// </summary>
    internal static void Awaken(IReadOnlyList<GameObject> roots) => Activation.Awaken(roots);

    /// <summary>Ends loading of an asset.</summary>
    internal static void Awaken(ScriptableObject asset)
    {
        Messages.Call(asset, "OnValidate");
        asset.Awaken();
    }
}
