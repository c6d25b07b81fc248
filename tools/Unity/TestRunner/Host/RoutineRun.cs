using System;
using System.Collections;
using System.Collections.Generic;
using System.Diagnostics;
using System.Runtime.ExceptionServices;
using NUnit.Framework;

namespace Glint.Host;

/// <summary>
/// One run of a test's routine. Frames are stepped until it ends, throws, logs an unexpected error or exceeds its time.
/// In play mode it runs as a coroutine, so that it waits as in the game; in edit mode it may only yield null.
/// </summary>
internal sealed class RoutineRun
{
    readonly Stack<IEnumerator> _nested = new();
    ExceptionDispatchInfo _failure;
    bool _hasEnded;

    RoutineRun(IEnumerator routine) => _nested.Push(routine);

    internal static void ToEnd(IEnumerator routine, TimeSpan limit)
    {
        var run = new RoutineRun(routine);
        if (Engine.IsPlaying)
            run.Play(limit);
        else
            run.Edit(limit);
        run._failure?.Throw();
    }

    void Play(TimeSpan limit)
    {
        Engine.StartCoroutine(Steps());
        StepFrames(limit);
    }

    void Edit(TimeSpan limit)
    {
        var steps = Steps();
        StepFrames(limit, () =>
        {
            if (steps.MoveNext() && steps.Current != null)
                throw new InvalidOperationException("an edit-mode test can only yield null, "
                    + $"not {steps.Current.GetType().Name}");
        });
    }

    void StepFrames(TimeSpan limit, Action afterFrame = null)
    {
        var clock = Stopwatch.StartNew();
        try
        {
            while (!_hasEnded)
            {
                Engine.Step();
                afterFrame?.Invoke();
                if (_hasEnded)
                    return;
                if (LogScope.Innermost?.UnexpectedErrors() is string errors)
                    throw new AssertionException(errors);
                if (clock.Elapsed > limit)
                    throw new AssertionException($"Test exceeded Timeout value of {limit.TotalMilliseconds}ms");
            }
        }
        finally
        {
            _hasEnded = true;
        }
    }

    // The first step is a separate frame, so that the test's code starts after Update like every later part. A nested
    // routine is stepped here, so that its exceptions are caught.
    IEnumerator Steps()
    {
        yield return null;
        while (!_hasEnded && TryStep(out var current))
        {
            if (current is IEnumerator inner)
                _nested.Push(inner);
            else
                yield return current;
        }
        _hasEnded = true;
    }

    // Steps to the next yield of the innermost routine; false at the end of the outermost, or after an exception.
    bool TryStep(out object current)
    {
        current = null;
        try
        {
            while (_nested.Count > 0)
            {
                if (_nested.Peek().MoveNext())
                {
                    current = _nested.Peek().Current;
                    return true;
                }
                _nested.Pop();
            }
        }
        catch (Exception exception)
        {
            _failure = ExceptionDispatchInfo.Capture(exception);
        }
        return false;
    }
}
