using System;
using Glint.Host;

namespace UnityEngine;

public class ScriptableObject : Object
{
    public static ScriptableObject CreateInstance(Type type)
    {
        if (type is null || !typeof(ScriptableObject).IsAssignableFrom(type) || type.IsAbstract)
            throw new ArgumentException($"{type} is no concrete ScriptableObject.", nameof(type));
        var item = (ScriptableObject)ScriptReflection.New(type);
        item.Awaken();
        return item;
    }

    public static T CreateInstance<T>()
        where T : ScriptableObject => (T)CreateInstance(typeof(T));

    /// <summary>Unity wakes scriptable objects in edit mode too.</summary>
    internal void Awaken()
    {
        Messages.Call(this, "Awake");
        Messages.Call(this, "OnEnable");
    }

    internal override void OnDestroyed()
    {
        Messages.Call(this, "OnDisable");
        Messages.Call(this, "OnDestroy");
    }

    internal override void CopyFrom(Object source, CloneMap map)
    {
        base.CopyFrom(source, map);
        FieldCopier.Copy(source, this, map);
    }
}
