using System.Reflection;
using UnityEngine;

namespace Glint.Host;

/// <summary>Calls the static methods to be run when play mode begins.</summary>
internal static class RuntimeInitializers
{
    internal static void Run(RuntimeInitializeLoadType type)
    {
        foreach (MethodInfo method in ScriptTypes.StaticMethods<RuntimeInitializeOnLoadMethodAttribute>())
        {
            if (method.GetCustomAttribute<RuntimeInitializeOnLoadMethodAttribute>().loadType == type)
                Messages.CallStatic(method);
        }
    }
}
