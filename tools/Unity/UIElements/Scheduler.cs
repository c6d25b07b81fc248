using System;
using System.Collections.Generic;

namespace UnityEngine.UIElements;

public interface IVisualElementScheduler
{
    IVisualElementScheduledItem Execute(Action updateEvent);
}

public interface IVisualElementScheduledItem
{
    void ExecuteLater(long delayMs);

    IVisualElementScheduledItem StartingIn(long delayMs);

    IVisualElementScheduledItem Every(long intervalMs);
}

/// <summary>Stores scheduled actions; a test runs them.</summary>
internal sealed class Scheduler : IVisualElementScheduler
{
    readonly List<ScheduledItem> _items;

    internal Scheduler(List<ScheduledItem> items) => _items = items;

    public IVisualElementScheduledItem Execute(Action updateEvent)
    {
        var item = new ScheduledItem { Run = updateEvent };
        _items.Add(item);
        return item;
    }
}

internal sealed class ScheduledItem : IVisualElementScheduledItem
{
    internal Action Run { get; init; }

    /// <summary>Number of times the item was postponed.</summary>
    internal int Delays { get; private set; }

    public void ExecuteLater(long delayMs) => Delays++;

    public IVisualElementScheduledItem StartingIn(long delayMs) => this;

    public IVisualElementScheduledItem Every(long intervalMs) => this;
}
