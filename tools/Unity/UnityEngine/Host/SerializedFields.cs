using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>The fields of a script type that Unity serializes.</summary>
internal static class SerializedFields
{
    const BindingFlags Declared =
        BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;

    static readonly Dictionary<Type, FieldInfo[]> _fields = new();

    /// <summary>The fields, base classes first, in the order of their declaration.</summary>
    internal static IReadOnlyList<FieldInfo> Of(Type type)
    {
        if (_fields.TryGetValue(type, out FieldInfo[] fields))
            return fields;
        var levels = new Stack<Type>();
        for (Type level = type; level is not null && !IsFoundation(level); level = level.BaseType)
            levels.Push(level);
        fields = levels.SelectMany(level => ScriptReflection.Fields(level, Declared))
            .Where(IsSerialized)
            .ToArray();
        _fields.Add(type, fields);
        return fields;
    }

    internal static bool IsByReference(FieldInfo field) => field.IsDefined(typeof(SerializeReference), false);

    /// <summary>The element type of an array or List; null for other types.</summary>
    internal static Type ElementType(Type type)
    {
        if (type.IsArray)
            return type.GetArrayRank() == 1 ? type.GetElementType() : null;
        return type.IsGenericType && type.GetGenericTypeDefinition() == typeof(List<>)
            ? type.GetGenericArguments()[0] : null;
    }

    /// <summary>Numbers, text, enums and the engine's value types, which are copied directly.</summary>
    internal static bool IsPlain(Type type) =>
        (type.IsPrimitive && type != typeof(IntPtr) && type != typeof(UIntPtr))
        || type.IsEnum
        || type == typeof(string)
        || (type.IsValueType && IsEngineType(type));

    static bool IsSerialized(FieldInfo field)
    {
        if (field.IsInitOnly || field.IsDefined(typeof(NonSerializedAttribute), false))
            return false;
        if (IsByReference(field))
            return true;
        if (!field.IsPublic && !field.IsDefined(typeof(SerializeField), false))
            return false;
        return IsSerializable(ElementType(field.FieldType) ?? field.FieldType);
    }

    static bool IsSerializable(Type type) =>
        IsPlain(type)
        || typeof(Object).IsAssignableFrom(type)
        || (!type.IsAbstract && !type.IsInterface && !type.IsArray && ElementType(type) is null && !IsSystemType(type)
            && !typeof(Delegate).IsAssignableFrom(type) && type.IsDefined(typeof(SerializableAttribute), false));

    static bool IsFoundation(Type type) => type.Assembly == typeof(Object).Assembly || type == typeof(object);

    static bool IsEngineType(Type type) =>
        type.Assembly == typeof(Object).Assembly || type.Namespace == "Unity.Mathematics";

    static bool IsSystemType(Type type) => type.Assembly == typeof(object).Assembly;
}
