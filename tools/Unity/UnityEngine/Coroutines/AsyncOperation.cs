using System;

namespace UnityEngine;

public class AsyncOperation : YieldInstruction
{
    Action<AsyncOperation> _completed;

    /// <summary>Called immediately if the operation is already complete.</summary>
    public event Action<AsyncOperation> completed
    {
        add
        {
            if (isDone)
                value(this);
            else
                _completed += value;
        }
        remove => _completed -= value;
    }

    public bool isDone { get; private set; }

    /// <summary>Remains at 0.9 until activation.</summary>
    public float progress => isDone ? 1f : allowSceneActivation ? 0f : 0.9f;

    public int priority { get; set; }

    public bool allowSceneActivation { get; set; } = true;

    internal static AsyncOperation Completed()
    {
        var operation = new AsyncOperation();
        operation.Finish();
        return operation;
    }

    internal void Finish()
    {
        if (isDone)
            return;
        isDone = true;
        _completed?.Invoke(this);
        _completed = null;
    }
}
