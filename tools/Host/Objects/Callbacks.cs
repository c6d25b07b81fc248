using System;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>Calls of a script's own code while loading: what it throws is logged, as in Unity, and loading goes on.</summary>
internal static class Callbacks
{
    internal static void AfterDeserialize(object target)
    {
        if (target is not ISerializationCallbackReceiver receiver)
            return;
        try
        {
            receiver.OnAfterDeserialize();
        }
        catch (Exception exception)
        {
            Debug.LogException(exception, target as Object);
        }
    }
}
