using System;
using System.Collections.Generic;
using System.Linq;

namespace UnityEngine.UIElements;

public enum PickingMode
{
    Position,
    Ignore,
}

/// <summary>
/// A node of the tree. Nothing is laid out or drawn: a test sets the size and calls the drawing callbacks.
/// </summary>
public class VisualElement : Focusable
{
    readonly List<VisualElement> _children = new();
    readonly HashSet<string> _classes = new();

    public VisualElement() => schedule = new Scheduler(Scheduled);

    public string viewDataKey { get; set; }

    public string tooltip { get; set; }

    public PickingMode pickingMode { get; set; }

    public bool enabledSelf { get; set; } = true;

    public VisualElement parent { get; private set; }

    public IStyle style { get; } = new InlineStyle();

    public VisualElementStyleSheetSet styleSheets => new(this);

    public IVisualElementScheduler schedule { get; }

    public Action<MeshGenerationContext> generateVisualContent { get; set; }

    public Rect contentRect => Size;

    public Rect worldBound => Size;

    internal Rect Size { get; set; }

    internal List<StyleSheet> Sheets { get; } = new();

    internal List<ScheduledItem> Scheduled { get; } = new();

    public IEnumerable<VisualElement> Children() => _children;

    public void Add(VisualElement child)
    {
        child.parent?._children.Remove(child);
        child.parent = this;
        _children.Add(child);
    }

    public void Clear()
    {
        foreach (VisualElement child in _children)
            child.parent = null;
        _children.Clear();
    }

    public IEnumerable<string> GetClasses() => _classes;

    public void AddToClassList(string className) => _classes.Add(className);

    public void EnableInClassList(string className, bool enable)
    {
        if (enable)
            _classes.Add(className);
        else
            _classes.Remove(className);
    }

    public void SetEnabled(bool value) => enabledSelf = value;

    public void MarkDirtyRepaint()
    {
    }

    /// <summary>The element and its descendants, parents first.</summary>
    internal IEnumerable<VisualElement> Tree() => _children.SelectMany(child => child.Tree()).Prepend(this);

    /// <summary>Draws only the element, and returns the drawing.</summary>
    internal Painter2D Paint()
    {
        var context = new MeshGenerationContext();
        generateVisualContent?.Invoke(context);
        return context.painter2D;
    }
}
