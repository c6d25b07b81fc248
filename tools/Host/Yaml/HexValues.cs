using System;
using System.Buffers;
using System.Collections.Generic;
using System.Text;
using YamlDotNet.Core;
using YamlDotNet.Core.Events;

namespace Glint.Host;

/// <summary>
/// Passes the values of a document to its reader. Long hexadecimal ones, such as the vertices of a mesh, go around the
/// YAML parser, which reads letter by letter.
/// </summary>
internal sealed class HexValues : IParser
{
    const int MinLength = 1 << 10;
    const string Placeholder = "0";

    static readonly SearchValues<char> _digits = SearchValues.Create("0123456789abcdefABCDEF");

    readonly Dictionary<(long Line, long Column), string> _values = new();
    readonly IParser _parser;
    ParsingEvent _current;

    internal HexValues(string text) => _parser = new Parser(new System.IO.StringReader(TakeFrom(text)));

    /// <summary>Whether each value was passed on in its place.</summary>
    internal bool AreAllPassed => _values.Count == 0;

    public ParsingEvent Current => _current;

    public bool MoveNext()
    {
        bool hasMoved = _parser.MoveNext();
        _current = _parser.Current;
        if (_values.Count > 0 && _current is Scalar { Value: Placeholder } scalar
            && _values.Remove((scalar.Start.Line, scalar.Start.Column), out string value))
            _current = new Scalar(scalar.Anchor, scalar.Tag, value, scalar.Style, scalar.IsPlainImplicit,
                scalar.IsQuotedImplicit, scalar.Start, scalar.End);
        return hasMoved;
    }

    // Returns the text with a placeholder for each value that ends its line.
    string TakeFrom(string text)
    {
        StringBuilder rest = new();
        int copied = 0;
        long line = 0;
        for (int start = 0, end; start < text.Length; start = end + 1)
        {
            line++;
            end = text.IndexOf('\n', start) is >= 0 and var found ? found : text.Length;
            if (end - start < MinLength)
                continue;
            int value = text.IndexOf(": ", start, end - start, StringComparison.Ordinal) + 2;
            ReadOnlySpan<char> hex = value < 2 ? default : text.AsSpan(value, end - value).TrimEnd('\r');
            if (hex.Length < MinLength || hex.ContainsAnyExcept(_digits))
                continue;
            rest.Append(text, copied, value - copied).Append(Placeholder);
            copied = value + hex.Length;
            _values.Add((line, value - start + 1), hex.ToString());
        }
        return copied == 0 ? text : rest.Append(text, copied, text.Length - copied).ToString();
    }
}
