using System.IO;
using System.Linq;
using System.Runtime.CompilerServices;
using System.Text.Json;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>Unity's requirements for the files of a project and its packages.</summary>
public sealed class PackageTests
{
    static readonly string s_root = Project.FindRoot(ThisFolder());

    static readonly string[] s_manifests =
    [
        "Packages/manifest.json", "Packages/com.glint.radar/package.json", "Tests/package.json", "Scenes/package.json",
        "Meshes/package.json"
    ];

    // Core packages come with the editor: Unity replaces any other version and rewrites the manifest. These are the
    // versions of 6000.0.78f1: what Unity stores as "builtin" in Packages/packages-lock.json.
    static readonly (string package, string version)[] s_core =
        [(@"com\.unity\.modules\..*", "1.0.0"), (@"com\.unity\.test-framework", "1.6.0")];

    static readonly string[] s_registry = ["com.unity.mathematics", "com.unity.nuget.newtonsoft-json"];

    [TestCaseSource(nameof(s_manifests))]
    public void Dependencies_OnCorePackages_HaveTheVersionOfTheEditor(string manifest)
    {
        if (!Json(manifest).TryGetProperty("dependencies", out var dependencies))
            return;
        foreach (var dependency in dependencies.EnumerateObject().Where(it => it.Name.StartsWith("com.unity.")
            && !s_registry.Contains(it.Name)))
        {
            string version = s_core.FirstOrDefault(core => Regex.IsMatch(dependency.Name, $"^{core.package}$")).version;
            Assert.That(version, Is.Not.Null, $"{dependency.Name}: neither a known core package nor of the registry");
            Assert.That(dependency.Value.GetString(), Is.EqualTo(version), dependency.Name);
        }
    }

    // Without the revision Unity Hub cannot offer to install the editor.
    [Test]
    public void ProjectVersion_NamesTheEditorAndItsRevision() =>
        Assert.That(File.ReadAllText(Path.Combine(s_root, "ProjectSettings/ProjectVersion.txt")), Does.Match(
            @"\Am_EditorVersion: (6000\.0\.\d+f\d+)\nm_EditorVersionWithRevision: \1 \([0-9a-f]{12}\)\n\z"));

    // A release would shut out every earlier 6000.0.
    [Test]
    public void Package_Radar_IsForEveryRelease()
    {
        Assert.That(Json(s_manifests[1]).GetProperty("unity").GetString(), Is.EqualTo("6000.0"));
        Assert.That(Json(s_manifests[1]).TryGetProperty("unityRelease", out _), Is.False);
    }

    // Where a link is missing the Package Manager opens the file of the package.
    [TestCase("documentationUrl", "Documentation~/index.md")]
    [TestCase("changelogUrl", "CHANGELOG.md")]
    [TestCase("licensesUrl", "LICENSE.md")]
    public void Package_Link_IsAWebAddressOrAFileOfThePackage(string key, string file)
    {
        if (Json(s_manifests[1]).TryGetProperty(key, out var link))
            Assert.That(link.GetString(), Does.StartWith("https://"));
        else
            Assert.That(File.ReadAllText(Path.Combine(s_root, "Packages/com.glint.radar", file)), Is.Not.Empty);
    }

    // Unity shows only files with .meta; folders that end in ~ are not imported.
    [TestCase("CHANGELOG.md")]
    [TestCase("LICENSE.md")]
    public void Package_File_IsImported(string file) =>
        Assert.That(File.Exists(Path.Combine(s_root, "Packages/com.glint.radar", file + ".meta")));

    // Unity writes 20 where these say 2e+01: the first save would change lines that nothing has changed.
    [Test]
    public void YamlFiles_HaveNoNumbersWithAPositiveExponent()
    {
        var files = new[] { "Packages", "Scenes", "Meshes", "Tests", "Assets", "ProjectSettings" }.SelectMany(folder =>
            Directory.EnumerateFiles(Path.Combine(s_root, folder), "*", SearchOption.AllDirectories))
            .Where(file => Regex.IsMatch(file, @"\.(unity|prefab|asset|meta|mat)$")).ToArray();
        Assert.That(files, Has.Length.GreaterThan(500));
        Assert.That(files.Where(file => File.ReadLines(file).Any(line => Regex.IsMatch(line, @"\d[eE]\+\d"))), Is.Empty);
    }

    [Test]
    public void SoftwareDevice_InTheHost_IsGivenTheWideKernels() =>
        Assert.That(SoftwareDevice.UsesWideKernels, Is.EqualTo(SoftwareDevice.IsInUse));

    // Types of modules that no package lists; a script that uses one, but by its name, does not compile in the editor.
    [TestCase(
        @"\b(JsonUtility|AudioSource|AudioListener|ParticleSystem|Animator|Animation|Collider|Terrain|UnityWebRequest|ScreenCapture|VideoPlayer|Cloth|Tilemap|WheelCollider)\b")]
    public void Scripts_UseNoModuleThatNoPackageNames(string uses)
    {
        var scripts = new[] { "Packages", "Tests", "Assets" }.SelectMany(
            folder => Directory.EnumerateFiles(Path.Combine(s_root, folder), "*.cs", SearchOption.AllDirectories));
        bool Uses(string line) =>
            !line.TrimStart().StartsWith("//") && Regex.IsMatch(Regex.Replace(line, "\"[^\"]*\"", ""), uses);
        Assert.That(scripts.Where(file => File.ReadLines(file).Any(Uses)), Is.Empty);
    }

    static JsonElement Json(string path)
    {
        using var document = JsonDocument.Parse(File.ReadAllText(Path.Combine(s_root, path)));
        return document.RootElement.Clone();
    }

    static string ThisFolder([CallerFilePath] string path = "") => Path.GetDirectoryName(path);
}
