using System;
using System.Reflection;
using UnityEditor;

namespace Glint.Host;

/// <summary>The editor's actions after it has loaded the scripts.</summary>
public static class EditorStartup
{
    /// <summary>
    /// Runs the static constructors and methods with the attributes; the host calls it when the project is open.
    /// </summary>
    public static void Run()
    {
        foreach (Type type in ScriptTypes.All())
        {
            if (type.IsDefined(typeof(InitializeOnLoadAttribute), false))
                ScriptReflection.RunStaticConstructor(type);
        }
        foreach (MethodInfo method in ScriptTypes.StaticMethods<InitializeOnLoadMethodAttribute>())
            Messages.CallStatic(method);
    }
}
