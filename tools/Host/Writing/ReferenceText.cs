using System.Collections.Generic;
using System.IO;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Host;

/// <summary>Writes the references of one file: its own objects by id, assets by guid and id.</summary>
internal sealed class ReferenceText
{
    internal const string None = "{fileID: 0}";

    // Unity's code for the source of an asset's objects: built in, the file itself, an importer.
    const int BuiltIn = 0, Native = 2, Imported = 3;

    readonly GuidIndex _guids;
    readonly IReadOnlyDictionary<Object, long> _ownIds;

    internal ReferenceText(GuidIndex guids, IReadOnlyDictionary<Object, long> ownIds)
    {
        _guids = guids;
        _ownIds = ownIds;
    }

    /// <param name="path">Property path of the reference in the holder.</param>
    /// <exception cref="UnityException">The object is neither in the file nor an asset.</exception>
    internal string Of(Object target, Object holder, string path)
    {
        if (Object.IsNull(target))
            return None;
        if (_ownIds.TryGetValue(target, out long id))
            return $"{{fileID: {id}}}";
        if (BuiltInAssets.GuidOf(target.AssetPath) is string builtIn)
            return Text(target.FileId, builtIn, BuiltIn);
        if (target.AssetPath is not null && target.FileId != 0 && _guids.GuidOf(target.AssetPath) is string guid)
            return Text(target.FileId, guid, IsNative(target.AssetPath) ? Native : Imported);
        throw new UnityException($"{holder.GetType().Name} of '{holder.name}': {path} refers to the "
            + $"{target.GetType().Name} '{target.name}', which is neither an asset nor below the same root: "
            + "make it an asset first (AssetDatabase.CreateAsset), or clear the field");
    }

    internal static string Script(string guid) => Text(11500000, guid, Imported);

    static string Text(long fileId, string guid, int type) => $"{{fileID: {fileId}, guid: {guid}, type: {type}}}";

    static bool IsNative(string path) => Path.GetExtension(path).ToLowerInvariant() is ".asset" or ".mat" or ".mesh";
}
