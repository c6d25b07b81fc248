using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using Glint.Core;
using UnityEngine.Serialization;
using YamlDotNet.RepresentationModel;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>
/// Reads the serialized fields of a script by Unity's rules. An absent key keeps the initialiser's value. No text,
/// list or serializable class is null afterwards.
/// </summary>
internal sealed class FieldReader
{
    // Unity ignores nested serializable classes below this depth.
    const int MaxDepth = 10;

    readonly ObjectRecord _record;
    readonly ILinks _links;

    FieldReader(ObjectRecord record, ILinks links)
    {
        _record = record;
        _links = links;
    }

    internal static void Fill(Object target, ObjectRecord record, ILinks links) =>
        new FieldReader(record, links).Fields(target, record.Fields, "", 0);

    void Fields(object target, FieldMap source, string path, int depth)
    {
        foreach (FieldInfo field in SerializedFields.Of(target.GetType()))
        {
            string key = Key(field, source);
            if (SerializedFields.IsByReference(field))
            {
                if (key is not null)
                    throw _record.Flaw($"{path}{key} is a [SerializeReference] field, "
                        + "which is not read outside of Unity: give it a serializable class by value");
                continue;
            }
            object current = field.GetValue(target);
            field.SetValue(target, key is null
                ? NeverNull(current, field.FieldType, depth)
                : Value(source.Node.Child(key), field.FieldType, current, path + key, depth));
        }
        // The script's own callback runs when all objects are filled.
        if (depth > 0)
            Callbacks.AfterDeserialize(target);
    }

    static string Key(FieldInfo field, FieldMap source) => field.GetCustomAttributes<FormerlySerializedAsAttribute>()
        .Select(former => former.oldName).Prepend(field.Name).FirstOrDefault(source.Has);

    object Value(YamlNode node, Type type, object current, string path, int depth)
    {
        if (typeof(Object).IsAssignableFrom(type))
            return Link(node, type, path);
        if (SerializedFields.ElementType(type) is Type element)
            return List(Elements(node, element, path, depth), type, element);
        if (type.IsPrimitive || type.IsEnum || type == typeof(string))
            return Scalar(node, type, path);
        if (node is not YamlMappingNode map)
            return node.IsEmpty() ? NeverNull(current, type, depth) : throw Wrong(path, "a mapping", node);
        FieldMap fields = new(_record, map, path + ".");
        if (SerializedFields.IsPlain(type))
            return EngineValues.Read(fields, current ?? ScriptReflection.New(type),
                (child, childType, old, key) => Value(child, childType, old, $"{path}.{key}", depth));
        if (depth >= MaxDepth)
            return current;
        object value = current ?? ScriptReflection.New(type);
        Fields(value, fields, path + ".", depth + 1);
        return value;
    }

    Object Link(YamlNode node, Type type, string path)
    {
        if (node.IsEmpty())
            return null;
        return ObjectReference.TryRead(node, out ObjectReference reference)
            ? _links.Resolve(reference, type, _record, path) : throw Wrong(path, "a reference {fileID: ...}", node);
    }

    IReadOnlyList<object> Elements(YamlNode node, Type element, string path, int depth)
    {
        if (node is YamlSequenceNode list)
            return list.Children.Select((item, index) => Value(item, element, null, $"{path}[{index}]", depth)
                ?? NeverNull(null, element, depth)).ToList();
        if (node.IsEmpty())
            return [];
        int width = PackedArray.Width(element);
        if (width == 0 || !(node is YamlScalarNode || PackedOverrides.IsOne(node)))
            throw Wrong(path, "a list", node);
        List<Int128> values = PackedArray.Decode(node, element)
            ?? throw Wrong(path, $"a text of {width}-byte hexadecimal numbers", node);
        return values.Select((value, index) => Whole(value, element, $"{path}[{index}]")).ToList();
    }

    static object List(IReadOnlyList<object> items, Type type, Type element)
    {
        if (type.IsArray)
        {
            Array array = Array.CreateInstance(element, items.Count);
            for (int i = 0; i < items.Count; i++)
                array.SetValue(items[i], i);
            return array;
        }
        IList list = (IList)ScriptReflection.New(type);
        foreach (object item in items)
            list.Add(item);
        return list;
    }

    object Scalar(YamlNode node, Type type, string path)
    {
        if (node is not YamlScalarNode { Value: var text })
            throw Wrong(path, type == typeof(string) ? "text" : "a number", node);
        if (type == typeof(string))
            return text ?? "";
        // An element added by an override of the array's size has no value yet.
        if (string.IsNullOrEmpty(text))
            return ScriptReflection.New(type);
        if (type == typeof(float))
            return Scalars.TryNumber(text, out float single) ? single : throw Wrong(path, "a number", node);
        if (type == typeof(double))
            return Scalars.TryNumber(text, out double number) ? number : throw Wrong(path, "a number", node);
        return Scalars.TryInteger(text, out Int128 value)
            ? Whole(value, type, path)
            : throw Wrong(path, "a whole number", node);
    }

    object Whole(Int128 value, Type type, string path)
    {
        (Int128 min, Int128 max) = WholeNumbers.Range(type);
        return value >= min && value <= max
            ? WholeNumbers.Make(value, type) : throw Wrong(path, $"a whole number from {min} to {max}",
                new YamlScalarNode(value.ToString()));
    }

    object NeverNull(object current, Type type, int depth)
    {
        if (typeof(Object).IsAssignableFrom(type))
            return current;
        if (type == typeof(string))
            return current ?? "";
        if (SerializedFields.ElementType(type) is Type element)
            return current ?? List([], type, element);
        if (SerializedFields.IsPlain(type) || depth >= MaxDepth)
            return current ?? (type.IsValueType ? ScriptReflection.New(type) : null);
        object value = current ?? ScriptReflection.New(type);
        Fields(value, new FieldMap(_record, new YamlMappingNode()), "", depth + 1);
        return value;
    }

    GlintException Wrong(string path, string expected, YamlNode node) =>
        new FieldMap(_record, new YamlMappingNode())
            .Wrong(path, expected, node is YamlScalarNode scalar ? scalar.Value : node.ToString());
}
