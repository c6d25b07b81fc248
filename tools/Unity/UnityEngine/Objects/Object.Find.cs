using System;
using System.Linq;
using Glint.Host;

namespace UnityEngine;

public enum FindObjectsInactive
{
    Exclude,
    Include,
}

public enum FindObjectsSortMode
{
    None,
    InstanceID,
}

public partial class Object
{
    public static Object[] FindObjectsByType(Type type, FindObjectsSortMode sortMode) =>
        FindObjectsByType(type, FindObjectsInactive.Exclude, sortMode);

    public static Object[] FindObjectsByType(Type type, FindObjectsInactive findObjectsInactive,
        FindObjectsSortMode sortMode) =>
        Finder.InScenes(type, findObjectsInactive, sortMode).ToArray();

    public static T[] FindObjectsByType<T>(FindObjectsSortMode sortMode)
        where T : Object => FindObjectsByType<T>(FindObjectsInactive.Exclude, sortMode);

    public static T[] FindObjectsByType<T>(FindObjectsInactive findObjectsInactive, FindObjectsSortMode sortMode)
        where T : Object => Finder.InScenes(typeof(T), findObjectsInactive, sortMode).Cast<T>().ToArray();

    public static T FindFirstObjectByType<T>()
        where T : Object => FindFirstObjectByType<T>(FindObjectsInactive.Exclude);

    public static T FindFirstObjectByType<T>(FindObjectsInactive findObjectsInactive)
        where T : Object => (T)FindFirstObjectByType(typeof(T), findObjectsInactive);

    public static Object FindFirstObjectByType(Type type) => FindFirstObjectByType(type, FindObjectsInactive.Exclude);

    public static Object FindFirstObjectByType(Type type, FindObjectsInactive findObjectsInactive) =>
        Finder.InScenes(type, findObjectsInactive, FindObjectsSortMode.InstanceID).FirstOrDefault();

    public static T FindAnyObjectByType<T>()
        where T : Object => FindAnyObjectByType<T>(FindObjectsInactive.Exclude);

    public static T FindAnyObjectByType<T>(FindObjectsInactive findObjectsInactive)
        where T : Object => (T)FindAnyObjectByType(typeof(T), findObjectsInactive);

    public static Object FindAnyObjectByType(Type type) => FindAnyObjectByType(type, FindObjectsInactive.Exclude);

    public static Object FindAnyObjectByType(Type type, FindObjectsInactive findObjectsInactive) =>
        Finder.InScenes(type, findObjectsInactive, FindObjectsSortMode.None).FirstOrDefault();
}
