using System;
using System.IO;
using Glint.Host;

namespace UnityEditor;

public class FileUtil
{
    /// <summary>The path on disk of an asset path; other paths are unchanged.</summary>
    public static string GetPhysicalPath(string path)
    {
        if (Engine.Assets is null || string.IsNullOrEmpty(path))
            return path;
        return Engine.Assets.ToPhysicalPath(path) ?? path;
    }

    /// <summary>The path relative to the project's root; a path outside is unchanged.</summary>
    public static string GetProjectRelativePath(string path)
    {
        string root = ProjectVersion.Root.Replace('\\', '/').TrimEnd('/') + "/";
        string normal = path.Replace('\\', '/');
        return normal.StartsWith(root, StringComparison.Ordinal) ? normal[root.Length..] : "";
    }

    public static bool DeleteFileOrDirectory(string path)
    {
        if (File.Exists(path))
            File.Delete(path);
        else if (Directory.Exists(path))
            Directory.Delete(path, true);
        else
            return false;
        return true;
    }
}
