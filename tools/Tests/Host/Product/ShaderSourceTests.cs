using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Glint.Vulkan;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>What Unity reads of the shaders' sources, and what no compiler here checks.</summary>
public sealed partial class ShaderSourceTests
{
    static readonly string s_root = Project.FindRoot(TestContext.CurrentContext.TestDirectory);

    static IEnumerable<string> Compute => Files("*.compute");

    static IEnumerable<string> Includes => Files("*.hlsl");

    static IEnumerable<string> Sources => Compute.Concat(Includes);

    /// <summary>
    /// Unity compiles every kernel of a package on import; the tracers take seconds to a minute each, the small ones
    /// between them a tenth of a second.
    /// </summary>
    [TestCase("Trace.compute", 9, 15)]
    [TestCase("Tubes.compute", 18, 29)]
    [TestCase("Amplitude.compute", 6, 12)]
    public void Shader_HasFewLargeKernelsThatUnityCompiles(string file, int large, int all)
    {
        var kernels = Kernel().Matches(Text($"Packages/com.glint.radar/Shaders/{file}")).Select(match => match.Value)
            .ToArray();
        Assert.That(kernels.Count(line => !line.Contains("GLINT_STAGE") && !line.Contains("GLINT_ARITHMETIC")), Is.InRange(1, large));
        Assert.That(kernels.Length, Is.LessThanOrEqualTo(all));
    }

    /// <summary>FXC takes !(a &lt;= b) for b &lt; a, also for NaN, without a warning.</summary>
    // FXC takes more, a device of Direct3D 11 does not.
    [TestCase("Trace.compute")]
    [TestCase("Tubes.compute")]
    [TestCase("Amplitude.compute")]
    [TestCase("Screen.compute")]
    [TestCase("SeaField.compute")]
    [TestCase("Backprojection.compute")]
    public void Kernels_WriteEightBuffersAtMost(string file)
    {
        string path = "Packages/com.glint.radar/Shaders/" + file;
        foreach (string kernel in ShaderLibrary.Kernels(path))
        {
            var reflection = new Reflection(SpirvModule.WithImageFormat(ShaderLibrary.Load(path, kernel)));
            Assert.That(reflection.Buffers.Count(buffer => buffer.Writable), Is.InRange(1, 8), kernel);
        }
    }

    [TestCaseSource(nameof(Sources))]
    public void Source_NegatesNoComparison(string path) =>
        Assert.That(Text(path), Does.Not.Match(@"(?m)^(?!\s*//).*!\(.*[<>]"));

    /// <summary>Metal ignores "precise" without it. Unity reads it in a .compute file only.</summary>
    [TestCaseSource(nameof(Compute))]
    public void Compute_ThatNeedsPreciseArithmetic_DisablesFastMath(string path)
    {
        bool isPrecise = WithIncludes(path, new HashSet<string>()).Any(part => Precise().IsMatch(Text(part)));
        bool wantsFastMath = path.EndsWith("/FastMath.compute");
        Assert.That(FastMath().IsMatch(Text(path)), Is.EqualTo(isPrecise && !wantsFastMath));
    }

    /// <summary>Unity ignores its own pragmas in an included file.</summary>
    [TestCaseSource(nameof(Includes))]
    public void Include_HasNoPragma(string path) => Assert.That(Text(path), Does.Not.Match(@"(?m)^\s*#\s*pragma\b"));

    static IEnumerable<string> Files(string pattern) => new[] { "Packages/com.glint.radar/Shaders", "Tests/EditMode" }
        .SelectMany(folder => Directory.GetFiles(Path.Combine(s_root, folder), pattern, SearchOption.AllDirectories))
        .Select(path => Path.GetRelativePath(s_root, path)).Order();

    static string Text(string path) => File.ReadAllText(Path.Combine(s_root, path));

    static IEnumerable<string> WithIncludes(string path, HashSet<string> seen)
    {
        if (!seen.Add(path))
            return [];
        return Include().Matches(Text(path)).Select(match => match.Groups[1].Value)
            .Select(name => name.StartsWith("Packages/") ? name : Relative(Path.GetDirectoryName(path), name))
            .SelectMany(name => WithIncludes(name, seen)).Append(path);
    }

    static string Relative(string folder, string name) =>
        Path.GetRelativePath(s_root, Path.GetFullPath(Path.Combine(s_root, folder, name)));

    [GeneratedRegex(@"(?m)^#pragma kernel .*$")]
    private static partial Regex Kernel();

    [GeneratedRegex(@"(?m)^#pragma disable_fastmath$")]
    private static partial Regex FastMath();

    [GeneratedRegex(@"(?m)^\s*precise\s")]
    private static partial Regex Precise();

    [GeneratedRegex("(?m)^#include \"([^\"]+)\"")]
    private static partial Regex Include();
}
