using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;
using UnityEngine;

namespace Glint.Host;

/// <summary>
/// Finds the class of a script by the guid of its .cs file. The class has the file's name and is in the assembly of
/// the nearest .asmdef.
/// </summary>
internal sealed partial class ScriptCatalog
{
    readonly ProjectFiles _files;
    readonly AssemblyDefinitions _assemblies;
    readonly Dictionary<string, (Type Type, string Problem)> _byGuid = new();
    readonly Dictionary<Type, string> _guids = new(); // null: in no file
    readonly Dictionary<Type, List<(string, ObjectReference)>> _defaults = new();

    internal ScriptCatalog(ProjectFiles files)
    {
        _files = files;
        _assemblies = new AssemblyDefinitions(files);
    }

    /// <summary>
    /// The class of a script's object, whose name messages then use; null, with a warning, if it cannot be found.
    /// </summary>
    internal Type Find(ObjectRecord record, Type kind, LoadWarnings warnings)
    {
        ObjectReference script = record.Fields.Reference("m_Script");
        (Type type, string problem) = script.IsLocal ? (null, "it has no script") : Find(script.Guid);
        if (type is not null && !kind.IsAssignableFrom(type))
            (type, problem) = (null, $"its script {type.Name} is not a {kind.Name}");
        if (type is null)
            warnings.Add(record,
                $"{problem}: it is left out, and anything it did is missing: restore its script or remove it");
        else
            record.TypeName = type.Name;
        return type;
    }

    /// <summary>Guid of the .cs file with a class.</summary>
    /// <exception cref="UnityException">Unity would find the class in no file.</exception>
    internal string GuidOf(Type type)
    {
        return Look(type)
            ?? throw new UnityException($"the script {type.FullName} is in no file {type.Name}.cs of the project: "
                + "give the class its own file of that name");
    }

    /// <summary>The default references of a class; none where it is in no file of the project.</summary>
    internal IReadOnlyList<(string Field, ObjectReference Reference)> DefaultsOf(Type type)
    {
        if (_defaults.TryGetValue(type, out List<(string, ObjectReference)> defaults))
            return defaults;
        defaults = new List<(string, ObjectReference)>();
        if (Look(type) is string guid)
        {
            string meta = File.ReadAllText(_files.Physical(_files.PathOf(guid)) + MetaFile.Extension);
            foreach (Match match in DefaultReference().Matches(meta))
                defaults.Add((match.Groups[1].Value, new ObjectReference(
                    long.Parse(match.Groups[2].Value, CultureInfo.InvariantCulture), match.Groups[3].Value)));
        }
        _defaults.Add(type, defaults);
        return defaults;
    }

    string Look(Type type)
    {
        if (_guids.TryGetValue(type, out string guid))
            return guid;
        guid = _files.Guids.Paths.Where(path => Path.GetFileName(path) == type.Name + ".cs" && _files.Exists(path))
            .Select(_files.Guids.GuidOf).FirstOrDefault(found => Find(found).Type == type);
        _guids.Add(type, guid);
        return guid;
    }

    (Type Type, string Problem) Find(string guid)
    {
        if (!_byGuid.TryGetValue(guid, out (Type Type, string Problem) found))
            _byGuid.Add(guid, found = Resolve(guid));
        return found;
    }

    (Type Type, string Problem) Resolve(string guid)
    {
        if (_files.PathOf(guid) is not string path)
            return (null, $"its script has guid {guid}, which no .meta in the project has");
        string shown = _files.Shown(path), assemblyName = _assemblies.NameFor(path);
        if (Load(assemblyName) is not Assembly assembly)
            return (null, $"{shown} belongs to {assemblyName}, an assembly that is not built here");
        string name = Path.GetFileNameWithoutExtension(path);
        List<Type> types = ScriptReflection.Types(assembly).Where(type => type.Name == name && IsScript(type)).ToList();
        if (types.Count > 1)
        {
            string source = AssetText.Read(_files.Physical(path), shown);
            types.RemoveAll(type => !source.Contains($"namespace {type.Namespace}", StringComparison.Ordinal));
        }
        if (types.Count == 0)
            return (null,
                $"{shown} has no class {name} that {assemblyName} holds as a MonoBehaviour or ScriptableObject");
        SetOrder(types[0], path);
        return (types[0], null);
    }

    static bool IsScript(Type type) => !type.IsAbstract && !type.ContainsGenericParameters
        && (typeof(MonoBehaviour).IsAssignableFrom(type) || typeof(ScriptableObject).IsAssignableFrom(type));

    static Assembly Load(string name)
    {
        Assembly loaded = AppDomain.CurrentDomain.GetAssemblies()
            .FirstOrDefault(assembly => assembly.GetName().Name == name);
        if (loaded is not null)
            return loaded;
        try
        {
            return Assembly.Load(new AssemblyName(name));
        }
        catch (Exception error) when (error is IOException or BadImageFormatException or ArgumentException)
        {
            return null;
        }
    }

    // The order in the project's settings overrides the attribute.
    void SetOrder(Type type, string path)
    {
        string meta = _files.Physical(path) + MetaFile.Extension;
        Match match = ExecutionOrder().Match(File.ReadAllText(meta));
        if (match.Success && int.TryParse(match.Groups[1].Value, out int order) && order != 0)
            Messages.Of(type).Order = order;
    }

    [GeneratedRegex(@"^  - (\w+): \{fileID: (-?\d+), guid: (\w+), type: \d\}", RegexOptions.Multiline)]
    private static partial Regex DefaultReference();

    [GeneratedRegex(@"^[ \t]*executionOrder:[ \t]*(-?\d+)[ \t\r]*$", RegexOptions.Multiline)]
    private static partial Regex ExecutionOrder();
}
