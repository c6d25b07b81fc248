using System;
using System.Collections.Generic;
using System.Diagnostics.CodeAnalysis;
using System.Linq;
using System.Reflection;
using System.Runtime.CompilerServices;

namespace Glint.Host;

/// <summary>
/// Reflection on types that only a project's files or a loaded assembly name: scripts, engine components, and the
/// types of their fields. The trimmer cannot see which these are, so Cli.csproj keeps their assemblies whole
/// (TrimmerRootAssembly); a List of them is kept because this host itself makes lists.
/// No other code of the host reflects on such types.
/// </summary>
[UnconditionalSuppressMessage("Trimming", "IL2026", Justification = Rooted)]
[UnconditionalSuppressMessage("Trimming", "IL2059", Justification = Rooted)]
[UnconditionalSuppressMessage("Trimming", "IL2067", Justification = Rooted)]
[UnconditionalSuppressMessage("Trimming", "IL2070", Justification = Rooted)]
internal static class ScriptReflection
{
    const string Rooted = "The assemblies that hold scripts, components and their fields' types are trimmer roots.";

    const BindingFlags AnyInstance = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic;

    /// <summary>A new instance, also by a private constructor.</summary>
    /// <exception cref="MissingMethodException">A class has no constructor without parameters.</exception>
    internal static object New(Type type) => Activator.CreateInstance(type, true);

    /// <summary>
    /// A new instance even where there is no constructor without parameters; where there is one, its field values are
    /// the defaults.
    /// </summary>
    internal static object NewOrBlank(Type type) =>
        type.IsValueType || type.GetConstructor(AnyInstance, Type.EmptyTypes) is not null
            ? New(type) : RuntimeHelpers.GetUninitializedObject(type);

    /// <summary>The fields in the order of their declaration.</summary>
    internal static IEnumerable<FieldInfo> Fields(Type type, BindingFlags flags) =>
        type.GetFields(flags).OrderBy(field => field.MetadataToken);

    /// <summary>The instance field of that name; null when there is none.</summary>
    internal static FieldInfo Field(Type type, string name) => type.GetField(name, AnyInstance);

    /// <summary>The instance property of that name without parameters; null when there is none.</summary>
    internal static PropertyInfo Property(Type type, string name) =>
        type.GetProperty(name, AnyInstance, null, null, Type.EmptyTypes, null);

    /// <summary>An instance method that the type itself declares; null when there is none.</summary>
    /// <param name="parameters">Null for any, of which there may be one only.</param>
    internal static MethodInfo DeclaredMethod(Type type, string name, Type[] parameters) => parameters is null
        ? type.GetMethod(name, AnyInstance | BindingFlags.DeclaredOnly)
        : type.GetMethod(name, AnyInstance | BindingFlags.DeclaredOnly, parameters);

    internal static MethodInfo[] Methods(Type type, BindingFlags flags) => type.GetMethods(flags);

    internal static void RunStaticConstructor(Type type) => RuntimeHelpers.RunClassConstructor(type.TypeHandle);

    internal static Type[] Types(Assembly assembly) => assembly.GetTypes();

    internal static bool RefersTo(Assembly assembly, string name) =>
        assembly.GetReferencedAssemblies().Any(reference => reference.Name == name);
}
