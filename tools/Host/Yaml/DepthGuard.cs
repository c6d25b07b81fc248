using System;
using YamlDotNet.Core;
using YamlDotNet.Core.Events;

namespace Glint.Host;

/// <summary>
/// Passes only Unity's subset of YAML: no anchors or aliases, and no nesting deep enough to overflow the stack.
/// </summary>
internal sealed class DepthGuard : IParser
{
    // Unity nests serialized classes at most ten deep.
    const int Limit = 100;

    readonly IParser _parser;
    int _depth;

    internal DepthGuard(IParser parser) => _parser = parser;

    public ParsingEvent Current => _parser.Current;

    public bool MoveNext()
    {
        if (!MoveParser())
            return false;
        ParsingEvent current = _parser.Current;
        _depth += current.NestingIncrease;
        if (_depth > Limit)
            throw new YamlException(current.Start, current.End, $"nested more than {Limit} deep");
        if (current is AnchorAlias or NodeEvent { Anchor.IsEmpty: false })
            throw new YamlException(current.Start, current.End, "an anchor or alias, which Unity does not write");
        return true;
    }

    // The parser answers some unfinished structures with an exception without a useful message.
    bool MoveParser()
    {
        try
        {
            return _parser.MoveNext();
        }
        catch (InvalidOperationException error)
        {
            Mark position = _parser.Current?.End ?? Mark.Empty;
            throw new YamlException(position, position, "a structure without its end", error);
        }
    }
}
