using System;
using System.Security.Cryptography;
using System.Text;

namespace Glint.Host;

/// <summary>The .meta of what is written: a guid and the importer with its defaults.</summary>
internal static class MetaText
{
    internal static string OfFolder(string guid) => Text(guid, "folderAsset: yes\nDefaultImporter", "");

    internal static string OfPrefab(string guid) => Text(guid, "PrefabImporter", "");

    internal static string OfObject(string guid, long mainFileId) =>
        Text(guid, "NativeFormatImporter", $"  mainObjectFileID: {mainFileId}\n");

    /// <summary>
    /// A guid for a new asset, made of its path, where Unity takes a random one:
    /// whoever makes the same assets again from a clean tree gets the same files, and what refers to them stays right.
    /// </summary>
    /// <param name="isTaken">A file that was moved keeps its guid, so that one at its old place needs another.</param>
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
