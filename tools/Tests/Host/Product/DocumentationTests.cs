using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Runtime.CompilerServices;
using System.Text.RegularExpressions;
using Glint.Core;
using NUnit.Framework;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;

namespace Glint.Host.Tests;

/// <summary>Links of the pages are valid, quoted messages are in the sources, and the pages' code runs.</summary>
public sealed class DocumentationTests
{
    static readonly string s_root = Project.FindRoot(AppContext.BaseDirectory);
    static readonly string s_package = Path.Combine(s_root, "Packages/com.glint.radar"),
        s_pages = Path.Combine(s_package, "Documentation~");

    static IEnumerable<string> Pages => Directory.GetFiles(s_pages, "*.md").Append(Path.Combine(s_root, "README.md"))
        .Append(Path.Combine(s_package, "README.md")).Select(path => Path.GetRelativePath(s_root, path));

    [TestCaseSource(nameof(Pages))]
    public void Links_LeadToFiles(string page)
    {
        string folder = Path.GetDirectoryName(Path.Combine(s_root, page));
        var links = Regex.Matches(File.ReadAllText(Path.Combine(s_root, page)), @"\]\(([^)#]+)[^)]*\)")
            .Select(match => match.Groups[1].Value)
            .Where(link => !link.StartsWith("http"));
        Assert.That(links.Where(link => !File.Exists(Path.Combine(folder, link))), Is.Empty);
    }

    [Test]
    public void Index_LinksEveryPage()
    {
        string index = File.ReadAllText(Path.Combine(s_pages, "index.md"));
        foreach (string page in Directory.GetFiles(s_pages, "*.md").Select(Path.GetFileName)
            .Where(name => name != "index.md"))
            Assert.That(index, Does.Contain($"]({page})"));
    }

    [Test]
    public void Materials_OfTheLibrary_AreInItsTableWithTheirRange()
    {
        string page = File.ReadAllText(Path.Combine(s_pages, "materials.md"));
        IEnumerable<(string, string)> rows = Regex.Matches(page, @"(?m)^\| `(\w+)` \|[^|]*\|[^|]*\| ([^|]*) GHz \|")
            .Select(match => (match.Groups[1].Value, match.Groups[2].Value));
        Assert.That(rows, Is.EqualTo(PublishedMaterial.All.Select(published => (published.Name, Gigahertz(published)))));

        static string Gigahertz(PublishedMaterial published) => string.Join(" to ",
            Regex.Matches(published.Medium.Frequencies.ToString(), @"[\d.]+e\d+")
                .Select(match => (double.Parse(match.Value) / 1e9).ToString("R")));
    }

    // "..." in a quote matches any text.
    [Test]
    public void Messages_OfTroubleshooting_AreInTheSources()
    {
        string sources = string.Concat(new[] { Path.Combine(s_package, "Core"), Path.Combine(s_package, "Runtime"),
            Path.Combine(s_package, "Editor"), Path.Combine(s_root, "tools/Vulkan"), Path.Combine(s_root, "tools/Cli") }
            .SelectMany(folder => Directory.GetFiles(folder, "*.cs", SearchOption.AllDirectories))
            .Select(file => Regex.Replace(File.ReadAllText(file), @"(?<!\\)""\s*\+\s*\$?""", ""))) // joins literals
            .Replace("\\\"", "\"");
        // Values of constants and options are literal in the pages' text.
        foreach (var (name, value) in new[]
        {
            ("Options.Resume.Flag", "--resume"),
            ("noun", "radar"), ("remedy", "RadarController (Glint > Radar Controller) to a camera of the scene"),
            ("StartAnew", "use the same settings, choose another results folder, or leave --resume out to replace "
                + "the results")
        })
            sources = sources.Replace("{" + name + "}", value);
        var quotes = File.ReadLines(Path.Combine(s_pages, "troubleshooting.md")).Where(line => line.StartsWith("> "))
            .Select(line => line[2..].Trim()).ToArray();
        Assert.That(quotes, Has.Length.GreaterThan(20));
        foreach (string quote in quotes)
            foreach (string part in quote.Split("...").Select(part => part.Trim(' ', '\'', ':', ';'))
                .Where(part => part.Length > 3))
                Assert.That(sources.Contains(part), $"\"{part}\" of: {quote}");
    }

    [Test]
    public void Quickstart_HasTheCodeOfTheTestBelow()
    {
        string code = Regex.Match(File.ReadAllText(Path.Combine(s_pages, "quickstart.md")),
            @"```csharp\n(\[Test\].*?)```", RegexOptions.Singleline).Groups[1].Value;
        Assert.That(Lines(File.ReadAllText(ThisFile())), Does.Contain(Lines(code)));
    }

    [SetUp]
    public void OpenAnEmptyScene() => EditorSceneManager.NewScene(NewSceneSetup.EmptyScene, NewSceneMode.Single);

    [Test]
    public void Plate_SeenHeadOn_ReturnsEveryRay()
    {
        var plate = GameObject.CreatePrimitive(PrimitiveType.Quad).transform;
        plate.position = new Vector3(0, 0, 10);
        var receiver = new GameObject("Receiver").transform;
        receiver.position = new Vector3(0, 0, -0.2f);
        var radar = new GameObject("Radar").AddComponent<Camera>().gameObject.AddComponent<RadarController>();
        radar.Kernel = AssetDatabase.LoadAssetAtPath<ComputeShader>("Packages/com.glint.radar/Shaders/Trace.compute");
        radar.Receiver = receiver;

        var result = radar.Trace();

        Assert.That(result.RaysHit, Is.Positive);
        Assert.That(result.RaysReceived, Is.EqualTo(result.RaysHit));
    }

    static string Lines(string text) => string.Join('\n', text.Split('\n').Select(line => line.Trim()));

    static string ThisFile([CallerFilePath] string path = null) => path;
}
