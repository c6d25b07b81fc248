using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Runtime.CompilerServices;
using System.Text.Json;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>What Unity asks of a package's manifest, and a compiler with every module at hand does not see.</summary>
public sealed class PackageTests
{
    static readonly string s_root = Project.FindRoot(ThisFolder());

    // A project has only the modules of the engine that its packages name.
    [TestCase("Packages/com.glint.radar", "imageconversion", @"\.EncodeToPNG\(")]
    [TestCase("Packages/com.glint.radar", "uielements", @"using UnityEngine\.UIElements;")]
    [TestCase("Packages/com.glint.radar", "imgui", @"\bGUIContent\b")]
    [TestCase("Packages/com.glint.radar", "physics", @"\.CreatePrimitive\(")]
    [TestCase("Tests", "physics", @"\.CreatePrimitive\(")]
    public void Manifest_OfAPackageThatUsesAModule_NamesIt(string package, string module, string use)
    {
        string folder = Path.Combine(s_root, package);
        Assert.That(Directory.EnumerateFiles(folder, "*.cs", SearchOption.AllDirectories)
            .Any(file => Regex.IsMatch(File.ReadAllText(file), use)), "the package uses it");
        using var manifest = JsonDocument.Parse(File.ReadAllText(Path.Combine(folder, "package.json")));
        Assert.That(
            manifest.RootElement.GetProperty("dependencies").EnumerateObject().Select(dependency => dependency.Name),
            Has.Member("com.unity.modules." + module));
    }

    // Unity compiles every kernel of a package when it imports it, the tracer's in up to ten seconds each.
    [Test]
    public void Shaders_OfThePackage_HaveAtMostTenKernelsThatUnityCompiles()
    {
        string shaders = Path.Combine(s_root, "Packages/com.glint.radar/Shaders");
        var kernels = Directory.EnumerateFiles(shaders, "*.compute", SearchOption.AllDirectories)
            .Where(file => !Path.GetRelativePath(shaders, file).Contains("~/"))
            .SelectMany(File.ReadLines).Count(line => Regex.IsMatch(line, @"^\s*#pragma\s+kernel\s"));
        Assert.That(kernels, Is.InRange(1, 10));
    }

    // Unity reads the line in the .compute file only, not in what it includes.
    [Test]
    public void Shaders_WithPreciseSteps_DisableMetalsFastMath()
    {
        var files = new[] { "Packages", "Tests" }
            .SelectMany(folder => Directory.EnumerateFiles(Path.Combine(s_root, folder), "*.compute",
                SearchOption.AllDirectories))
            .Where(file => !file.Contains("~/") && HasPreciseSteps(file, new HashSet<string>())).ToArray();
        Assert.That(files, Is.Not.Empty);
        Assert.That(files.Where(file => !File.ReadLines(file).Contains("#pragma disable_fastmath")), Is.Empty);
    }

    // FXC takes !(a <= b) for b < a: what is written for NaN is lost without a warning.
    [Test]
    public void Shaders_OfThePackage_NegateNoComparison()
    {
        var lines = Directory.EnumerateFiles(Path.Combine(s_root, "Packages/com.glint.radar/Shaders"), "*",
                SearchOption.AllDirectories)
            .Where(file => Path.GetExtension(file) is ".hlsl" or ".compute").SelectMany(File.ReadLines)
            .Where(line => !line.TrimStart().StartsWith("//")).ToArray();
        Assert.That(lines, Is.Not.Empty);
        Assert.That(lines.Where(line => Regex.IsMatch(line, @"!\(.*[<>]")), Is.Empty);
    }

    static bool HasPreciseSteps(string file, HashSet<string> read)
    {
        string text = File.ReadAllText(file);
        return Regex.IsMatch(text, @"^\s*precise\s", RegexOptions.Multiline)
            || Regex.Matches(text, @"^\s*#include ""(.+)""", RegexOptions.Multiline)
                .Select(match => match.Groups[1].Value)
                .Select(path => Path.Combine(path.StartsWith("Packages/") ? s_root : Path.GetDirectoryName(file), path))
                .Any(path => read.Add(path) && HasPreciseSteps(path, read));
    }

    [Test]
    public void SoftwareDevice_InTheHost_IsGivenTheWideKernels() =>
        Assert.That(SoftwareDevice.UsesWideKernels, Is.EqualTo(SoftwareDevice.IsInUse));

    // Of modules that no package names: a script that needs one of them is an error in the editor.
    [TestCase(
        @"\b(JsonUtility|AudioSource|AudioListener|ParticleSystem|Animator|Animation|Rigidbody|Collider|Terrain|UnityWebRequest|ScreenCapture|VideoPlayer|Cloth|Tilemap|WheelCollider)\b")]
    public void Scripts_UseNoModuleThatNoPackageNames(string uses)
    {
        var scripts = new[] { "Packages", "Tests", "Assets" }.SelectMany(
            folder => Directory.EnumerateFiles(Path.Combine(s_root, folder), "*.cs", SearchOption.AllDirectories));
        Assert.That(scripts.Where(file => File.ReadLines(file)
            .Any(line => !line.TrimStart().StartsWith("//") && Regex.IsMatch(line, uses))), Is.Empty);
    }

    static string ThisFolder([CallerFilePath] string path = "") => Path.GetDirectoryName(path);
}
