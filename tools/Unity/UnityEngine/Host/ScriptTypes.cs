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
                && assembly.GetReferencedAssemblies().Any(reference => reference.Name == engine))
            .SelectMany(assembly => assembly.GetTypes());
    }

    internal static IEnumerable<MethodInfo> StaticMethods<T>()
        where T : Attribute =>
        All().Where(type => !type.ContainsGenericParameters)
            .SelectMany(type => type.GetMethods(AnyStatic))
            .Where(method => method.IsDefined(typeof(T), false));
}
