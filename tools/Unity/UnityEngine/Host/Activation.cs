using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace Glint.Host;

/// <summary>Propagates a change of the active state through a hierarchy, with its messages.</summary>
internal static class Activation
{
    /// <summary>Updates the object and its descendants from its own flag and its parent's state.</summary>
    internal static void Refresh(GameObject item)
    {
        bool active = ShouldBeActive(item);
        if (active == item.ActiveCached)
            return;
        if (!active)
        {
            Deactivate(item);
            return;
        }
        var woken = new List<MonoBehaviour>();
        Activate(item, woken);
        Wake(woken);
    }

    internal static void Awaken(IReadOnlyList<GameObject> roots)
    {
        var woken = new List<MonoBehaviour>();
        foreach (GameObject root in roots)
        {
            if (ShouldBeActive(root))
                Activate(root, woken);
        }
        List<MonoBehaviour> all = roots.SelectMany(root => root.Node.Descendants()).SelectMany(Behaviours).ToList();
        foreach (MonoBehaviour behaviour in Ordered(all))
        {
            if (!behaviour.IsDestroyed)
                Messages.Call(behaviour, "OnValidate");
        }
        Wake(woken);
    }

    /// <summary>Starts play mode for objects made in edit mode: they wake as if newly loaded.</summary>
    internal static void Rewake(IReadOnlyList<GameObject> roots)
    {
        foreach (GameObject root in roots)
        {
            if (root.ActiveCached)
                Deactivate(root);
            foreach (MonoBehaviour behaviour in root.Node.Descendants().SelectMany(Behaviours))
            {
                if (Engine.ReloadsScenes || !Messages.Of(behaviour.GetType()).RunsInEditMode)
                    behaviour.Forget();
            }
        }
        Awaken(roots);
    }

    /// <summary>OnDisable comes to children before their parents, OnEnable the other way round.</summary>
    internal static void Deactivate(GameObject item)
    {
        item.ActiveCached = false;
        item.IsDeactivating = true;
        foreach (Transform child in item.Node.Children.ToArray())
        {
            if (child.Owner.ActiveCached)
                Deactivate(child.Owner);
        }
        foreach (MonoBehaviour behaviour in Behaviours(item.Node).ToArray())
        {
            behaviour.Disable();
            behaviour.StopAllCoroutines();
        }
        item.IsDeactivating = false;
    }

    static bool ShouldBeActive(GameObject item)
    {
        Transform parent = item.Node.Ancestors().Skip(1).FirstOrDefault();
        return item.ActiveSelf && item.SceneData is not null && (parent is null || parent.Owner.ActiveCached);
    }

    static void Activate(GameObject item, List<MonoBehaviour> woken)
    {
        item.ActiveCached = true;
        woken.AddRange(Behaviours(item.Node));
        foreach (Transform child in item.Node.Children)
        {
            if (child.Owner.ActiveSelf)
                Activate(child.Owner, woken);
        }
    }

    static void Wake(List<MonoBehaviour> behaviours)
    {
        foreach (MonoBehaviour behaviour in Ordered(behaviours))
        {
            // An earlier one's Awake may have destroyed or deactivated it.
            if (!behaviour.IsDestroyed && behaviour.Owner.ActiveCached)
                behaviour.Wake();
        }
    }

    static IEnumerable<MonoBehaviour> Behaviours(Transform node) => node.Owner.Components.OfType<MonoBehaviour>();

    static MonoBehaviour[] Ordered(List<MonoBehaviour> behaviours) =>
        behaviours.OrderBy(behaviour => Messages.Of(behaviour.GetType()).Order).ToArray();
}
