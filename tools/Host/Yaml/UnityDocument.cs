using System;
using System.IO;
using System.Linq;
using Glint.Core;
using YamlDotNet.Core;
using YamlDotNet.RepresentationModel;

namespace Glint.Host;

/// <summary>
/// One object of a Unity file: <c>--- !u!CLASS &amp;ID</c> and its content. The content is parsed on demand, so that
/// unused objects cost nothing.
/// </summary>
internal sealed class UnityDocument
{
    readonly string _file;
    readonly string _text;
    readonly Range _content;
    readonly int _contentLine;
    string _typeName;
    YamlMappingNode _fields;

    internal UnityDocument(string file, int classId, long id, bool isStripped, string text, Range content,
        int contentLine)
    {
        _file = file;
        ClassId = classId;
        Id = id;
        IsStripped = isStripped;
        _text = text;
        _content = content;
        _contentLine = contentLine;
    }

    internal int ClassId { get; }

    internal long Id { get; }

    /// <summary>True for a stand-in for an object of a prefab instance.</summary>
    internal bool IsStripped { get; }

    /// <summary>Name of the class, at the beginning of the content.</summary>
    internal string TypeName
    {
        get
        {
            Read();
            return _typeName;
        }
    }

    internal YamlMappingNode Fields
    {
        get
        {
            Read();
            return _fields;
        }
    }

    void Read()
    {
        if (_fields is not null)
            return;
        YamlStream stream;
        try
        {
            HexValues values = new(_text[_content]);
            stream = Load(values);
            // Text that only looks like a value.
            if (!values.AreAllPassed)
                stream = Load(new Parser(new StringReader(_text[_content])));
        }
        catch (YamlException error)
        {
            throw Damaged(error.Start.Line, error.Message, error);
        }
        catch (ArgumentException error)
        {
            // The parser's exception for a document that ends where a value is expected.
            throw Damaged(1, "ends too early", error);
        }

        if (stream.Documents.Count != 1
            || stream.Documents[0].RootNode is not YamlMappingNode { Children.Count: 1 } root
            || root.Children.First() is not { Key: YamlScalarNode name, Value: YamlNode value })
            throw Damaged(1, "not one object with a class name", null);
        _typeName = name.Value;
        _fields = value as YamlMappingNode
            ?? (value.IsEmpty() ? new YamlMappingNode() : throw Damaged(1, $"{name.Value} has no fields", null));
    }

    static YamlStream Load(IParser parser)
    {
        YamlStream stream = new();
        stream.Load(new DepthGuard(parser));
        return stream;
    }

    GlintException Damaged(long line, string what, Exception cause)
    {
        string oneLine = string.Join(' ', what.Split('\r', '\n')).TrimEnd('.');
        return new GlintException($"{_file}:{_contentLine + line - 1}: damaged YAML in object &{Id}: {oneLine}: "
            + "restore the file, or save it again in Unity", cause);
    }
}
