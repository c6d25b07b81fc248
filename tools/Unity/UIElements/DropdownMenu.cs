using System;
using System.Collections.Generic;

namespace UnityEngine.UIElements;

public class DropdownMenu
{
    readonly List<DropdownMenuItem> _items = new();

    public List<DropdownMenuItem> MenuItems() => _items;

    public void AppendAction(
        string actionName, Action<DropdownMenuAction> action,
        DropdownMenuAction.Status status = DropdownMenuAction.Status.Normal) =>
        _items.Add(new DropdownMenuAction(actionName, action));
}

public abstract class DropdownMenuItem
{
}

public class DropdownMenuAction : DropdownMenuItem
{
    readonly Action<DropdownMenuAction> _action;

    internal DropdownMenuAction(string name, Action<DropdownMenuAction> action) =>
        (this.name, _action) = (name, action);

    [Flags]
    public enum Status
    {
        None = 0,
        Normal = 1,
        Disabled = 2,
        Checked = 4,
        Hidden = 8,
    }

    public string name { get; }

    public void Execute() => _action(this);
}
