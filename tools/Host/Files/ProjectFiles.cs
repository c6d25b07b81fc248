using System;
using System.IO;
using Glint.Core;

namespace Glint.Host;

/// <summary>The files of one project, by asset path and guid, with their names for messages.</summary>
internal sealed class ProjectFiles
{
    internal ProjectFiles(string root)
    {
        Paths = new ProjectPaths(root);
        Guids = new GuidIndex(Paths);
    }

    internal ProjectPaths Paths { get; }

    internal GuidIndex Guids { get; }

    internal string Physical(string assetPath) => Paths.ToPhysicalPath(assetPath);

    internal bool Exists(string assetPath) => File.Exists(Physical(assetPath));

    /// <summary>Path relative to the project's folder, for messages.</summary>
    internal string Shown(string assetPath)
    {
        string physical = Physical(assetPath), prefix = Paths.Root + "/";
        return physical.StartsWith(prefix, StringComparison.Ordinal) ? physical[prefix.Length..] : physical;
    }

    internal UnityFile ReadObjects(string assetPath)
    {
        string shown = Shown(assetPath);
        return UnityFile.Parse(AssetText.ReadYaml(Physical(assetPath), shown), shown);
    }

    /// <summary>Asset path of the file with a guid; null if no .meta has it.</summary>
    /// <exception cref="GlintException">The .meta exists and its file is missing.</exception>
    internal string PathOf(string guid)
    {
        string path = Guids.PathOf(guid);
        if (path is not null && !Exists(path))
            throw new GlintException($"{Shown(path)}: only its .meta is there, with guid {guid}: restore the file");
        return path;
    }
}
