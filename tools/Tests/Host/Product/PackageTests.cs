using System.IO;
using System.Linq;
using System.Runtime.CompilerServices;
using System.Text.Json;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>Unity's requirements for a package manifest that a compiler with all modules does not check.</summary>
public sealed class PackageTests
{
    static readonly string s_root = Project.FindRoot(ThisFolder());

    // A project has only the engine modules that its packages list.
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

    // Unity compiles every kernel of a package on import; each of the tracer's takes up to ten seconds.
    [Test]
    public void Shaders_OfThePackage_HaveAtMostTenKernelsThatUnityCompiles()
    {
        string shaders = Path.Combine(s_root, "Packages/com.glint.radar/Shaders");
        var kernels = Directory.EnumerateFiles(shaders, "*.compute", SearchOption.AllDirectories)
            .Where(file => !Path.GetRelativePath(shaders, file).Contains("~/"))
            .SelectMany(File.ReadLines).Count(line => Regex.IsMatch(line, @"^\s*#pragma\s+kernel\s"));
        Assert.That(kernels, Is.InRange(1, 10));
    }

    [Test]
    public void SoftwareDevice_InTheHost_IsGivenTheWideKernels() =>
        Assert.That(SoftwareDevice.UsesWideKernels, Is.EqualTo(SoftwareDevice.IsInUse));

    // Types of modules that no package lists; a script that uses one does not compile in the editor.
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
