using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>Destroys objects: OnDisable through the hierarchy, then OnDestroy, then they equal null.</summary>
internal static class Destruction
{
    static readonly List<(Object Item, double Time)> _pending = new();
    static readonly HashSet<Object> _underWay = new(ReferenceEqualityComparer.Instance);

    internal static void Schedule(Object item, float delaySeconds)
    {
        if (Object.IsNull(item))
            return;
        if (!Engine.IsPlaying)
        {
            Debug.LogError(
                "Destroy may not be called from edit mode! Use DestroyImmediate instead.\n"
                + "Destroying an object in edit mode destroys it permanently.", item);
            return;
        }
        if (Refused(item, false))
            return;
        _pending.Add((item, Clock.Time + delaySeconds));
    }

    internal static void Now(Object item, bool allowAssets)
    {
        if (!Object.IsNull(item) && !Refused(item, allowAssets))
            Now(item);
    }

    /// <summary>Destroys objects whose time has come.</summary>
    internal static void Flush()
    {
        foreach ((Object Item, double Time) entry in _pending.Where(entry => entry.Time <= Clock.Time).ToArray())
        {
            _pending.Remove(entry);
            Now(entry.Item);
        }
    }

    internal static void Clear() => _pending.Clear();

    internal static void Now(Object item)
    {
        if (item.IsDestroyed || !_underWay.Add(item))
            return;
        if (item is GameObject gameObject)
            Take(gameObject);
        else if (item is Component component)
            Take(component);
        else
            item.MarkDestroyed();
        _underWay.Remove(item);
    }

    static void Take(GameObject gameObject)
    {
        if (gameObject.ActiveCached)
            Activation.Deactivate(gameObject);
        foreach (MonoBehaviour behaviour in Parts(gameObject).OfType<MonoBehaviour>().ToArray())
            Farewell(behaviour);
        List<Object> parts = Parts(gameObject).ToList();
        gameObject.Node.Detach();
        foreach (Object part in parts)
            part.MarkDestroyed();
    }

    static void Take(Component component)
    {
        if (component is MonoBehaviour behaviour)
        {
            behaviour.Disable();
            Farewell(behaviour);
        }
        component.Owner.Remove(component);
        component.MarkDestroyed();
    }

    static void Farewell(MonoBehaviour behaviour)
    {
        if (behaviour.didAwake && behaviour.HeedsMessages && !behaviour.IsDestroyed)
            Messages.Call(behaviour, "OnDestroy");
    }

    static IEnumerable<Object> Parts(GameObject root)
    {
        foreach (Transform node in root.Node.Descendants())
        {
            foreach (Component component in node.Owner.Components)
                yield return component;
            yield return node.Owner;
        }
    }

    static bool Refused(Object item, bool allowAssets)
    {
        if (!allowAssets && IsAsset(item))
        {
            Debug.LogError(
                "Destroying assets is not permitted to avoid data loss.\n"
                + "If you really want to remove an asset use DestroyImmediate (theObject, true);", item);
            return true;
        }
        if (item is Transform)
        {
            Debug.LogError(
                $"Can't destroy Transform component of '{item.Name}'. If you want to destroy the game object, please "
                + "call 'Destroy' on the game object instead. "
                + "Destroying the transform component is not allowed.", item);
            return true;
        }
        return item is Component component && IsRequired(component);
    }

    static bool IsAsset(Object item) =>
        item.AssetPath is not null
        || (item as GameObject ?? (item as Component)?.Owner) is { SceneData: null };

    static bool IsRequired(Component component)
    {
        Component dependent = component.Owner.Components.FirstOrDefault(other =>
            ComponentAdder.Requirements(other.GetType()).Any(type => type.IsInstanceOfType(component)
                && component.Owner.Components.Count(type.IsInstanceOfType) == 1));
        if (dependent is null)
            return false;
        Debug.LogError(
            $"Can't remove {component.GetType().Name} because {dependent.GetType().Name} (Script) depends on it",
            component);
        return true;
    }
}
