using System.Text.RegularExpressions;
using UnityEngine;

namespace Glint.Host;

/// <summary>A message that a test expects; without a type, any type matches.</summary>
internal sealed class ExpectedLog
{
    readonly LogType? _type;
    readonly string _text;
    readonly Regex _pattern;

    internal ExpectedLog(LogType? type, string text)
    {
        _type = type;
        _text = text;
    }

    internal ExpectedLog(LogType? type, Regex pattern)
    {
        _type = type;
        _pattern = pattern;
    }

    internal bool Matches(ReceivedLog log)
        => (_type == null || _type == log.Type) && (_pattern?.IsMatch(log.Message) ?? log.Message == _text);

    public override string ToString() =>
        $"[{(_type == null ? "any" : _type.ToString())}] {(_pattern == null ? _text : $"/{_pattern}/")}";
}
