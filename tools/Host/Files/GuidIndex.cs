using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading.Tasks;
using Glint.Core;

namespace Glint.Host;

/// <summary>
/// Maps guids to files. All .meta files under Assets and the packages are read when the first guid is requested. Files
/// and folders that Unity does not import are left out.
/// </summary>
internal sealed class GuidIndex
{
    static readonly EnumerationOptions _all =
        new() { IgnoreInaccessible = true, AttributesToSkip = FileAttributes.None };

    readonly ProjectPaths _paths;
    Lazy<Dictionary<string, List<string>>> _pathsByGuid;

    internal GuidIndex(ProjectPaths paths)
    {
        _paths = paths;
        Forget();
    }

    /// <summary>Asset paths of all files and folders with a .meta.</summary>
    internal IEnumerable<string> Paths => _pathsByGuid.Value.Values.SelectMany(paths => paths);

    /// <summary>Asset path of the file with this guid; null if no .meta has it.</summary>
    /// <exception cref="GlintException">Two files have the guid.</exception>
    internal string PathOf(string guid)
    {
        if (!_pathsByGuid.Value.TryGetValue(guid, out List<string> found))
            return null;
        if (found.Count > 1)
            throw new GlintException($"{found[0]} and {found[1]} have the same guid {guid}: "
                + "delete the .meta of the copy, and Unity gives it a new one");
        return found[0];
    }

    /// <summary>Guid of an asset; null without a .meta.</summary>
    internal string GuidOf(string assetPath) =>
        MetaFile.ReadGuid(_paths.ToPhysicalPath(assetPath) + MetaFile.Extension);

    internal bool IsTaken(string guid) => _pathsByGuid.Value.ContainsKey(guid);

    /// <summary>A new, unused guid.</summary>
    internal void Add(string guid, string assetPath) => _pathsByGuid.Value[guid] = [assetPath];

    /// <summary>Discards the index; the next request reads the files again.</summary>
    internal void Forget() => _pathsByGuid = new Lazy<Dictionary<string, List<string>>>(Scan);

    Dictionary<string, List<string>> Scan()
    {
        List<(string Meta, string AssetPath)> files = new();
        HashSet<string> linked = new();
        Scan(_paths.ToPhysicalPath("Assets"), "Assets", files, linked);
        foreach ((string name, string folder) in _paths.Packages)
            Scan(folder, "Packages/" + name, files, linked);
        string[] guids = new string[files.Count];
        Parallel.For(0, guids.Length, i => guids[i] = MetaFile.ReadGuid(files[i].Meta));
        Dictionary<string, List<string>> result = new();
        for (int i = 0; i < guids.Length; i++)
            if (guids[i] is string guid)
            {
                if (!result.TryGetValue(guid, out List<string> found))
                    result.Add(guid, found = new List<string>(1));
                found.Add(files[i].AssetPath);
            }
        return result;
    }

    static void Scan(string folder, string assetPath, List<(string, string)> files, HashSet<string> linked)
    {
        DirectoryInfo directory = new(folder);
        if (!directory.Exists)
            return;
        foreach (FileSystemInfo entry in directory.EnumerateFileSystemInfos("*", _all))
        {
            if (IsIgnored(entry.Name))
                continue;
            if (entry is DirectoryInfo child)
            {
                // A link may lead back to a folder above it.
                if (child.LinkTarget is null || linked.Add(child.ResolveLinkTarget(true).FullName))
                    Scan(child.FullName, assetPath + "/" + child.Name, files, linked);
            }
            else if (entry.Name.EndsWith(MetaFile.Extension, StringComparison.Ordinal))
                files.Add((entry.FullName, assetPath + "/" + entry.Name[..^MetaFile.Extension.Length]));
        }
    }

    static bool IsIgnored(string name) =>
        name[0] == '.' || name[^1] == '~' || name.Equals("cvs", StringComparison.OrdinalIgnoreCase)
        || name.EndsWith(".tmp", StringComparison.OrdinalIgnoreCase);
}
