using System;
using System.Globalization;
using System.IO;

namespace Glint.Host;

/// <summary>
/// Writes Unity's form of YAML line by line: two spaces a level, and the dash of a list's item at the indent of the
/// list's key.
/// </summary>
internal sealed class YamlWriter
{
    const int Step = 2;

    readonly TextWriter _text;
    int _indent;
    bool _isFirstOfItem;

    internal YamlWriter(TextWriter text)
    {
        _text = text;
        _text.NewLine = "\n";
        _text.WriteLine("%YAML 1.1");
        _text.WriteLine("%TAG !u! tag:unity3d.com,2011:");
    }

    /// <summary>Begins an object and ends the previous one.</summary>
    internal void Object(int classId, long fileId, string typeName)
    {
        _text.WriteLine(string.Create(CultureInfo.InvariantCulture, $"--- !u!{classId} &{fileId}"));
        _text.WriteLine(typeName + ":");
        _indent = Step;
    }

    /// <param name="value">Value as written in the file; empty for an empty text.</param>
    internal void Field(string key, string value)
    {
        Indent();
        _text.WriteLine($"{key}: {value}");
    }

    internal void Field(string key, long value) => Field(key, value.ToString(CultureInfo.InvariantCulture));

    internal void Field(string key, bool value) => Field(key, value ? 1 : 0);

    internal void Field(string key, Action<TextWriter> writeValue)
    {
        Indent();
        _text.Write(key);
        _text.Write(": ");
        writeValue(_text);
        _text.WriteLine();
    }

    internal void Map(string key, Action writeFields)
    {
        Key(key);
        _indent += Step;
        writeFields();
        _indent -= Step;
    }

    /// <summary>Writes a list of structs or of one-line values.</summary>
    /// <param name="writeItem">Called with the index of an item.</param>
    internal void List(string key, int count, Action<int> writeItem)
    {
        if (count == 0)
        {
            Field(key, "[]");
            return;
        }
        Key(key);
        _indent += Step;
        for (int index = 0; index < count; index++)
        {
            _isFirstOfItem = true;
            writeItem(index);
        }
        _indent -= Step;
    }

    /// <summary>Writes an item of a list of one-line values.</summary>
    internal void Item(string value)
    {
        Indent();
        _text.WriteLine(value);
    }

    void Key(string key)
    {
        Indent();
        _text.WriteLine(key + ":");
    }

    void Indent()
    {
        _text.Write(new string(' ', _isFirstOfItem ? _indent - Step : _indent));
        if (_isFirstOfItem)
            _text.Write("- ");
        _isFirstOfItem = false;
    }
}
