using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Runtime.CompilerServices;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Glint.Host.Tests;

/// <summary>
/// glint sea, glint ship and glint reflector in a project with the product but without generated meshes.
/// </summary>
public sealed class GeneratedAssetsTests
{
    // Assets older than the command, with guids that scenes refer to.
    static readonly string[] s_olderMetas =
        ["Meshes/CornerReflector.meta", "Meshes/CornerReflector/Corner Reflector.prefab.meta"];

    TemporaryProject _project;
    string _real, _workingFolder;

    [SetUp]
    public void MakeProject()
    {
        _workingFolder = Directory.GetCurrentDirectory();
        _real = Project.FindRoot(ThisFolder());
        _project = new TemporaryProject();
        _project.Write("Packages/manifest.json", """{ "dependencies": { "com.glint.meshes": "file:../Meshes" } }""");
        _project.Write("Meshes/package.json", """{ "name": "com.glint.meshes", "version": "1.0.0" }""");
        Directory.CreateSymbolicLink(Path.Combine(_project.Root, "Packages/com.glint.radar"),
            Path.Combine(_real, "Packages/com.glint.radar"));
        _ = _project.Project;
        Directory.SetCurrentDirectory(_project.Root);
    }

    [TearDown]
    public void RemoveProject()
    {
        Directory.SetCurrentDirectory(_workingFolder);
        _project.Dispose();
    }

    [Test]
    public void Commands_WithoutOptions_WriteTheFilesThatAreStored()
    {
        Execute(Commands.Sea);
        Execute(Commands.Ship);
        Execute(Commands.Reflector);

        string[] made = Files(_project.Root);
        Assert.That(made, Is.EqualTo(Files(_real)));
        Assert.That(made.Length, Is.EqualTo(4 + 2 * 10 * 4 + 4 + 2 * 2),
            "four folders' .meta; mesh, prefab and their .meta of each, two prefabs");
        foreach (string file in made.Except(s_olderMetas))
            Assert.That(Same(file),
                $"{file} is not what the command writes: run glint sea, glint ship and glint reflector");
    }

    [Test]
    public void Sea_OfOnesOwn_IsWrittenWhereAskedForAndHasItsHeight()
    {
        Execute(Commands.Sea, "--out", "Assets/Seas/Breeze", "--wave-height", "1.5", "--tile", "100", "--cells", "40",
            "--grid", "32", "--times", "0,5", "--tiles", "3x2");

        var snapshot = AssetDatabase.LoadAssetAtPath<GameObject>("Assets/Seas/Breeze/Snapshot 02.prefab")
            .GetComponent<SeaSnapshot>();
        Assert.That(snapshot.WaveHeight, Is.EqualTo(1.5).Within(1e-9),
            "no wave runs against the wind: all moments are as high");
        Assert.That(snapshot.TimeSeconds, Is.EqualTo(5));
        Assert.That(snapshot.GetComponentsInChildren<MeshFilter>(true).Select(tile => tile.transform.localPosition.x)
            .Distinct(), Is.EquivalentTo(new[] { -100f, 0, 100 }));
        Assert.That(snapshot.Tile.vertexCount, Is.EqualTo(41 * 41));
    }

    [Test]
    public void Sea_WrittenOverAnother_KeepsItsGuid()
    {
        Execute(Commands.Sea, "--out", "Assets/Sea", "--cells", "8");
        string guid = AssetDatabase.AssetPathToGUID("Assets/Sea/Snapshot 01.asset");
        Execute(Commands.Sea, "--out", "Assets/Sea", "--cells", "16");

        Assert.That(AssetDatabase.AssetPathToGUID("Assets/Sea/Snapshot 01.asset"), Is.EqualTo(guid));
        Assert.That(AssetDatabase.LoadAssetAtPath<Mesh>("Assets/Sea/Snapshot 01.asset").vertexCount,
            Is.EqualTo(17 * 17));
    }

    [Test]
    public void Ship_OfOnesOwn_HasItsMeasures()
    {
        Execute(Commands.Ship, "--out", "Assets/Ship", "--length", "80", "--beam", "13", "--triangles", "20000");

        var ship = AssetDatabase.LoadAssetAtPath<GameObject>("Assets/Ship/Ship.prefab");
        Assert.That(ship.GetComponent<Ship>().Settings.Beam, Is.EqualTo(13));
        var mesh = ship.GetComponent<MeshFilter>().sharedMesh;
        Assert.That(mesh.bounds.size.z, Is.EqualTo(80).Within(1));
        Assert.That(mesh.triangles.Length / 3, Is.EqualTo(20000).Within(5).Percent);
    }

    // Scenes refer to it by its guid, which a new prefab in its place would keep.
    [TestCase("Ship", "Ship")]
    [TestCase("Sea", "Snapshot 02")]
    public void Prefab_OfTheUser_IsNotReplaced(string command, string name)
    {
        string path = $"Assets/Mine/{name}.prefab", text = UnityText.Prefab(UnityText.Object(10, "Mine"));
        _project.Write(path, text, 5);
        AssetDatabase.Refresh();
        var error = Assert.Throws<GlintException>(() => Execute(command == "Ship" ? Commands.Ship : Commands.Sea,
            [.. command == "Ship" ? ["--length", "70"] : new[] { "--cells", "8", "--times", "0,5" }, "--out",
                "Assets/Mine"]));
        Assert.That(error.Message, Is.EqualTo($"{path}: is there, and is not one that glint made: name another folder "
            + "with --out"));
        Assert.That(File.ReadAllText(path), Is.EqualTo(text));
        Assert.That(Directory.GetFiles("Assets/Mine").Select(Path.GetFileName),
            Is.EquivalentTo(new[] { $"{name}.prefab", $"{name}.prefab.meta" }));
    }

    [Test]
    public void Ship_AsAFile_IsTheShipOfItsMeasures_TheSameBytesEachTime()
    {
        string[] measures = ["--length", "130", "--beam", "16", "--triangles", "15000"];
        foreach (string name in new[] { "first.stl", "second.stl" })
            Execute(Commands.Ship, [.. measures, "--stl", name]);

        Assert.That(File.ReadAllBytes("first.stl"), Is.EqualTo(File.ReadAllBytes("second.stl")));
        var read = MeshFileReader.Read("first.stl", LengthUnit.Parse("m"), UpAxis.Y);
        var settings = ShipSettings.Default;
        (settings.Length, settings.Beam, settings.Triangles) = (130, 16, 15000);
        var ship = ShipModel.Build(settings);
        Assert.That(read.Indices.Select(index => read.Vertices[index]),
            Is.EqualTo(ship.Indices.Select(index => ship.Vertices[index])));
    }

    [Test]
    public void Ship_AsAFileThatCannotBeWritten_IsRefused() =>
        Assert.That(Assert.Throws<GlintException>(() => Execute(Commands.Ship, "--stl", "none/ship.stl")).Message,
            Does.StartWith("none/ship.stl: the ship cannot be written").And.EndsWith("name another file with --stl"));

    [Test]
    [Platform("Linux")]
    public void Ship_AsAFile_OnAFullDisk_LeavesTheOlderFile()
    {
        File.WriteAllText("ship.stl", "older");
        File.CreateSymbolicLink("ship.stl.tmp", "/dev/full");
        Assert.That(Assert.Throws<GlintException>(() => Execute(Commands.Ship, "--stl", "ship.stl")).Message,
            Does.StartWith("ship.stl: the ship cannot be written").And.Contain("space"));
        Assert.That(File.ReadAllText("ship.stl"), Is.EqualTo("older"));
    }

    [Test]
    public void Sea_OverOneOfMoreSnapshots_NamesThoseThatStay()
    {
        Execute(Commands.Sea, "--out", "Assets/Sea", "--cells", "8", "--times", "0,5,10,15");
        Assert.That(_project.Warnings, Is.Empty);
        Execute(Commands.Sea, "--out", "Assets/Sea", "--cells", "8", "--times", "0,5,10");
        Execute(Commands.Sea, "--out", "Assets/Sea", "--cells", "8");
        Assert.That(_project.Warnings, Is.EqualTo(new[] { "Snapshot 04 is", "Snapshot 02 to Snapshot 04 are" }.Select(
            snapshots => $"Assets/Sea: {snapshots} of an earlier sea: remove what is not used any more, or write the new "
                + "sea to another folder")));
    }

    [Test]
    public void Assets_WrittenFromOutsideOfAProject_AreNamedByTheirPath()
    {
        Assert.That(Execute(Commands.Ship).Single(), Does.StartWith("Packages/com.glint.meshes/Ship/Ship.prefab: "));
        Directory.SetCurrentDirectory(Path.GetTempPath());
        Assert.That(Execute(Commands.Ship).Single(), Does.StartWith($"{_project.Root}/Meshes/Ship/Ship.prefab: "));
        Assert.That(Execute(Commands.Reflector)[0],
            Is.EqualTo($"{_project.Root}/Meshes/CornerReflector/Corner Reflector.prefab"));
        Assert.That(Execute(Commands.Sea, "--out", $"{_project.Root}/Assets/Sea", "--cells", "8")[0],
            Does.StartWith($"{_project.Root}/Assets/Sea: height factor "));
    }

    [TestCase(false)]
    [TestCase(true)]
    [Platform("Linux")]
    public void Mesh_ThatCannotBeWritten_IsRefusedWithTheWayOut(bool isDiskFull)
    {
        Directory.CreateDirectory("Assets/Ship");
        if (isDiskFull)
            File.CreateSymbolicLink($"Assets/Ship/.Ship.asset.{Environment.ProcessId}.tmp", "/dev/full");
        else
            Directory.CreateDirectory("Assets/Ship/Ship.asset");
        Assert.That(Assert.Throws<GlintException>(() => Execute(Commands.Ship, "--out", "Assets/Ship", "--beam", "13"))
            .Message, Does.StartWith("Assets/Ship/Ship.asset: cannot be written: ")
            .And.EndsWith(": free the disk or the folder, or name another folder with --out"));
    }

    [Test]
    public void Sea_OutsideOfTheProject_IsRefused() =>
        Assert.That(Assert.Throws<GlintException>(() => Execute(Commands.Sea, "--out", Path.GetTempPath())).Message,
            Does.Contain("outside of the Unity project"));

    // Returns what is printed.
    static List<string> Execute(Command command, params string[] arguments)
    {
        var lines = new Lines();
        Assert.That(Batch.Execute(CommandLine.Parse(command, arguments), lines), Is.Zero);
        return lines.Printed;
    }

    bool Same(string file) => File.ReadAllBytes(Path.Combine(_project.Root, file)).AsSpan()
        .SequenceEqual(File.ReadAllBytes(Path.Combine(_real, file)));

    static string[] Files(string root) => [.. new[] { "CornerReflector", "SeaState5", "SeaState6", "Ship" }
        .SelectMany(name => Directory.GetFiles(Path.Combine(root, "Meshes", name))
            .Append(Path.Combine(root, "Meshes", name + ".meta")))
        .Select(file => Path.GetRelativePath(root, file)).OrderBy(file => file, StringComparer.Ordinal)];

    static string ThisFolder([CallerFilePath] string file = "") => Path.GetDirectoryName(file);

    sealed class Lines : IProgressSink
    {
        public List<string> Printed { get; } = [];

        public System.Threading.CancellationToken Cancel => default;

        public void Start(string what, int total, int done = 0) { }

        public void Report(double value) { }

        public void Advance(int done, string note) { }

        public void Finish() { }

        public void Print(string line) => Printed.Add(line);
    }
}
