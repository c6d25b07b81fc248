using System;
using System.Collections;

namespace UnityEngine;

public abstract class CustomYieldInstruction : IEnumerator
{
    public abstract bool keepWaiting { get; }

    public object Current => null;

    public bool MoveNext() => keepWaiting;

    public virtual void Reset()
    {
    }
}

public sealed class WaitUntil : CustomYieldInstruction
{
    readonly Func<bool> _predicate;

    public WaitUntil(Func<bool> predicate) => _predicate = predicate;

    public override bool keepWaiting => !_predicate();
}

public sealed class WaitWhile : CustomYieldInstruction
{
    readonly Func<bool> _predicate;

    public WaitWhile(Func<bool> predicate) => _predicate = predicate;

    public override bool keepWaiting => _predicate();
}

public class WaitForSecondsRealtime : CustomYieldInstruction
{
    double _until = double.NaN;

    public WaitForSecondsRealtime(float time) => waitTime = time;

    public float waitTime { get; set; }

    // The wait begins at the first query, so that an instance can be reused.
    public override bool keepWaiting
    {
        get
        {
            double now = Time.realtimeSinceStartupAsDouble;
            if (double.IsNaN(_until))
                _until = now + waitTime;
            if (now < _until)
                return true;
            Reset();
            return false;
        }
    }

    public override void Reset() => _until = double.NaN;
}
