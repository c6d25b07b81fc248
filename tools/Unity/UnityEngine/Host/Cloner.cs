using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>
/// Instantiate: a deep copy of an object with its hierarchy, like writing it to a file and reading it back.
/// </summary>
internal static class Cloner
{
    internal static Object Clone(Object original, Placement placement)
    {
        if (Object.IsNull(original))
            throw new ArgumentException("The Object you want to instantiate is null.");
        GameObject root = original as GameObject ?? (original as Component)?.gameObject;
        return root is null ? CloneAsset(original) : CloneHierarchy(original, root, placement);
    }

    static Object CloneAsset(Object original)
    {
        var clone = (Object)ScriptReflection.New(original.GetType());
        clone.CopyFrom(original, new CloneMap());
        clone.Name = original.Name + "(Clone)";
        if (clone is ScriptableObject scriptable)
            scriptable.Awaken();
        return clone;
    }

    static Object CloneHierarchy(Object original, GameObject root, Placement placement)
    {
        var map = new CloneMap();
        GameObject clone = Shape(root, placement.Scene, map);
        foreach (KeyValuePair<Object, Object> pair in map.Pairs)
            pair.Value.CopyFrom(pair.Key, map);
        clone.Name = root.Name + "(Clone)";
        placement.Apply(clone.Node);
        Activation.Awaken(new[] { clone });
        return map.Of(original);
    }

    // Builds the hierarchy with all its components first; contents are copied once every reference has a counterpart.
    static GameObject Shape(GameObject original, SceneData scene, CloneMap map)
    {
        var clone = new GameObject(original.Name, scene);
        map.Add(original, clone);
        foreach (Component component in original.Components)
            map.Add(component, ObjectFactory.Attach(clone, component.GetType(), false));
        foreach (Transform child in original.Node.Children.ToArray())
            Shape(child.Owner, scene, map).Node.Reparent(clone.Node, false);
        return clone;
    }
}
