using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using YamlDotNet.RepresentationModel;

namespace Glint.Host;

/// <summary>
/// An array written as one hexadecimal text, with pending overrides of its size and elements, in order. They are
/// applied when the array is read into its field, which gives the width of an element.
/// </summary>
internal static class PackedOverrides
{
    // Keys that no C# field can have.
    const string HexKey = "<hex>", EditsKey = "<edits>", SizeKey = "size";

    internal static YamlMappingNode Begin(string hex)
    {
        YamlMappingNode packed = new();
        packed.Set(HexKey, new YamlScalarNode(hex));
        packed.Set(EditsKey, new YamlSequenceNode());
        return packed;
    }

    internal static bool IsOne(YamlNode node) => node is YamlMappingNode map && map.Child(HexKey) is not null;

    /// <summary>Null if the file itself has this key with other content.</summary>
    internal static string Hex(YamlMappingNode packed) => (packed.Child(HexKey) as YamlScalarNode)?.Value;

    internal static void AddSize(YamlMappingNode packed, int size) =>
        Add(packed, SizeKey, size.ToString(CultureInfo.InvariantCulture));

    internal static void AddElement(YamlMappingNode packed, int index, string value) =>
        Add(packed, index.ToString(CultureInfo.InvariantCulture), value);

    /// <summary>Index and value of each override; index -1 is the array's size.</summary>
    internal static IEnumerable<(int Index, string Value)> Edits(YamlMappingNode packed) =>
        from edit in packed.Items(EditsKey).OfType<YamlSequenceNode>()
        where edit.Children.Count == 2 && edit.Children.All(part => part is YamlScalarNode)
        let key = ((YamlScalarNode)edit.Children[0]).Value
        select (int.TryParse(key, NumberStyles.None, CultureInfo.InvariantCulture, out int index) ? index : -1,
            ((YamlScalarNode)edit.Children[1]).Value);

    static void Add(YamlMappingNode packed, string key, string value) =>
        packed.ListAt(EditsKey).Add(new YamlSequenceNode(new YamlScalarNode(key), new YamlScalarNode(value)));
}
