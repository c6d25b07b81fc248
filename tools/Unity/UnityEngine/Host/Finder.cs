using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>Searches the scenes, roots in order and parents before children.</summary>
internal static class Finder
{
    internal static IEnumerable<Object> InScenes(Type type, FindObjectsInactive inactive, FindObjectsSortMode sort)
    {
        IEnumerable<Object> found = Nodes()
            .Where(node => inactive == FindObjectsInactive.Include || node.Owner.ActiveCached)
            .SelectMany(node => node.Owner.Components.Prepend<Object>(node.Owner))
            .Where(item => type.IsInstanceOfType(item) && (item.Flags & HideFlags.DontSave) == 0);
        return sort == FindObjectsSortMode.InstanceID ? found.OrderBy(item => item.GetInstanceID()) : found;
    }

    /// <summary>An active object by name or path; a leading slash means a root.</summary>
    internal static GameObject ByPath(string path)
    {
        if (string.IsNullOrEmpty(path))
            return null;
        string[] steps = path.TrimStart('/').Split('/', 2);
        foreach (Transform node in Nodes().Where(node => node.Owner.ActiveCached && node.Owner.Name == steps[0]))
        {
            if (path[0] == '/' && node.parent is not null)
                continue;
            Transform match = steps.Length == 1 ? node : node.Find(steps[1]);
            if (match is not null && match.Owner.ActiveCached)
                return match.Owner;
        }
        return null;
    }

    internal static GameObject FirstWithTag(string tag) => WithTag(tag).FirstOrDefault();

    internal static List<GameObject> WithTag(string tag)
    {
        TagManager.RequireTag(tag);
        return Nodes().Select(node => node.Owner).Where(item => item.ActiveCached && item.tag == tag).ToList();
    }

    static IEnumerable<Transform> Nodes() =>
        SceneRegistry.WithPersistent.SelectMany(scene => scene.Roots).SelectMany(root => root.Descendants());
}
