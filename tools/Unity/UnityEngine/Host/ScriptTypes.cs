using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;

namespace Glint.Host;

/// <summary>The loaded assemblies that may contain scripts: those that refer to UnityEngine.</summary>
internal static class ScriptTypes
{
    const BindingFlags AnyStatic =
        BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;

    internal static IEnumerable<Type> All()
    {
        string engine = typeof(ScriptTypes).Assembly.GetName().Name;
        return AppDomain.CurrentDomain.GetAssemblies()
            .Where(assembly => !assembly.IsDynamic
                && ScriptReflection.RefersTo(assembly, engine))
            .SelectMany(ScriptReflection.Types);
    }

    internal static IEnumerable<MethodInfo> StaticMethods<T>()
        where T : Attribute =>
        All().Where(type => !type.ContainsGenericParameters)
            .SelectMany(type => ScriptReflection.Methods(type, AnyStatic))
            .Where(method => method.IsDefined(typeof(T), false));
}
