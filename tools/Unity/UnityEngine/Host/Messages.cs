using System;
using System.Collections;
using System.Collections.Generic;
using System.Reflection;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>
/// Messages of a script type: its message methods, its execution order, and whether it runs in edit mode.
/// </summary>
internal sealed class Messages
{
    static readonly Dictionary<Type, Messages> _types = new();

    readonly Dictionary<string, MethodInfo> _methods = new();
    readonly Type _type;

    Messages(Type type)
    {
        _type = type;
        Order = type.GetCustomAttribute<DefaultExecutionOrder>()?.order ?? 0;
        RunsInEditMode = type.IsDefined(typeof(ExecuteAlways), true) || type.IsDefined(typeof(ExecuteInEditMode), true);
    }

    /// <summary>A loader replaces it if a script's .meta file has an execution order.</summary>
    internal int Order { get; set; }

    internal bool RunsInEditMode { get; }

    internal static Messages Of(Type type)
    {
        if (!_types.TryGetValue(type, out Messages messages))
            _types.Add(type, messages = new Messages(type));
        return messages;
    }

    internal bool Has(string message) => Method(message) is not null;

    /// <summary>Sends a message without arguments. An exception is logged with its object and not propagated.</summary>
    internal static object Call(Object target, string message)
    {
        MethodInfo method = Of(target.GetType()).Method(message);
        if (method is null)
            return null;
        try
        {
            return Invoke(method, target, null);
        }
        catch (Exception exception)
        {
            Debug.LogException(exception, target);
            return null;
        }
    }

    internal static void CallStatic(MethodInfo method)
    {
        try
        {
            Invoke(method, null, null);
        }
        catch (Exception exception)
        {
            Debug.LogException(exception);
        }
    }

    /// <summary>The routine of a method by name; null, with an error logged, if there is none.</summary>
    internal static IEnumerator Routine(MonoBehaviour target, string name, object value)
    {
        MethodInfo method = null;
        for (Type type = target.GetType(); type is not null && method is null; type = type.BaseType)
            method = ScriptReflection.DeclaredMethod(type, name, null);
        if (method is null)
        {
            Debug.LogError($"Coroutine '{name}' couldn't be started!", target);
            return null;
        }
        object[] arguments = method.GetParameters().Length == 0 ? null : new[] { value };
        return Invoke(method, target, arguments) as IEnumerator;
    }

    static object Invoke(MethodInfo method, object target, object[] arguments) =>
        method.Invoke(target, BindingFlags.DoNotWrapExceptions, null, arguments, null);

    // The nearest declaration counts, private ones of base classes included, since Unity searches by name only.
    MethodInfo Method(string message)
    {
        if (_methods.TryGetValue(message, out MethodInfo method))
            return method;
        for (Type type = _type; type is not null && type.Assembly != typeof(Object).Assembly; type = type.BaseType)
        {
            method = ScriptReflection.DeclaredMethod(type, message, Type.EmptyTypes);
            if (method is not null)
                break;
        }
        _methods.Add(message, method);
        return method;
    }
}
