using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Reflection.Metadata;
using System.Reflection.PortableExecutable;
using System.Runtime.CompilerServices;
using System.Text.Json;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>The packages' assemblies, as built for the host, against what Unity asks of them.</summary>
public sealed class AssemblyTests
{
    static readonly string s_root = Project.FindRoot(AppContext.BaseDirectory),
        s_bin = Path.Combine(s_root, "tools/artifacts/bin");

    static readonly string[] s_product =
            ["Glint.Core", "Glint", "Glint.Reference", "Glint.Editor"],
        s_tests = ["Glint.Tests.EditMode", "Glint.Tests.PlayMode"];

    // Assemblies of packages.
    static readonly Dictionary<string, string> s_packages = new()
    {
        ["Unity.Mathematics"] = "com.unity.mathematics",
        ["Newtonsoft.Json"] = "com.unity.nuget.newtonsoft-json",
        ["UnityEngine.TestRunner"] = "com.unity.test-framework",
    };

    // A project has only the modules and packages that its packages name.
    [Test]
    public void Package_OfTheProduct_NamesWhatItsAssembliesUse() =>
        Assert.That(Needed(s_product), Is.EquivalentTo(Named("Packages/com.glint.radar")));

    [Test]
    public void Package_OfTheTests_NamesWhatItsAssembliesUse() =>
        Assert.That(Needed(s_tests), Is.EquivalentTo(Named("Tests")));

    // With domain reload off a static field keeps its value from one play mode, or one test run, to the next.
    [Test]
    public void StaticFields_AreReadOnly() =>
        Assert.That(s_product.Concat(s_tests).SelectMany(MutableStatics), Is.Empty);

    static HashSet<string> Named(string folder)
    {
        using var manifest = JsonDocument.Parse(File.ReadAllText(Path.Combine(s_root, folder, "package.json")));
        return manifest.RootElement.GetProperty("dependencies").EnumerateObject()
            .Select(dependency => dependency.Name).Where(name => name.StartsWith("com.unity.")).ToHashSet();
    }

    static HashSet<string> Needed(IEnumerable<string> assemblies)
    {
        var modules = File.ReadLines(Path.Combine(Path.GetDirectoryName(ThisFile()), "UnityModules.txt"))
            .Where(line => !line.StartsWith('#')).Select(line => line.Split(' ')).ToDictionary(row => row[1], row => row[0]);
        var needed = new HashSet<string>();
        foreach (string assembly in assemblies)
            Read(assembly, reader =>
            {
                var uses = EngineTypes(reader).ToArray();
                Assert.That(uses.Where(use => !modules.ContainsKey(use)), Is.Empty,
                    $"{assembly} uses types without a module: look them up and add them to UnityModules.txt");
                foreach (string use in uses.Concat(Members(reader).Where(modules.ContainsKey)))
                    if (modules[use] != "core")
                        needed.Add("com.unity.modules." + modules[use]);
                foreach (var handle in reader.AssemblyReferences)
                    if (s_packages.TryGetValue(reader.GetString(reader.GetAssemblyReference(handle).Name), out string package))
                        needed.Add(package);
            });
        return needed;
    }

    // Without UnityEngine, generic arity and nested types. All of UI Toolkit is one module.
    static IEnumerable<string> EngineTypes(MetadataReader reader) => reader.TypeReferences
        .Select(reader.GetTypeReference)
        .Where(type => type.ResolutionScope.Kind != HandleKind.TypeReference)
        .Select(type => (space: reader.GetString(type.Namespace), name: reader.GetString(type.Name).Split('`')[0]))
        .Where(type => type.space.StartsWith("UnityEngine") && type.space != "UnityEngine.TestTools")
        .Select(type => type.space == "UnityEngine.UIElements" ? "UIElements.*" : type.name).Distinct();

    static IEnumerable<string> Members(MetadataReader reader) => reader.MemberReferences
        .Select(reader.GetMemberReference)
        .Where(member => member.Parent.Kind == HandleKind.TypeReference)
        .Select(member => reader.GetString(reader.GetTypeReference((TypeReferenceHandle)member.Parent).Name) + "."
            + reader.GetString(member.Name)).Distinct();

    // What the compiler makes has names that C# has not.
    static IEnumerable<string> MutableStatics(string assembly)
    {
        var found = new List<string>();
        Read(assembly, reader => found.AddRange(reader.FieldDefinitions.Select(reader.GetFieldDefinition)
            .Where(field => field.Attributes.HasFlag(FieldAttributes.Static)
                && (field.Attributes & (FieldAttributes.InitOnly | FieldAttributes.Literal)) == 0)
            .Select(field => reader.GetString(reader.GetTypeDefinition(field.GetDeclaringType()).Name) + "."
                + reader.GetString(field.Name))
            .Where(name => !name.Contains('<'))));
        return found;
    }

    static void Read(string assembly, Action<MetadataReader> look)
    {
        using var file = File.OpenRead(Path.Combine(s_bin, assembly, "release", assembly + ".dll"));
        using var image = new PEReader(file);
        look(image.GetMetadataReader());
    }

    static string ThisFile([CallerFilePath] string path = "") => path;
}
