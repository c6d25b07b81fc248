using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Reflection.Metadata;
using System.Reflection.PortableExecutable;
using System.Text.Json;
using Glint.Editor;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>
/// Scenes/Player.unity in a player: glint-player runs the product that was compiled without UNITY_EDITOR, in a process
/// of its own without UnityEditor.dll. The build of the product for it fails on reflection that stripping breaks.
/// </summary>
public sealed class PlayerTests
{
    const int Poses = 10;

    static readonly string s_root = Project.FindRoot(AppContext.BaseDirectory),
        s_bin = Path.Combine(s_root, "tools/artifacts/bin"), s_player = Path.Combine(s_bin, "Player/release");

    static readonly string[] s_product = ["Glint.Core", "Glint"];

    string _folder;
    string[] _screens, _log;

    string Results => Path.Combine(_folder, "DefaultCompany/Glint/Results/Player");

    // One frame more than the sweep has poses.
    [OneTimeSetUp]
    public void RunThePlayer()
    {
        _folder = Directory.CreateTempSubdirectory("glint-player-").FullName;
        (_screens, _log) = Run(_folder, Poses + 1);
    }

    [OneTimeTearDown]
    public void RemoveFolder() => Directory.Delete(_folder, true);

    [Test]
    public void Log_OfThePlayer_HasNoWarning() =>
        Assert.That(_log.Where(line => !line.StartsWith("[Log] ")), Is.Empty);

    [Test]
    public void Sweep_InThePlayer_WritesTheResultsOfTheEditor()
    {
        string editor = Path.Combine(_folder, "editor");
        var line = CommandLine.Parse(Commands.Sweep, ["Scenes/Player.unity", "--target", "Corner Reflector",
            "--angles", "0:45:5", "--out", editor]);
        Assert.That(Batch.Execute(line, new LogProgress()), Is.Zero);

        Assert.That(Rows(Results), Has.Length.EqualTo(Poses + 1));
        Assert.That(Rows(Results), Is.EqualTo(Rows(editor)));
        var sweep = Sweep(Results);
        Assert.That(JToken.DeepEquals(sweep, Sweep(editor)), $"{sweep}\n{Sweep(editor)}");
    }

    [Test]
    public void Screen_InEachFrame_ShowsTheProgressAndTheAmplitude()
    {
        var sweep = JObject.Parse(File.ReadAllText(Path.Combine(Results, "results.json")))["rows"];
        var shown = sweep.Select((row, index) => FormattableString.Invariant($"{index + 1} of {Poses} poses")
            + (index == Poses - 1 ? $", written to {Results}" : "")
            + FormattableString.Invariant($" | amplitude {(double)row["amplitude"]:g6}")
            + $" | {row["rays_received"]} of {row["rays_hit"]} rays that hit were received").ToArray();
        Assert.That(_screens, Is.EqualTo(shown.Append(shown[^1])));
    }

    [Test]
    public void Screen_WhereResultsCannotBeWritten_ShowsWhy()
    {
        string data = Directory.CreateDirectory(Path.Combine(_folder, "data")).FullName,
            file = Path.Combine(data, "DefaultCompany");
        File.WriteAllText(file, "");
        Assert.That(Run(data, 1).screens, Is.EqualTo(new[] { "0 of 0 poses | "
            + $"{file}/Glint/Results/Player: {file} is a file, not a folder: choose another results folder" }));
    }

    [Test]
    public void Assemblies_InThePlayer_AreThoseCompiledWithoutTheEditor()
    {
        foreach (string name in s_product)
            Assert.That(File.ReadAllBytes(Path.Combine(s_player, name + ".dll")),
                Is.EqualTo(File.ReadAllBytes(Path.Combine(s_bin, name + ".Player/release", name + ".dll"))), name);
        var others = new[] { "*Editor*.dll", "*Reference*.dll", "nunit*.dll", "*Test*.dll" };
        Assert.That(others.SelectMany(pattern => Directory.GetFiles(s_player, pattern)), Is.Empty);
    }

    [Test]
    public void References_OfThePlayersAssemblies_AreToThoseThatAPlayerHas() => Assert.That(
        s_product.SelectMany(References).Where(name => !name.StartsWith("System.")).Distinct(),
        Is.EquivalentTo(new[] { "Glint.Core", "UnityEngine", "Unity.Mathematics", "Newtonsoft.Json" }));

    // Unity puts into a player what is neither for the editor only nor bound to a symbol of the editor.
    [Test]
    public void Definitions_OfThePackage_PutTheseAssembliesIntoAPlayer()
    {
        var definitions = Directory.GetFiles(Path.Combine(s_root, "Packages/com.glint.radar"), "*.asmdef",
            SearchOption.AllDirectories).Where(file => !file.Contains('~')).Select(Definition).ToArray();
        Assert.That(definitions.Where(IsInPlayer).Select(it => it.GetProperty("name").GetString()),
            Is.EquivalentTo(s_product));
    }

    // Unity reads link.xml below Assets only: the package must not depend on one.
    [Test]
    public void LinkXml_WhereUnityDoesNotReadIt_IsNotThere() => Assert.That(
        new[] { "Packages", "Scenes", "Meshes", "Tests" }.SelectMany(folder => Directory.GetFiles(
            Path.Combine(s_root, folder), "link.xml", SearchOption.AllDirectories)), Is.Empty);

    [Test]
    public void Scene_OfThePlayer_IsTheFirstOfABuildAndTheOnlyOne() =>
        Assert.That(SceneLoads.BuildScenes, Is.EqualTo(new[] { "Packages/com.glint.scenes/Player.unity" }));

    static (string[] screens, string[] log) Run(string dataFolder, int frames)
    {
        var start = new ProcessStartInfo("dotnet", [Path.Combine(s_player, "glint-player.dll"), $"{frames}"])
        {
            RedirectStandardOutput = true, RedirectStandardError = true,
            Environment = { ["XDG_CONFIG_HOME"] = dataFolder },
        };
        using var player = Process.Start(start);
        var log = player.StandardError.ReadToEndAsync();
        var screens = player.StandardOutput.ReadToEnd().TrimEnd('\n').Split('\n');
        player.WaitForExit();
        Assert.That(player.ExitCode, Is.Zero, log.Result);
        return (screens, log.Result.TrimEnd('\n').Split('\n'));
    }

    // Without the time of each pose.
    static string[][] Rows(string folder)
    {
        var rows = File.ReadAllLines(Path.Combine(folder, "results.csv")).Select(line => line.Split(',')).ToArray();
        int time = Array.IndexOf(rows[0], "trace_ms");
        return rows.Select(row => row.Where((_, column) => column != time).ToArray()).ToArray();
    }

    static JToken Sweep(string folder) =>
        JObject.Parse(File.ReadAllText(Path.Combine(folder, "results.json")))["sweep"];

    static IEnumerable<string> References(string assembly)
    {
        using var image = new PEReader(File.OpenRead(Path.Combine(s_player, assembly + ".dll")));
        var reader = image.GetMetadataReader();
        return reader.AssemblyReferences.Select(handle =>
            reader.GetString(reader.GetAssemblyReference(handle).Name)).ToArray();
    }

    static JsonElement Definition(string file)
    {
        using var document = JsonDocument.Parse(File.ReadAllText(file));
        return document.RootElement.Clone();
    }

    static bool IsInPlayer(JsonElement definition) =>
        definition.GetProperty("includePlatforms").GetArrayLength() == 0
        && definition.GetProperty("defineConstraints").GetArrayLength() == 0;
}
