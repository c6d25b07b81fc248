using System;
using System.Collections.Generic;
using System.IO;

namespace Glint.Host;

/// <summary>Versions and names in the open project's settings.</summary>
internal static class ProjectVersion
{
    const string DefaultUnity = "6000.0.78f1";

    static readonly Dictionary<string, string[]> _files = new();

    internal static string Root => Engine.Assets?.ProjectRoot ?? Environment.CurrentDirectory;

    internal static string Unity => Setting("ProjectVersion.txt", "m_EditorVersion") ?? DefaultUnity;

    internal static string Product => Setting("ProjectSettings.asset", "productName") ?? "Glint";

    internal static string Company => Setting("ProjectSettings.asset", "companyName") ?? "DefaultCompany";

    internal static string Version => Setting("ProjectSettings.asset", "bundleVersion") ?? "0.1";

    static string Setting(string file, string key)
    {
        foreach (string line in Lines(Path.Combine(Root, "ProjectSettings", file)))
        {
            string text = line.Trim();
            if (text.StartsWith(key + ":", StringComparison.Ordinal))
                return text[(key.Length + 1)..].Trim();
        }
        return null;
    }

    static string[] Lines(string path)
    {
        if (!_files.TryGetValue(path, out string[] lines))
            _files.Add(path, lines = File.Exists(path) ? File.ReadAllLines(path) : Array.Empty<string>());
        return lines;
    }
}
