using System;
using System.Collections;
using System.Collections.Generic;
using Glint.Host;

namespace UnityEngine;

/// <summary>A running routine: its enumerators, innermost on top, and its present wait.</summary>
public sealed class Coroutine : YieldInstruction
{
    readonly Stack<IEnumerator> _routines = new();
    readonly IEnumerator _outermost;
    Func<bool> _isDue;

    internal Coroutine(MonoBehaviour owner, IEnumerator routine, string methodName)
    {
        Owner = owner;
        MethodName = methodName;
        _outermost = routine;
        _routines.Push(routine);
    }

    /// <summary>Null for a routine of the host.</summary>
    internal MonoBehaviour Owner { get; }

    internal string MethodName { get; }

    internal ResumePoint ResumesAt { get; private set; }

    /// <summary>Ran to its end, failed or was stopped.</summary>
    internal bool IsDone { get; private set; }

    /// <summary>Exception of a host routine; a behaviour's exception is logged instead.</summary>
    internal Exception Error { get; private set; }

    internal event Action Finished;

    internal bool Runs(IEnumerator routine) => ReferenceEquals(_outermost, routine);

    internal bool IsDue(ResumePoint point) => !IsDone && point == ResumesAt && _isDue();

    /// <summary>
    /// Runs up to the next wait. Nested enumerators and finished waits continue within the same call.
    /// </summary>
    internal void Run()
    {
        while (!IsDone && _routines.TryPeek(out IEnumerator routine))
        {
            if (!Move(routine, out bool moved))
                return;
            if (IsDone)
                return;
            if (!moved)
                _routines.Pop();
            else if (routine.Current is IEnumerator nested)
                _routines.Push(nested);
            else if (!Continues(routine.Current))
                return;
        }
        Finish();
    }

    /// <summary>Stops the routine; routines that wait for it wait forever, as in Unity.</summary>
    internal void Stop() => IsDone = true;

    bool Move(IEnumerator routine, out bool moved)
    {
        moved = false;
        try
        {
            moved = routine.MoveNext();
            return true;
        }
        catch (Exception exception)
        {
            IsDone = true;
            if (Owner is null)
                Error = exception;
            else
                Debug.LogException(exception, Owner);
            return false;
        }
    }

    void Finish()
    {
        if (IsDone)
            return;
        IsDone = true;
        Finished?.Invoke();
    }

    // True if there is no wait.
    bool Continues(object yielded)
    {
        int frame = Time.frameCount;
        switch (yielded)
        {
            case Coroutine { IsDone: true }:
                return true;
            case Coroutine other:
                Await(ResumePoint.Update, () => false);
                other.Finished += Run;
                return false;
            case AsyncOperation operation:
                Await(ResumePoint.Update, () => operation.isDone);
                return false;
            case WaitForSeconds wait:
                double until = Clock.Time + wait.Seconds;
                Await(ResumePoint.Update, () => Time.frameCount > frame && Clock.Time >= until);
                return false;
            case WaitForFixedUpdate:
                Await(ResumePoint.FixedUpdate, () => true);
                return false;
            case WaitForEndOfFrame:
                Await(ResumePoint.EndOfFrame, () => true);
                return false;
            default:
                Await(ResumePoint.Update, () => Time.frameCount > frame);
                return false;
        }
    }

    void Await(ResumePoint point, Func<bool> isDue)
    {
        ResumesAt = point;
        _isDue = isDue;
    }
}
