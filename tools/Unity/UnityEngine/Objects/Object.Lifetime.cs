using System;
using Glint.Host;
using UnityEngine.SceneManagement;

namespace UnityEngine;

public partial class Object
{
    public static void Destroy(Object obj) => Destroy(obj, 0f);

    public static void Destroy(Object obj, float t) => Destruction.Schedule(obj, t);

    public static void DestroyImmediate(Object obj) => DestroyImmediate(obj, false);

    public static void DestroyImmediate(Object obj, bool allowDestroyingAssets) =>
        Destruction.Now(obj, allowDestroyingAssets);

    public static void DontDestroyOnLoad(Object target)
    {
        if (IsNull(target))
            return;
        GameObject gameObject = target as GameObject ?? (target as Component)?.gameObject;
        if (gameObject is null)
            return;
        if (!Engine.IsPlaying)
            throw new InvalidOperationException("DontDestroyOnLoad can only be used in play mode.");
        if (gameObject.transform.parent != null)
            Debug.LogWarning("DontDestroyOnLoad only works for root GameObjects or components on root GameObjects.");
        else
            SceneRegistry.MoveRoot(gameObject, SceneRegistry.Persistent);
    }

    public static Object Instantiate(Object original) => Cloner.Clone(original, Placement.AsIs);

    public static Object Instantiate(Object original, Scene scene) => Cloner.Clone(original, Placement.In(scene));

    public static Object Instantiate(Object original, Transform parent) => Instantiate(original, parent, false);

    public static Object Instantiate(Object original, Transform parent, bool instantiateInWorldSpace) =>
        Cloner.Clone(original, Placement.Under(parent, instantiateInWorldSpace));

    public static Object Instantiate(Object original, Vector3 position, Quaternion rotation) =>
        Cloner.Clone(original, Placement.At(position, rotation, null));

    public static Object Instantiate(Object original, Vector3 position, Quaternion rotation, Transform parent) =>
        Cloner.Clone(original, Placement.At(position, rotation, parent));

    public static T Instantiate<T>(T original)
        where T : Object => (T)Instantiate((Object)original);

    public static T Instantiate<T>(T original, Transform parent)
        where T : Object => (T)Instantiate((Object)original, parent);

    public static T Instantiate<T>(T original, Transform parent, bool worldPositionStays)
        where T : Object => (T)Instantiate((Object)original, parent, worldPositionStays);

    public static T Instantiate<T>(T original, Vector3 position, Quaternion rotation)
        where T : Object => (T)Instantiate((Object)original, position, rotation);

    public static T Instantiate<T>(T original, Vector3 position, Quaternion rotation, Transform parent)
        where T : Object => (T)Instantiate((Object)original, position, rotation, parent);
}
