using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>AddComponent: adds the required components first, then wakes the component.</summary>
internal static class ComponentAdder
{
    internal static Component Add(GameObject owner, Type type)
    {
        if (type is null)
            throw new ArgumentNullException(nameof(type));
        if (!typeof(Component).IsAssignableFrom(type) || type.IsAbstract || type.ContainsGenericParameters)
        {
            Debug.LogError($"Can't add script behaviour '{type.Name}': it is no concrete component.", owner);
            return null;
        }
        if (Duplicates(owner, type))
        {
            Debug.LogError(
                $"Can't add '{type.Name}' to {owner.Name} because a '{type.Name}' is already added to the game object!",
                owner);
            return null;
        }

        foreach (Type required in Requirements(type))
        {
            if (!required.IsAbstract && owner.GetComponent(required) is null)
                Add(owner, required);
        }
        Component component = ObjectFactory.Attach(owner, type, false);
        if (component is MonoBehaviour behaviour)
            Begin(behaviour);
        return component;
    }

    internal static IEnumerable<Type> Requirements(Type type) =>
        type.GetCustomAttributes<RequireComponent>(true)
            .SelectMany(attribute => new[] { attribute.m_Type0, attribute.m_Type1, attribute.m_Type2 })
            .Where(required => required is not null);

    static void Begin(MonoBehaviour behaviour)
    {
        if (!Engine.IsPlaying)
            FillDefaults(behaviour);
        Messages.Call(behaviour, "OnValidate");
        if (behaviour.Owner.ActiveCached)
            behaviour.Wake();
        if (!Engine.IsPlaying)
            Messages.Call(behaviour, "Reset");
    }

    static void FillDefaults(MonoBehaviour behaviour)
    {
        if (Engine.Assets is null)
            return;
        foreach ((string name, Object value) in Engine.Assets.DefaultReferences(behaviour.GetType()))
            SerializedFields.Of(behaviour.GetType()).Single(field => field.Name == name).SetValue(behaviour, value);
    }

    // At most one component of the attribute's owner and its subclasses.
    static bool Duplicates(GameObject owner, Type type)
    {
        if (typeof(Transform).IsAssignableFrom(type))
            return owner.Node is not null;
        for (Type level = type; level != typeof(Component); level = level.BaseType)
        {
            if (IsSingle(level) && owner.Components.Any(level.IsInstanceOfType))
                return true;
        }
        return false;
    }

    static bool IsSingle(Type type) =>
        type.IsDefined(typeof(DisallowMultipleComponent), false)
        || type == typeof(Camera) || type == typeof(MeshFilter) || type == typeof(Renderer) || type == typeof(LODGroup);
}
