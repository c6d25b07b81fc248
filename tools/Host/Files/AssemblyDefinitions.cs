using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using Glint.Core;

namespace Glint.Host;

/// <summary>Finds a script's assembly: that of the nearest .asmdef above it.</summary>
internal sealed class AssemblyDefinitions
{
    // Unity's name for the assembly of scripts under Assets without an .asmdef.
    const string Default = "Assembly-CSharp";

    readonly ProjectFiles _files;
    readonly Dictionary<string, string> _byFolder = new();

    internal AssemblyDefinitions(ProjectFiles files) => _files = files;

    internal string NameFor(string scriptPath) => InFolder(Parent(scriptPath));

    string InFolder(string folder)
    {
        if (folder is null)
            return Default;
        if (!_byFolder.TryGetValue(folder, out string name))
            _byFolder.Add(folder, name = Defined(folder) ?? InFolder(Parent(folder)));
        return name;
    }

    string Defined(string folder)
    {
        string file = Directory.EnumerateFiles(_files.Physical(folder), "*.asmdef")
            .Order(StringComparer.Ordinal).FirstOrDefault();
        if (file is null)
            return null;
        string shown = _files.Shown(folder + "/" + Path.GetFileName(file));
        try
        {
            using JsonDocument json = JsonDocument.Parse(AssetText.Read(file, shown));
            return json.RootElement.ValueKind == JsonValueKind.Object
                && json.RootElement.TryGetProperty("name", out JsonElement name)
                && name.ValueKind == JsonValueKind.String && name.GetString() is { Length: > 0 } text
                    ? text
                    : throw new GlintException($"{shown}: has no \"name\": add one");
        }
        catch (JsonException error)
        {
            throw new GlintException($"{shown}:{error.LineNumber + 1}: malformed JSON: correct the line", error);
        }
    }

    // Null above Assets and above a package's root.
    static string Parent(string path)
    {
        int slash = path.LastIndexOf('/');
        string parent = slash < 0 ? null : path[..slash];
        return parent == "Packages" ? null : parent;
    }
}
