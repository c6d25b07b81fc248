using System;
using System.Reflection;
using UnityEditor;

namespace Glint.Host;

/// <summary>What the editor does with the scripts when it has loaded them.</summary>
public static class EditorStartup
{
    /// <summary>
    /// Runs the static constructors and methods that ask for it; the host calls it once the project is open.
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
