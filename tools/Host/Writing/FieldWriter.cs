using System;
using System.Collections;
using System.Reflection;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>Writes the serialized fields of a script in the form that <see cref="FieldReader"/> reads.</summary>
internal sealed class FieldWriter
{
    // Unity ignores nested serializable classes below this depth.
    const int MaxDepth = 10;

    readonly YamlWriter _yaml;
    readonly ReferenceText _references;
    readonly Object _holder;

    FieldWriter(YamlWriter yaml, ReferenceText references, Object holder)
    {
        _yaml = yaml;
        _references = references;
        _holder = holder;
    }

    internal static void Write(YamlWriter yaml, ReferenceText references, Object script) =>
        new FieldWriter(yaml, references, script).Fields(script, 0);

    void Fields(object source, int depth)
    {
        Callbacks.BeforeSerialize(source);
        foreach (FieldInfo field in SerializedFields.Of(source.GetType()))
        {
            object value = field.GetValue(source);
            if (!SerializedFields.IsByReference(field))
                Value(field.Name, value, field.FieldType, depth);
            else if (value is not null)
                throw new UnityException($"{_holder.GetType().Name} of '{_holder.name}': "
                    + $"{field.Name} is a [SerializeReference] field, which is not written outside of Unity: "
                    + "give it a serializable class by value");
        }
    }

    void Value(string key, object value, Type type, int depth)
    {
        if (SerializedFields.ElementType(type) is Type element)
            List(key, value as IList, element, depth);
        else if (Line(value, type, key) is string line)
            _yaml.Field(key, line);
        else if (SerializedFields.IsPlain(type) || depth < MaxDepth)
            _yaml.Map(key, () => Contents(value, type, depth));
    }

    void List(string key, IList list, Type element, int depth)
    {
        int width = PackedArray.Width(element);
        if (width > 0)
            _yaml.Field(key, PackedArray.Encode(list, element));
        else if (!IsTooDeep(element, depth))
            _yaml.List(key, list?.Count ?? 0, index => Item(list[index], element, $"{key}[{index}]", depth));
    }

    void Item(object value, Type type, string path, int depth)
    {
        if (Line(value, type, path) is string line)
            _yaml.Item(line);
        else
            Contents(value, type, depth);
    }

    static bool IsTooDeep(Type type, int depth) =>
        depth >= MaxDepth && !typeof(Object).IsAssignableFrom(type) && !SerializedFields.IsPlain(type);

    // Null for values of several lines.
    string Line(object value, Type type, string path)
    {
        if (typeof(Object).IsAssignableFrom(type))
            return _references.Of((Object)value, _holder, path);
        if (type.IsEnum)
            return PackedArray.Whole(value, type).ToString();
        return Type.GetTypeCode(type) switch
        {
            TypeCode.String => ScalarText.Of((string)value),
            TypeCode.Single => ScalarText.Of((float)value),
            TypeCode.Double => ScalarText.Of((double)value),
            _ when type.IsPrimitive => PackedArray.Whole(value, type).ToString(),
            _ => EngineValueWriter.Line(value),
        };
    }

    // A class is never null in a file: it has the values of a new object.
    void Contents(object value, Type type, int depth)
    {
        object contents = value ?? ScriptReflection.New(type);
        if (!SerializedFields.IsPlain(type))
        {
            Fields(contents, depth + 1);
            return;
        }
        if (EngineValueWriter.Write(_yaml, contents))
            return;
        foreach (FieldInfo field in EngineValueWriter.Fields(type))
            Value(field.Name, field.GetValue(contents), field.FieldType, depth);
    }
}
