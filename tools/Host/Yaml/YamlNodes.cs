using System;
using System.Collections.Generic;
using System.Linq;
using YamlDotNet.RepresentationModel;

namespace Glint.Host;

/// <summary>Operations on YAML nodes: look-up, copy, test for emptiness.</summary>
internal static class YamlNodes
{
    internal static YamlNode Child(this YamlMappingNode map, string key) =>
        map.Children.TryGetValue(new YamlScalarNode(key), out YamlNode value) ? value : null;

    internal static void Set(this YamlMappingNode map, string key, YamlNode value) =>
        map.Children[new YamlScalarNode(key)] = value;

    /// <summary>Items of a list; none if the key is absent or not a list.</summary>
    internal static IList<YamlNode> Items(this YamlMappingNode map, string key) =>
        map.Child(key) is YamlSequenceNode list ? list.Children : Array.Empty<YamlNode>();

    /// <summary>The list under a key, added if absent.</summary>
    internal static YamlSequenceNode ListAt(this YamlMappingNode map, string key)
    {
        if (map.Child(key) is YamlSequenceNode list)
            return list;
        YamlSequenceNode empty = new();
        map.Set(key, empty);
        return empty;
    }

    internal static bool IsEmpty(this YamlNode node) => node is null or YamlScalarNode { Value: null or "" };

    /// <summary>
    /// Number of entries of maps and lists that <see cref="Clone"/> copies: a measure of a copy's memory.
    /// </summary>
    internal static long CopySize(this YamlNode node) => node switch
    {
        YamlMappingNode map when !map.IsFlat() => map.Children.Sum(child => 1 + child.Value.CopySize()),
        YamlSequenceNode list => list.Children.Sum(item => 1 + item.CopySize()),
        _ => 0,
    };

    /// <summary>
    /// A copy with the file's own references renamed. Scalars and maps of scalars are shared with the original; they
    /// are never changed in place.
    /// </summary>
    internal static YamlNode Clone(this YamlNode node, Func<long, long> rename) => node switch
    {
        YamlMappingNode map when ObjectReference.TryRead(map, out ObjectReference reference)
            && reference.IsLocal && !reference.IsNone
            => new ObjectReference(rename(reference.FileId)).ToNode(),
        YamlMappingNode map when !map.IsFlat() => map.CloneFields(rename),
        YamlSequenceNode list => new YamlSequenceNode(list.Children.Select(item => item.Clone(rename))),
        _ => node,
    };

    /// <summary>The fields of an object for a copy of it, in a new map.</summary>
    internal static YamlMappingNode CloneFields(this YamlMappingNode map, Func<long, long> rename) =>
        new(map.Children.Select(child => KeyValuePair.Create(child.Key, child.Value.Clone(rename))));

    static bool IsFlat(this YamlMappingNode map) => map.Children.All(child => child.Value is YamlScalarNode);
}
