using System;
using System.Collections.Generic;
using System.Linq;
using YamlDotNet.RepresentationModel;

namespace Glint.Host;

/// <summary>What the loader does with bare YAML nodes: look up, copy, tell empty from full.</summary>
internal static class YamlNodes
{
    internal static YamlNode Child(this YamlMappingNode map, string key) =>
        map.Children.TryGetValue(new YamlScalarNode(key), out YamlNode value) ? value : null;

    internal static void Set(this YamlMappingNode map, string key, YamlNode value) => map.Children[new YamlScalarNode(key)] = value;

    /// <summary>Items of a list; none where the key is absent or no list.</summary>
    internal static IList<YamlNode> Items(this YamlMappingNode map, string key) =>
        map.Child(key) is YamlSequenceNode list ? list.Children : Array.Empty<YamlNode>();

    /// <summary>The list under a key, put there when it is absent.</summary>
    internal static YamlSequenceNode ListAt(this YamlMappingNode map, string key)
    {
        if (map.Child(key) is YamlSequenceNode list)
            return list;
        YamlSequenceNode empty = new();
        map.Set(key, empty);
        return empty;
    }

    internal static bool IsEmpty(this YamlNode node) => node is null or YamlScalarNode { Value: null or "" };

    /// <summary>A copy that shares nothing with the original, its references within the file renamed.</summary>
    internal static YamlNode Clone(this YamlNode node, Func<long, long> rename) => node switch
    {
        YamlMappingNode map => Clone(map, rename),
        YamlSequenceNode list => new YamlSequenceNode(list.Children.Select(item => item.Clone(rename))),
        _ => new YamlScalarNode(((YamlScalarNode)node).Value),
    };

    internal static YamlMappingNode Clone(this YamlMappingNode map, Func<long, long> rename)
    {
        if (ObjectReference.TryRead(map, out ObjectReference reference) && reference.IsLocal && !reference.IsNone)
            return new ObjectReference(rename(reference.FileId)).ToNode();
        YamlMappingNode copy = new();
        foreach ((YamlNode key, YamlNode value) in map.Children)
            copy.Children.Add(key, value.Clone(rename));
        return copy;
    }
}
