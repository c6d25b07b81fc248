using System;
using System.Linq;
using Glint.Host;

namespace UnityEngine;

/// <summary>The project has no Resources folder; only the search over all objects in memory is needed.</summary>
public sealed class Resources
{
    public static Object[] FindObjectsOfTypeAll(Type type) =>
        ObjectRegistry.All().Where(type.IsInstanceOfType).ToArray();

    public static T[] FindObjectsOfTypeAll<T>()
        where T : Object => ObjectRegistry.All().OfType<T>().ToArray();

    public static Object InstanceIDToObject(int instanceID) => ObjectRegistry.Find(instanceID);

    public static AsyncOperation UnloadUnusedAssets() => AsyncOperation.Completed();
}
