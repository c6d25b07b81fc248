using System;
using System.Collections;
using Glint.Host;

namespace UnityEngine;

public class MonoBehaviour : Behaviour
{
    public bool didAwake { get; private set; }
    public bool didStart { get; private set; }

    /// <summary>OnEnable has been sent and OnDisable has not: the player loop knows this behaviour.</summary>
    internal bool IsRunning { get; private set; }

    internal bool HeedsMessages => Engine.IsPlaying || Messages.Of(GetType()).RunsInEditMode;

    public static void print(object message) => Debug.Log(message);

    public Coroutine StartCoroutine(IEnumerator routine)
    {
        if (routine is null)
            throw new NullReferenceException("routine is null");
        return StartCoroutine(routine, null);
    }

    public Coroutine StartCoroutine(string methodName) => StartCoroutine(methodName, null);

    public Coroutine StartCoroutine(string methodName, object value)
    {
        EnsureAlive();
        IEnumerator routine = Messages.Routine(this, methodName, value);
        return routine is null ? null : StartCoroutine(routine, methodName);
    }

    public void StopCoroutine(IEnumerator routine) => Coroutines.Stop(this, coroutine => coroutine.Runs(routine));

    public void StopCoroutine(Coroutine routine) =>
        Coroutines.Stop(this, coroutine => ReferenceEquals(coroutine, routine));

    public void StopCoroutine(string methodName) =>
        Coroutines.Stop(this, coroutine => coroutine.MethodName == methodName);

    public void StopAllCoroutines() => Coroutines.Stop(this, _ => true);

    /// <summary>Calls Awake once, then OnEnable if enabled, in the cases in which Unity does.</summary>
    internal void Wake()
    {
        if (!HeedsMessages)
            return;
        if (!didAwake)
        {
            didAwake = true;
            Messages.Call(this, "Awake");
        }
        Enable();
    }

    internal void Enable()
    {
        if (IsRunning || IsDestroyed || !didAwake || !isActiveAndEnabled || !HeedsMessages)
            return;
        IsRunning = true;
        PlayerLoop.Add(this);
        Messages.Call(this, "OnEnable");
    }

    internal void Disable()
    {
        if (!IsRunning)
            return;
        IsRunning = false;
        PlayerLoop.Remove(this);
        Messages.Call(this, "OnDisable");
    }

    internal void StartOnce()
    {
        if (didStart || !IsRunning)
            return;
        didStart = true;
        object result = Messages.Call(this, "Start");
        if (result is IEnumerator routine && !IsDestroyed && gameObject.activeInHierarchy)
            StartCoroutine(routine);
    }

    /// <summary>Returns to the state before Awake, for the start of play mode.</summary>
    internal void Forget()
    {
        didAwake = false;
        didStart = false;
    }

    internal override void OnEnabledChanged()
    {
        if (EnabledSelf)
            Enable();
        else
            Disable();
    }

    internal override void OnDestroyed()
    {
        Coroutines.Stop(this, _ => true);
        base.OnDestroyed();
    }

    internal override void CopyFrom(Object source, CloneMap map)
    {
        base.CopyFrom(source, map);
        FieldCopier.Copy(source, this, map);
    }

    Coroutine StartCoroutine(IEnumerator routine, string methodName)
    {
        EnsureAlive();
        if (!gameObject.activeInHierarchy)
        {
            Debug.LogError(
                $"Coroutine couldn't be started because the the game object '{name}' is inactive!", this);
            return null;
        }
        return Coroutines.Start(this, routine, methodName);
    }
}
