using System.Collections.Generic;
using UnityEngine;

namespace Glint.Host;

/// <summary>The enabled behaviours in execution order; equal ones in the order of enabling.</summary>
internal static class PlayerLoop
{
    static readonly List<MonoBehaviour> _running = new();

    internal static void Add(MonoBehaviour behaviour)
    {
        int order = Messages.Of(behaviour.GetType()).Order;
        int index = _running.Count;
        while (index > 0 && Messages.Of(_running[index - 1].GetType()).Order > order)
            index--;
        _running.Insert(index, behaviour);
    }

    internal static void Remove(MonoBehaviour behaviour) => _running.Remove(behaviour);

    /// <summary>OnDisable to all that run, then OnEnable: scripts are reloaded.</summary>
    internal static void Restart()
    {
        MonoBehaviour[] running = _running.ToArray();
        foreach (MonoBehaviour behaviour in running)
            behaviour.Disable();
        foreach (MonoBehaviour behaviour in running)
            behaviour.Enable();
    }

    internal static void StartPending()
    {
        foreach (MonoBehaviour behaviour in _running.ToArray())
            behaviour.StartOnce();
    }

    /// <summary>
    /// Sends a message of the frame. A behaviour enabled meanwhile receives messages from the next phase; one that has
    /// not started is started first.
    /// </summary>
    internal static void Send(string message)
    {
        foreach (MonoBehaviour behaviour in _running.ToArray())
        {
            if (!behaviour.IsRunning || !Messages.Of(behaviour.GetType()).Has(message))
                continue;
            behaviour.StartOnce();
            if (behaviour.IsRunning)
                Messages.Call(behaviour, message);
        }
    }
}
