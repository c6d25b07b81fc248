using System.Globalization;
using YamlDotNet.RepresentationModel;

namespace Glint.Host;

/// <summary>
/// <c>{fileID: N}</c>, an object of the same file, or <c>{fileID: N, guid: G, type: T}</c>, an object of the file
/// whose .meta has the guid.
/// </summary>
internal readonly record struct ObjectReference(long FileId, string Guid = null)
{
    internal bool IsNone => FileId == 0;

    internal bool IsLocal => Guid is null;

    public override string ToString() => IsLocal ? $"fileID {FileId}" : $"fileID {FileId} of guid {Guid}";

    internal static bool TryRead(YamlNode node, out ObjectReference reference)
    {
        reference = default;
        if (node is not YamlMappingNode map)
            return false;
        if (map.Child("fileID") is not YamlScalarNode id
            || !long.TryParse(id.Value, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out long fileId))
            return map.Child("instanceID") is YamlScalarNode && map.Children.Count == 1;
        reference = new ObjectReference(fileId, (map.Child("guid") as YamlScalarNode)?.Value?.ToLowerInvariant());
        return true;
    }

    internal YamlMappingNode ToNode()
    {
        YamlMappingNode node = new();
        node.Set("fileID", new YamlScalarNode(FileId.ToString(CultureInfo.InvariantCulture)));
        if (!IsLocal)
            node.Set("guid", new YamlScalarNode(Guid));
        return node;
    }
}
