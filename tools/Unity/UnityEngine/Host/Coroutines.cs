using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace Glint.Host;

/// <summary>All running coroutines, in the order of their start.</summary>
internal static class Coroutines
{
    static readonly List<Coroutine> _all = new();

    /// <summary>Runs the routine up to its first wait and keeps it for later frames.</summary>
    internal static Coroutine Start(MonoBehaviour owner, IEnumerator routine, string methodName)
    {
        var coroutine = new Coroutine(owner, routine, methodName);
        _all.Add(coroutine);
        coroutine.Run();
        return coroutine;
    }

    internal static void Stop(MonoBehaviour owner, Predicate<Coroutine> which)
    {
        foreach (Coroutine coroutine in _all.Where(item => ReferenceEquals(item.Owner, owner)).ToArray())
        {
            if (which(coroutine))
                coroutine.Stop();
        }
        _all.RemoveAll(coroutine => coroutine.IsDone);
    }

    internal static void Resume(ResumePoint point)
    {
        foreach (Coroutine coroutine in _all.ToArray())
        {
            if (coroutine.IsDue(point))
                coroutine.Run();
        }
        _all.RemoveAll(coroutine => coroutine.IsDone);
    }

    internal static void Clear()
    {
        foreach (Coroutine coroutine in _all)
            coroutine.Stop();
        _all.Clear();
    }
}
