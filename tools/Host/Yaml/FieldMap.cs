using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using YamlDotNet.RepresentationModel;

namespace Glint.Host;

/// <summary>
/// The fields of an object or of a nested struct. An absent field has its default, as in Unity; a field of the wrong
/// kind is refused by name.
/// </summary>
internal readonly struct FieldMap
{
    const int ShownCharacters = 40;

    readonly ObjectRecord _record;
    readonly string _path;

    internal FieldMap(ObjectRecord record, YamlMappingNode node, string path = "")
    {
        _record = record;
        Node = node;
        _path = path;
    }

    internal YamlMappingNode Node { get; }

    internal bool Has(string key) => Node.Child(key) is not null;

    internal string Text(string key, string absent = "") => Scalar(key, "text") ?? absent;

    internal long Integer(string key, long absent = 0)
    {
        if (Scalar(key, "a number") is not string text)
            return absent;
        return Scalars.TryInteger(text, out Int128 value) && value >= long.MinValue && value <= long.MaxValue
            ? (long)value : throw Wrong(key, "a whole number of 64 bits", text);
    }

    /// <summary>A 32-bit mask, written as a signed or an unsigned number.</summary>
    internal int Bits(string key, int absent)
    {
        long value = Integer(key, absent);
        return value is >= int.MinValue and <= uint.MaxValue
            ? unchecked((int)value)
            : throw Wrong(key, "a mask of 32 bits", value.ToString());
    }

    /// <summary>An integer used for sizes and offsets.</summary>
    internal int Count(string key, int absent = 0)
    {
        long value = Integer(key, absent);
        return value is >= 0 and <= int.MaxValue
            ? (int)value
            : throw Wrong(key, "a count from 0 to 2147483647", value.ToString());
    }

    internal float Number(string key, float absent = 0f)
    {
        if (Scalar(key, "a number") is not string text)
            return absent;
        return Scalars.TryNumber(text, out float value) ? value : throw Wrong(key, "a number", text);
    }

    internal bool Flag(string key, bool absent) => Integer(key, absent ? 1 : 0) != 0;

    internal ObjectReference Reference(string key)
    {
        YamlNode node = Node.Child(key);
        if (node.IsEmpty())
            return default;
        return ObjectReference.TryRead(node, out ObjectReference reference)
            ? reference
            : throw Wrong(key, "a reference {fileID: ...}", node.ToString());
    }

    /// <summary>A nested struct; empty if absent.</summary>
    internal FieldMap Map(string key) => Node.Child(key) switch
    {
        YamlMappingNode map => new FieldMap(_record, map, PathOf(key) + "."),
        YamlNode node when !node.IsEmpty() => throw Wrong(key, "a mapping", node.ToString()),
        _ => new FieldMap(_record, new YamlMappingNode(), PathOf(key) + "."),
    };

    /// <summary>The structs of a list; none if absent.</summary>
    internal IReadOnlyList<FieldMap> Maps(string key)
    {
        FieldMap self = this;
        return List(key).Select((node, index) => new FieldMap(
            self._record, node as YamlMappingNode ?? throw self.Wrong($"{key}[{index}]", "a mapping", node.ToString()),
            $"{self.PathOf(key)}[{index}].")).ToList();
    }

    internal IReadOnlyList<ObjectReference> References(string key)
    {
        FieldMap self = this;
        return List(key).Select((node, index) => ObjectReference.TryRead(node, out ObjectReference reference)
            ? reference : throw self.Wrong($"{key}[{index}]", "a reference {fileID: ...}", node.ToString())).ToList();
    }

    internal IReadOnlyList<string> Texts(string key)
    {
        FieldMap self = this;
        return List(key).Select((node, index) => node is YamlScalarNode scalar
            ? scalar.Value ?? ""
            : throw self.Wrong($"{key}[{index}]", "text", node.ToString())).ToList();
    }

    internal GlintException Wrong(string key, string expected, string actual)
    {
        string line = string.Join(' ', actual.Split('\r', '\n'));
        string shown = line.Length > ShownCharacters ? line[..ShownCharacters] + "..." : line;
        return _record.Flaw($"{PathOf(key)} must be {expected}, and is '{shown}': restore the file, "
            + "or save it again in Unity");
    }

    IList<YamlNode> List(string key) => Node.Child(key) switch
    {
        YamlSequenceNode list => list.Children,
        YamlNode node when !node.IsEmpty() => throw Wrong(key, "a list", node.ToString()),
        _ => Array.Empty<YamlNode>(),
    };

    string Scalar(string key, string expected) => Node.Child(key) switch
    {
        null => null,
        YamlScalarNode scalar => scalar.Value ?? "",
        YamlNode node => throw Wrong(key, expected, node.ToString()),
    };

    string PathOf(string key) => _path + key;
}
