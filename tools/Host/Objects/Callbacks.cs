using System;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>
/// Calls a script's own code while loading and saving. Its exceptions are logged, as in Unity, and loading continues.
/// </summary>
internal static class Callbacks
{
    internal static void AfterDeserialize(object target)
    {
        if (target is ISerializationCallbackReceiver receiver)
            Call(receiver.OnAfterDeserialize, target);
    }

    internal static void BeforeSerialize(object source)
    {
        if (source is ISerializationCallbackReceiver sender)
            Call(sender.OnBeforeSerialize, source);
    }

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
}
