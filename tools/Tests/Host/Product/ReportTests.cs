using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Security.Cryptography;
using System.Text;
using System.Text.RegularExpressions;
using Glint.Core;
using Glint.Editor;
using Newtonsoft.Json.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Host.Tests;

/// <summary>glint report: from a results folder to one self-contained file.</summary>
[Category("Slow")]
public sealed class ReportTests
{
    static readonly string[] Corner =
    {
        "Scenes/CornerReflector.unity", "--target", "Corner Reflector", "--size", "192x108"
    };

    readonly List<string> _warnings = new();
    string _folder;

    [SetUp]
    public void Listen()
    {
        _folder = Directory.CreateTempSubdirectory("glint-report-").FullName;
        _warnings.Clear();
        Application.logMessageReceived += Hear;
    }

    [TearDown]
    public void Remove()
    {
        Application.logMessageReceived -= Hear;
        Directory.Delete(_folder, true);
    }

    [Test]
    public void Report_OfASweep_HasItsFiguresAndTheStrongestPose()
    {
        Sweep("0,20,45");
        Report();

        var data = Data();
        var results = JObject.Parse(File.ReadAllText(Path.Combine(_folder, "results.json")));
        Assert.That(data["run"]["rows"].Select(row => (double)row["amplitude"]),
            Is.EqualTo(results["rows"].Select(row => (double)row["amplitude"])));
        int strongest = results["rows"].Select((row, i) => ((double)row["amplitude"], -i)).Max().Item2 * -1;
        Assert.That((int)data["scene"]["pose"], Is.EqualTo(strongest));
        Assert.That((long)data["scene"]["received"], Is.EqualTo((long)results["rows"][strongest]["rays_received"]),
            "the same pose, traced again");
        Assert.That((double)data["scene"]["amplitude"],
            Is.EqualTo((double)results["rows"][strongest]["amplitude"]).Within(1e-9));
        Assert.That((long)data["scene"]["drawn"], Is.EqualTo(36).And.EqualTo((long)data["scene"]["triangles"]));
        Assert.That(_warnings, Is.Empty);
    }

    // The lengths of the drawn paths give the phases, and the phases give the measured sums.
    [Test]
    public void Paths_OfThePose_AddUpToItsInPhaseAndQuadrature()
    {
        Sweep("0,20");
        Report("--pose", "2");

        var (scene, row) = (Data()["scene"], Data()["run"]["rows"][1]);
        Assert.That((int)scene["pose"], Is.EqualTo(1));
        var paths = Paths(scene);
        Assert.That(paths, Has.Length.EqualTo((int)scene["received"]));
        var (radar, receiver) = (Vector(scene["radar"]["place"]), Vector(scene["radar"]["receiver"]));
        foreach (var path in paths)
        {
            Assert.That(path.Length, Is.InRange(3, 6), "radar, one to four reflections, receiver");
            Assert.That(Length(path[0], radar), Is.LessThan(1e-4));
            // 3 x 3 m: its corners are 2.12 m from its centre.
            Assert.That(Length(path[^1], receiver), Is.LessThan(2.13));
        }
        var phases =
            paths.Select(path => 2 * Math.PI * path.Zip(path.Skip(1), Length).Sum() / (299792458 / 10e9)).ToArray();
        // Points are float32 some 50 m from the centre, so a path is accurate to 20 um, or 0.004 rad.
        Assert.That(phases.Sum(Math.Cos), Is.EqualTo((double)row["in_phase"]).Within(0.004 * paths.Length));
        Assert.That(phases.Sum(Math.Sin), Is.EqualTo((double)row["quadrature"]).Within(0.004 * paths.Length));
    }

    [Test]
    public void Picture_OfThePose_CountsTheBouncesOfItsRays()
    {
        Sweep("0");
        Report();

        var picture = Data()["scene"]["picture"];
        var bounces = Convert.FromBase64String((string)picture["bounces"]);
        Assert.That(bounces, Has.Length.EqualTo((int)picture["width"] * (int)picture["height"]));
        // The corner reflector in free space: most of the picture around it is empty, and it has one, two and three
        // reflections.
        Assert.That(bounces.Select(pixel => pixel & 127).Distinct(), Is.SupersetOf(new[] { 0, 1, 2 }));
        Assert.That(bounces.Any(pixel => pixel >= 128), "some ray is received");
        Assert.That(bounces.Where(pixel => pixel >= 128).All(pixel => (pixel & 127) is >= 1 and <= 4));
    }

    [Test]
    public void Report_OfASweepOf46Angles_IsBelowSixMegabytes()
    {
        Sweep("0:45:1");
        Report();
        Assert.That(new FileInfo(ReportPath).Length, Is.LessThan(6000000));
    }

    [Test]
    public void Report_OfAMeshFile_OpensItWithTheOptionsOfTheSweep()
    {
        string plate = Path.Combine(_folder, "plate.obj");
        File.WriteAllText(plate, "v -500 -500 0\nv 500 -500 0\nv 500 500 0\nv -500 500 0\nf 1 2 3 4\n");
        Batch.Execute(CommandLine.Parse(Commands.Sweep, new[] { plate, "--angles", "0,30", "--unit", "mm", "--grazing",
            "0", "--fov", "2.29153", "--size", "64x64", "--out", _folder }), new LogProgress());
        Report();

        // Head-on it covers 32 x 32 rays and returns all of them.
        var scene = Data()["scene"];
        Assert.That((long)scene["received"], Is.EqualTo(1024));
        Assert.That(Paths(scene).All(path => path.Length == 3));
    }

    [Test]
    public void Report_OfOnePoseOfAnStlFile_ShowsThatPose()
    {
        string plate = Path.Combine(_folder, "plate.stl");
        string Facet(string corners) => "facet normal 0 0 0\nouter loop\n"
            + $"{string.Concat(corners.Split(';').Select(corner => $"vertex {corner}\n"))}endloop\nendfacet\n";
        File.WriteAllText(plate, $"solid plate\n{Facet("-500 -500 0;500 -500 0;500 500 0")}"
            + $"{Facet("-500 -500 0;500 500 0;-500 500 0")}endsolid plate\n");
        Execute(Commands.Run, plate, "--unit", "mm", "--grazing", "0", "--fov", "2.29153", "--size", "64x64");
        Report();

        // The plate covers 32 x 32 rays and returns all of them.
        AssertShown(0);
        Assert.That((long)Data()["scene"]["received"], Is.EqualTo(1024));
    }

    [Test]
    public void Report_OfOnePoseOfAScene_ShowsThatPose()
    {
        Execute(Commands.Run, "Scenes/CornerReflector.unity", "--size", "192x108");
        Report();
        AssertShown(0);
    }

    // With this number of rays, only the fourth of these snapshots returns some.
    [Test]
    public void Report_OfASweepOverSnapshots_ShowsTheSnapshotOfThePose()
    {
        Execute(Commands.Sweep, "Scenes/SeaState6.unity", "--snapshots", "2:4", "--size", "384x216");
        Report();

        var received = Data()["run"]["rows"].Select(row => (long)row["rays_received"]).ToArray();
        Assert.That(received[2], Is.GreaterThan(received[0] + received[1]));
        AssertShown(2);
    }

    // All poses of the plan have different figures, so that they cannot be confused.
    [TestCase(1)]
    [TestCase(4)]
    [TestCase(8)]
    public void Report_OfASweepOverSeveralAxes_PutsThePoseUpAgain(int pose)
    {
        Execute(Commands.Sweep,
            Corner.Concat(new[] { "--angles", "0,8", "--grazing", "10,12", "--frequency", "9e9,10e9" }).ToArray());
        Assert.That(Data(Path.Combine(_folder, "results.json"))["rows"].Select(row => (double)row["in_phase"])
            .Distinct().Count(), Is.EqualTo(8));
        Report("--pose", $"{pose}");
        AssertShown(pose - 1);
    }

    // The component Sweep writes results without a command line.
    [Test]
    public void Report_OfASweepThatNoCommandBegan_OpensItsScene()
    {
        var loaded = LoadedScene.Open(
            CommandLine.Parse(Commands.Sweep, Corner.Take(3).Concat(new[] { "--angles", "0" }).ToArray()));
        using (var folder = ResultsFolder.Open(_folder))
        using (var run = new SweepRun(new SweepSetup(loaded.Radar,
            new SweepPlan(new[] { 0.0, 20 }))
        { Target = loaded.Target, Scene = loaded.Scene }, folder))
            while (!run.IsComplete)
                run.Step();
        Report("--pose", "2");

        Assert.That(Data()["run"]["command"]?.HasValues ?? false, Is.False);
        AssertShown(1);
    }

    [Test]
    public void Report_WhenTheMeshFileIsGone_SaysSoAndHasTheRest()
    {
        string plate = Path.Combine(_folder, "plate.obj");
        File.WriteAllText(plate, "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nf 1 2 3\n");
        Batch.Execute(
            CommandLine.Parse(Commands.Run, new[] { plate, "--grazing", "0", "--size", "64x64", "--out", _folder }),
            new LogProgress());
        File.Delete(plate);
        Report();

        var data = Data();
        Assert.That(data["scene"].Type, Is.EqualTo(JTokenType.Null));
        Assert.That((string)data["no_scene"], Does.Contain("plate.obj"));
        Assert.That(data["run"]["rows"].Count(), Is.EqualTo(1));
        Assert.That(_warnings.Single(), Does.Contain("plate.obj"));
    }

    [Test]
    public void Report_WithoutPose_OpensNoScene()
    {
        Sweep("0");
        Report("--pose", "none", "--out", ReportPath);
        Assert.That(Data()["scene"].Type, Is.EqualTo(JTokenType.Null));
        Assert.That(_warnings, Is.Empty);
    }

    [Test]
    public void Report_OfAPoseThatIsNotThere_IsRefused()
    {
        Sweep("0,15");
        Assert.That(() => Report("--pose", "3"), Throws.TypeOf<GlintException>()
            .With.Message.Contain("--pose 3: must be from 1 to 2,").And.Message.Contain("or none"));
        Assert.That(File.Exists(ReportPath), Is.False);
    }

    // Both hosts read the template that npm built. This finds sources or a template that changed alone.
    [Test]
    public void Template_IsMadeOfTheSourcesThatAreThere()
    {
        string root = Engine.Assets.ProjectRoot, sources = Path.Combine(root, "tools/report");
        var template = File.ReadAllText(Path.Combine(root, "Packages/com.glint.radar/Editor/Report/Template.txt"));
        var made = Regex.Match(template, "^<!DOCTYPE html>\n<!-- sources ([0-9a-f]{64}) page ([0-9a-f]{64}) -->\n");
        Assert.That(made.Success, "the first two lines of Template.txt");

        var files = new[] { "build", "build.mjs", "package.json", "package-lock.json" }
            .Concat(Directory.GetFiles(Path.Combine(sources, "src")).Select(path => "src/" + Path.GetFileName(path)));
        string list = string.Concat(files.OrderBy(path => path, StringComparer.Ordinal)
            .Select(path => $"{Hash(File.ReadAllBytes(Path.Combine(sources, path)))}  {path}\n"));
        Assert.That(made.Groups[1].Value, Is.EqualTo(Hash(Encoding.UTF8.GetBytes(list))),
            "sources changed: run tools/report/build");
        Assert.That(made.Groups[2].Value, Is.EqualTo(Hash(Encoding.UTF8.GetBytes(template[made.Length..]))),
            "the template changed by itself: run tools/report/build");
    }

    [Test]
    public void Template_AsksForNothing()
    {
        var template = File.ReadAllText(
            Path.Combine(Engine.Assets.ProjectRoot, "Packages/com.glint.radar/Editor/Report/Template.txt"));
        string markup = Regex.Replace(template, "<script>.*?</script>", "", RegexOptions.Singleline);
        Assert.That(markup, Does.Contain("default-src 'none'"), "the browser refuses requests");
        Assert.That(Regex.Matches(markup, "(?:src|href)=\"(?!#|data:)"), Is.Empty);
        Assert.That(markup, Does.Contain("MIT License").Or.Contain("The MIT License"), "licences of what is bundled");
        Assert.That(File.ReadAllText(Path.Combine(Engine.Assets.ProjectRoot, "tools/report/package-lock.json")),
            Does.Not.Contain("\"resolved\""), "no registry's name");
    }

    // Traces a row's pose again from the results, with the same figures.
    void AssertShown(int pose)
    {
        var (scene, row) = (Data()["scene"], Data()["run"]["rows"][pose]);
        Assert.That((int)scene["pose"], Is.EqualTo(pose));
        Assert.That((long)row["rays_received"], Is.Positive);
        Assert.That((long)scene["received"], Is.EqualTo((long)row["rays_received"]));
        Assert.That((double)scene["amplitude"], Is.EqualTo((double)row["amplitude"]).Within(1e-9));
        Assert.That(Paths(scene), Is.Not.Empty);
    }

    void Execute(Command command, params string[] arguments) => Batch.Execute(
        CommandLine.Parse(command, arguments.Concat(new[] { "--out", _folder }).ToArray()), new LogProgress());

    void Sweep(string angles) => Batch.Execute(
        CommandLine.Parse(Commands.Sweep, Corner.Concat(new[] { "--angles", angles, "--out", _folder }).ToArray()),
        new LogProgress());

    void Report(params string[] options)
    {
        _warnings.Clear();
        Assert.That(
            Batch.Execute(CommandLine.Parse(Commands.Report, options.Prepend(_folder).ToArray()), new LogProgress()),
            Is.EqualTo(0));
    }

    string ReportPath => Path.Combine(_folder, "report.html");

    static JObject Data(string path) => JObject.Parse(File.ReadAllText(path));

    JObject Data() => JObject.Parse(Regex.Match(File.ReadAllText(ReportPath),
        "<script type=\"application/json\" id=\"data\">(.*?)</script>", RegexOptions.Singleline).Groups[1].Value);

    static double[][][] Paths(JToken scene)
    {
        var bytes = Convert.FromBase64String((string)scene["paths"]["points"]);
        int at = 0;
        double Next() => BitConverter.ToSingle(bytes, 4 * at++);
        return scene["paths"]["counts"].Select(count => Enumerable.Range(0, (int)count)
            .Select(point => new[] { Next(), Next(), Next() }).ToArray()).ToArray();
    }

    static double[] Vector(JToken numbers) => numbers.Select(number => (double)number).ToArray();

    static double Length(double[] a, double[] b) => Math.Sqrt(a.Zip(b, (x, y) => (x - y) * (x - y)).Sum());

    static string Hash(byte[] content) => Convert.ToHexString(SHA256.HashData(content)).ToLowerInvariant();

    void Hear(string text, string stack, LogType type)
    {
        if (type != LogType.Log)
            _warnings.Add(text);
    }
}
