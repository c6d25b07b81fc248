using YamlDotNet.Core;
using YamlDotNet.Core.Events;

namespace Glint.Host;

/// <summary>
/// Lets pass what Unity writes: no anchors or aliases, and no nesting so deep that reading it would overflow the stack.
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
        if (!_parser.MoveNext())
            return false;
        ParsingEvent current = _parser.Current;
        _depth += current.NestingIncrease;
        if (_depth > Limit)
            throw new YamlException(current.Start, current.End, $"nested more than {Limit} deep");
        if (current is AnchorAlias or NodeEvent { Anchor.IsEmpty: false })
            throw new YamlException(current.Start, current.End, "an anchor or alias, which Unity does not write");
        return true;
    }
}
