using System;
using System.Security.Cryptography;
using System.Text;

namespace Glint.Host;

/// <summary>The .meta of a written asset: a guid and the importer with its defaults.</summary>
internal static class MetaText
{
    internal static string OfFolder(string guid) => Text(guid, "folderAsset: yes\nDefaultImporter", "");

    internal static string OfPrefab(string guid) => Text(guid, "PrefabImporter", "");

    internal static string OfObject(string guid, long mainFileId) =>
        Text(guid, "NativeFormatImporter", $"  mainObjectFileID: {mainFileId}\n");

    /// <summary>
    /// A guid for a new asset, derived from its path; Unity takes a random one. Assets that are generated again get
    /// the same guids, so that references to them remain valid.
    /// </summary>
    /// <param name="isTaken">
    /// True for a guid in use: a moved file keeps its guid, so a new file at its old path needs another.
    /// </param>
    internal static string NewGuid(string assetPath, Func<string, bool> isTaken)
    {
        string guid;
        int attempt = 0;
        do
            guid = Convert.ToHexStringLower(SHA256.HashData(
                Encoding.UTF8.GetBytes(attempt == 0 ? assetPath : $"{assetPath}\n{attempt}")).AsSpan(0, 16));
        while (isTaken(guid) && ++attempt > 0);
        return guid;
    }

    static string Text(string guid, string importer, string ownKeys) =>
        $"fileFormatVersion: 2\nguid: {guid}\n{importer}:\n  externalObjects: {{}}\n{ownKeys}  userData: \n"
        + "  assetBundleName: \n  assetBundleVariant: \n";
}
