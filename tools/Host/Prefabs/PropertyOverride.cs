using System.Collections.Generic;
using YamlDotNet.RepresentationModel;

namespace Glint.Host;

/// <summary>
/// One entry of a prefab instance's m_Modifications: a value or reference for a property path of an object.
/// </summary>
internal sealed class PropertyOverride
{
    // Far above any override made by hand; the limit keeps a damaged file from filling the memory.
    internal const int LargestArray = 1_000_000;

    readonly FieldMap _source;
    readonly ObjectTable _table;
    readonly string _value;
    readonly ObjectReference _reference;
    readonly IReadOnlyList<PropertyStep> _steps;

    /// <param name="table">The table that reserves room when an array grows.</param>
    internal PropertyOverride(FieldMap source, ObjectTable table)
    {
        _source = source;
        _table = table;
        Target = source.Reference("target");
        _value = source.Text("value");
        _reference = source.Reference("objectReference");
        string path = source.Text("propertyPath");
        _steps = PropertyStep.Parse(path)
            ?? throw source.Wrong("propertyPath", "a path such as 'list.Array.data[0].x'", path);
    }

    /// <summary>The object's id in the prefab.</summary>
    internal ObjectReference Target { get; }

    internal void ApplyTo(ObjectRecord record) => Apply(record.Fields.Node, 0);

    // Returns the node's replacement. A node whose kind does not fit the path is unchanged, since Unity drops its
    // override.
    YamlNode Apply(YamlNode node, int at)
    {
        if (at == _steps.Count)
            return NewValue(node);
        PropertyStep step = _steps[at];
        if (step.IsName)
            return ApplyToField(node, step.Name, at);
        if (node is YamlScalarNode { Value.Length: > 0 } or YamlMappingNode)
            return ApplyToPacked(node, step);
        YamlSequenceNode list = node as YamlSequenceNode ?? new YamlSequenceNode();
        if (step.IsSize)
            Resize(list, Size());
        else if (step.Index < list.Children.Count)
            list.Children[step.Index] = Apply(list.Children[step.Index], at + 1);
        return list;
    }

    YamlNode ApplyToField(YamlNode node, string name, int at)
    {
        YamlMappingNode map = node as YamlMappingNode;
        if (map is null && !node.IsEmpty())
            return node;
        // The object's own map is not shared; a nested one may be shared with the prefab.
        if (at > 0)
            map = map is null ? new YamlMappingNode() : new YamlMappingNode(map.Children);
        map.Set(name, Apply(map.Child(name), at + 1));
        return map;
    }

    // An array of int, byte or bool is one text; only its field knows the width of an element.
    YamlNode ApplyToPacked(YamlNode node, PropertyStep step)
    {
        YamlMappingNode packed = node as YamlMappingNode ?? PackedOverrides.Begin(((YamlScalarNode)node).Value);
        if (!PackedOverrides.IsOne(packed))
            return node;
        if (step.IsSize)
            PackedOverrides.AddSize(packed, Size());
        else
            PackedOverrides.AddElement(packed, step.Index, _value);
        return packed;
    }

    YamlNode NewValue(YamlNode old)
    {
        bool isReference = !_reference.IsNone || (_value.Length == 0 && ObjectReference.TryRead(old, out _));
        return isReference ? _reference.ToNode() : new YamlScalarNode(_value);
    }

    int Size()
    {
        int size = _source.Count("value");
        if (size > LargestArray)
            throw _source.Wrong("value", $"an array size of at most {LargestArray}", _value);
        _table.Reserve(size);
        return size;
    }

    // Unity fills a grown array with copies of its last element.
    void Resize(YamlSequenceNode list, int size)
    {
        if (size > list.Children.Count && list.Children.Count > 0)
            _table.Reserve((size - list.Children.Count) * list.Children[^1].CopySize());
        while (list.Children.Count > size)
            list.Children.RemoveAt(list.Children.Count - 1);
        while (list.Children.Count < size)
            list.Children.Add(list.Children.Count == 0 ? new YamlScalarNode("") : list.Children[^1].Clone(id => id));
    }
}
