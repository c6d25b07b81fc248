using System;
using System.Collections.Generic;
using System.Linq;

namespace UnityEngine.UIElements;

public abstract class CallbackEventHandler
{
    readonly List<Delegate> _callbacks = new();

    public void RegisterCallback<TEventType>(
        EventCallback<TEventType> callback, TrickleDown useTrickleDown = TrickleDown.NoTrickleDown)
        where TEventType : EventBase<TEventType>, new() => _callbacks.Add(callback);

    /// <summary>Calls the callbacks registered here; events do not travel through the tree.</summary>
    internal void Raise<TEventType>(TEventType raised)
        where TEventType : EventBase<TEventType>, new()
    {
        foreach (EventCallback<TEventType> callback in _callbacks.OfType<EventCallback<TEventType>>().ToArray())
            callback(raised);
    }
}

public abstract class Focusable : CallbackEventHandler
{
}
