using System;
using System.Collections;
using System.Collections.Generic;
using System.Reflection;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>
/// Copies the serialized fields of a script, by Unity's rules: classes by value, null text and lists become empty,
/// object references follow the clone map, [SerializeReference] keeps its graph.
/// </summary>
internal sealed class FieldCopier
{
    // Unity cuts nested serializable classes off at this depth, where a self-containing class would never end.
    const int MaxDepth = 10;

    readonly CloneMap _map;
    readonly Dictionary<object, object> _references = new(ReferenceEqualityComparer.Instance);

    FieldCopier(CloneMap map) => _map = map;

    internal static void Copy(Object source, Object target, CloneMap map) =>
        new FieldCopier(map).CopyFields(source, target, 0);

    void CopyFields(object source, object target, int depth)
    {
        if (source is ISerializationCallbackReceiver sender)
            Call(sender.OnBeforeSerialize, source);
        foreach (FieldInfo field in SerializedFields.Of(source.GetType()))
        {
            object value = field.GetValue(source);
            field.SetValue(target, SerializedFields.IsByReference(field)
                ? Referenced(value, field.FieldType, depth)
                : Value(value, field.FieldType, depth));
        }
        if (target is ISerializationCallbackReceiver receiver)
            Call(receiver.OnAfterDeserialize, target);
    }

    // The script's own code: its exceptions are logged, and copying continues.
    static void Call(Action callback, object script)
    {
        try
        {
            callback();
        }
        catch (Exception exception)
        {
            Debug.LogException(exception, script as Object);
        }
    }

    object Value(object value, Type type, int depth)
    {
        if (typeof(Object).IsAssignableFrom(type))
            return _map.Of((Object)value);
        if (SerializedFields.IsPlain(type))
            return value is null && type == typeof(string) ? "" : value;
        if (SerializedFields.ElementType(type) is { } element)
            return List(value as IList, type, element, item => Value(item, element, depth));
        if (depth >= MaxDepth)
            return null;
        return Contents(value ?? ScriptReflection.NewOrBlank(type), type, depth);
    }

    object Contents(object source, Type type, int depth)
    {
        object copy = ScriptReflection.NewOrBlank(type);
        CopyFields(source, copy, depth + 1);
        return copy;
    }

    object Referenced(object value, Type type, int depth)
    {
        if (SerializedFields.ElementType(type) is { } element)
            return List(value as IList, type, element, item => Referenced(item, element, depth));
        if (value is null)
            return null;
        if (_references.TryGetValue(value, out object known))
            return known;
        object copy = ScriptReflection.NewOrBlank(value.GetType());
        _references.Add(value, copy);
        CopyFields(value, copy, depth + 1);
        return copy;
    }

    static object List(IList source, Type type, Type element, Func<object, object> copy)
    {
        int count = source?.Count ?? 0;
        if (type.IsArray)
        {
            var array = Array.CreateInstance(element, count);
            for (int index = 0; index < count; index++)
                array.SetValue(copy(source[index]), index);
            return array;
        }
        var list = (IList)ScriptReflection.New(type);
        for (int index = 0; index < count; index++)
            list.Add(copy(source[index]));
        return list;
    }
}
