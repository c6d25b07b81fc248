using System;

namespace UnityEngine;

[AttributeUsage(AttributeTargets.Field | AttributeTargets.Class, Inherited = true, AllowMultiple = false)]
public abstract class PropertyAttribute : Attribute
{
    protected PropertyAttribute()
    {
    }

    protected PropertyAttribute(bool applyToCollection) => this.applyToCollection = applyToCollection;

    public int order { get; set; }
    public bool applyToCollection { get; }
}

[AttributeUsage(AttributeTargets.All, Inherited = true, AllowMultiple = false)]
public class TooltipAttribute : PropertyAttribute
{
    public readonly string tooltip;

    public TooltipAttribute(string tooltip) => this.tooltip = tooltip;
}

[AttributeUsage(AttributeTargets.Field | AttributeTargets.Class, Inherited = true, AllowMultiple = true)]
public class HeaderAttribute : PropertyAttribute
{
    public readonly string header;

    public HeaderAttribute(string header) => this.header = header;
}

[AttributeUsage(AttributeTargets.Field, Inherited = true, AllowMultiple = true)]
public class SpaceAttribute : PropertyAttribute
{
    public readonly float height;

    public SpaceAttribute() => height = 8f;

    public SpaceAttribute(float height) => this.height = height;
}

[AttributeUsage(AttributeTargets.Field | AttributeTargets.Class, Inherited = true, AllowMultiple = false)]
public sealed class RangeAttribute : PropertyAttribute
{
    public readonly float min;
    public readonly float max;

    public RangeAttribute(float min, float max)
    {
        this.min = min;
        this.max = max;
    }
}

[AttributeUsage(AttributeTargets.Field | AttributeTargets.Class, Inherited = true, AllowMultiple = false)]
public sealed class MinAttribute : PropertyAttribute
{
    public readonly float min;

    public MinAttribute(float min) => this.min = min;
}

[AttributeUsage(AttributeTargets.Field | AttributeTargets.Class, Inherited = true, AllowMultiple = false)]
public sealed class TextAreaAttribute : PropertyAttribute
{
    public readonly int minLines;
    public readonly int maxLines;

    public TextAreaAttribute()
        : this(3, 3)
    {
    }

    public TextAreaAttribute(int minLines, int maxLines)
    {
        this.minLines = minLines;
        this.maxLines = maxLines;
    }
}

[AttributeUsage(AttributeTargets.Field, Inherited = true, AllowMultiple = false)]
public class InspectorNameAttribute : PropertyAttribute
{
    public readonly string displayName;

    public InspectorNameAttribute(string displayName) => this.displayName = displayName;
}

public sealed class HideInInspector : Attribute;

[AttributeUsage(AttributeTargets.Class, AllowMultiple = false)]
public class HelpURLAttribute : Attribute
{
    public HelpURLAttribute(string url) => URL = url;

    public virtual string URL { get; }
}

[AttributeUsage(AttributeTargets.Class, Inherited = true, AllowMultiple = false)]
public class SelectionBaseAttribute : Attribute;
