using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Numerics;
using System.Text.RegularExpressions;
using Glint.Editor;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace Glint.Host.Tests;

/// <summary>glint rcs --contributions: files, resumption and parts; and the report of cross sections.</summary>
public sealed class ContributionTests
{
    static readonly string[] s_files =
        ["rcs.csv", "rcs.npz", "results.json", "contributions.csv", "hotspots.csv"];

    string _folder;

    [SetUp]
    public void MakePlate()
    {
        _folder = Directory.CreateTempSubdirectory("glint-contributions-").FullName;
        WritePlate("plate.obj", 0.1);
    }

    [TearDown]
    public void RemovePlate() => Directory.Delete(_folder, true);

    [Test]
    public void Files_OfAScene_AddUpByObjectAndByBounces()
    {
        Run("rcs", "Scenes/CornerReflector.unity", "--azimuth", "0,20", "--frequency", "1e9", "--polarisation",
            "vv,hh", "--tolerance", "0.5", "--contributions", "--out", At("rcs"));
        var rows = Table("rcs/rcs.csv");
        var parts = Table("rcs/contributions.csv");
        Assert.That(parts.Where(part => part["by"] == "object").Select(part => part["name"]).Distinct(),
            Is.EquivalentTo(new[] { "X", "Y", "Z" }.Select(plate => $"Corner Reflector/Frame/Plate {plate}")));
        Assert.That(parts.Where(part => part["by"] == "bounces").Select(part => part["name"]).Take(4),
            Is.EqualTo(new[] { "edges", "1", "2", "3" }));
        Assert.That(parts.Select(part => part["hv_dbsm"] + part["vh_re_m"]), Is.All.Empty, "not asked for");
        foreach (var row in rows)
            foreach (string by in new[] { "object", "bounces" })
            {
                var own = parts.Where(part => part["by"] == by && part["azimuth_deg"] == row["azimuth_deg"]);
                var sum = own.Aggregate(Complex.Zero, (all, part) => all + Amplitude(part));
                Assert.That((sum - Amplitude(row)).Magnitude, Is.LessThan(1e-9 * Amplitude(row).Magnitude), by);
            }
        var spots = Table("rcs/hotspots.csv");
        // Head-on the reflector returns by three bounces: the inner sides of its plates, two triangles each.
        Assert.That(spots.Where(spot => spot["azimuth_deg"] == "0" && double.Parse(spot["vv_dbsm"],
            CultureInfo.InvariantCulture) > 50).Select(spot => spot["object"]).Distinct().Count(), Is.EqualTo(3));
    }

    [Test]
    public void Contributions_ChangeNothingElse()
    {
        string[] rcs = ["rcs", At("plate.obj"), "--azimuth", "0:4:2", "--frequency", "9e9,9.5e9", "--tolerance", "0.5"];
        Run([.. rcs, "--out", At("without")]);
        Run([.. rcs, "--contributions", "--out", At("with")]);
        Assert.That(File.ReadAllText(At("with/rcs.csv")), Is.EqualTo(File.ReadAllText(At("without/rcs.csv"))));
        Assert.That(File.Exists(At("without/contributions.csv")), Is.False);
        Run([.. rcs, "--out", At("with")]);
        Assert.That(File.Exists(At("with/hotspots.csv")), Is.False, "an older one is removed");
    }

    [Test]
    public void PartsAndResumption_GiveTheFilesOfAnUndividedRun()
    {
        string[] rcs = ["rcs", At("plate.obj"), "--azimuth", "0:3:1", "--frequency", "9e9,9.5e9", "--tolerance", "0.5",
            "--contributions"];
        Run([.. rcs, "--out", At("whole")]);
        for (int number = 1; number <= 2; number++)
            Run([.. rcs, "--shard", $"{number}/2", "--out", At($"{number}")]);
        Assert.That(File.Exists(At("1/contributions.csv")), Is.False, "the merged whole has it");
        Assert.That(Run("merge", At("1"), At("2"), "--out", At("merged")), Does.Contain("hotspots.csv"));
        AssertSame("merged");

        var line = CommandLine.Parse(Commands.Rcs, [.. rcs.Skip(1), "--out", At("stopped")]);
        Project.Open(Project.FindRoot(AppContext.BaseDirectory));
        Assert.That(Batch.Execute(line, new CancelAfter(5)), Is.EqualTo(130));
        Run([.. rcs, "--out", At("stopped"), "--resume"]);
        AssertSame("stopped");
    }

    [TestCase("has no contributions")]
    [TestCase("has a contribution of object 7 of 1")]
    public void Row_WithoutTheContributionsOfItsScene_IsDamaged(string problem)
    {
        string[] rcs = ["rcs", At("plate.obj"), "--azimuth", "0:3:1", "--tolerance", "0.5", "--contributions"];
        for (int number = 1; number <= 2; number++)
            Run([.. rcs, "--shard", $"{number}/2", "--out", At($"{number}")]);
        Edit(At("2/results.json"), text => Damage(JObject.Parse(text), "rows[1].", problem));
        var (code, _, error) = TestShell.Run("merge", At("1"), At("2"), "--out", At("merged"));
        Assert.That(error, Does.StartWith($"glint: {At("2/results.json")}: cannot be read as results, it is damaged: row 2 "
            + $"{problem}; "));
        Assert.That((code, Directory.Exists(At("merged"))), Is.EqualTo((1, false)));

        Project.Open(Project.FindRoot(AppContext.BaseDirectory));
        string[] stopped = [.. rcs, "--out", At("stopped")];
        Assert.That(Batch.Execute(CommandLine.Parse(Commands.Rcs, [.. stopped.Skip(1)]), new CancelAfter(2)),
            Is.EqualTo(130));
        Edit(At("stopped/results.partial"), text => string.Join("\n", text.Split('\n').Select((line, i) =>
            i == 1 ? Damage(JObject.Parse(line), "", problem) : line)));
        (code, _, error) = TestShell.Run([.. stopped, "--resume"]);
        Assert.That((code, error.Trim()), Is.EqualTo((1, $"glint: {At("stopped/results.partial")}: row 1 {problem}: it was "
            + "changed; restore it, or leave --resume out")));
    }

    static string Damage(JObject json, string row, string problem)
    {
        if (problem == "has no contributions")
            json.SelectToken(row + "contributions").Parent.Remove();
        else
            json.SelectToken(row + "contributions.objects[0]")[0] = 7;
        return json.ToString(Newtonsoft.Json.Formatting.None);
    }

    static void Edit(string path, Func<string, string> change) => File.WriteAllText(path, change(File.ReadAllText(path)));

    [Test]
    public void NameWithAComma_IsQuoted()
    {
        WritePlate("a,\"b.obj", 0.1);
        Run("rcs", At("a,\"b.obj"), "--tolerance", "1", "--contributions", "--out", At("rcs"));
        Assert.That(File.ReadAllText(At("rcs/contributions.csv")), Does.Contain(",object,\"a,\"\"b\","));
    }

    [TestCase("\"objects\":[", "\"others\":[", "contributions of a row has no objects")]
    [TestCase("\"bounces\":[[0,", "\"bounces\":[[", "bounces of a row are not lists of 9 numbers")]
    [TestCase("\"hot_spots\":[[0,", "\"hot_spots\":[[null,", "hot_spots of a row are not lists of 6 numbers")]
    public void DamagedContributions_AreRefusedByName(string before, string after, string message)
    {
        Run("rcs", At("plate.obj"), "--tolerance", "1", "--contributions", "--out", At("rcs"));
        string text = File.ReadAllText(At("rcs/results.json"));
        Assert.That(text, Does.Contain(before));
        File.WriteAllText(At("rcs/results.json"), text.Replace(before, after));
        var (code, _, error) = TestShell.Run("report", At("rcs"), "--pose", "none");
        Assert.That(code, Is.EqualTo(1));
        Assert.That(error, Does.Contain(At("rcs/results.json")).And.Contain(message));
    }

    [Test]
    public void Report_HasRowsAndTheCornersOfHotSpots()
    {
        Run("rcs", At("plate.obj"), "--azimuth", "0,10", "--tolerance", "0.5", "--contributions", "--out", At("rcs"));
        Run("report", At("rcs"), "--pose", "2");
        var data = Report();
        Assert.That((string)data["run"]["table"], Is.EqualTo("rcs"));
        Assert.That(data["run"]["rows"].Select(row => (double)row["azimuth_deg"]), Is.EqualTo(new[] { 0.0, 10 }));
        Assert.That((string)data["run"]["scene"]["object_names"].Single(), Is.EqualTo("plate"));
        var scene = data["scene"];
        Assert.That((int)scene["pose"], Is.EqualTo(1));
        Assert.That((bool)scene["is_changed"], Is.False);
        var names = scene["hot_spots"]["names"].Select(name => ((int)name[0], (int)name[1])).ToArray();
        Assert.That(names, Is.EquivalentTo(new[] { (0, 0), (0, 1) }));
        var bytes = Convert.FromBase64String((string)scene["hot_spots"]["corners"]);
        var corners = Enumerable.Range(0, bytes.Length / 4).Select(i => BitConverter.ToSingle(bytes, 4 * i)).ToArray();
        Assert.That(corners, Has.Length.EqualTo(2 * 9));
        // Every corner is one of the plate's, whose centre is the origin.
        for (int i = 0; i < corners.Length; i += 3)
        {
            Assert.That(Math.Abs(corners[i]), Is.EqualTo(0.15).Within(1e-6));
            Assert.That(Math.Abs(corners[i + 1]), Is.EqualTo(0.1).Within(1e-6));
            Assert.That(corners[i + 2], Is.Zero);
        }
    }

    [Test]
    public void Report_OfAChangedMesh_HasItWithoutHotSpots()
    {
        Run("rcs", At("plate.obj"), "--tolerance", "0.5", "--contributions", "--out", At("rcs"));
        WritePlate("plate.obj", 0.2);
        Run("report", At("rcs"));
        var scene = Report()["scene"];
        Assert.That((bool)scene["is_changed"]);
        Assert.That(scene["hot_spots"]["names"], Is.Empty);
        Assert.That(scene["meshes"], Is.Not.Empty);
        File.Delete(At("plate.obj"));
        Assert.That(TestShell.Run("report", At("rcs")).error, Does.Contain("the report has no 3-D view"));
        Assert.That(Report()["scene"].Type, Is.EqualTo(JTokenType.Null));
        Assert.That((string)Report()["no_scene"], Does.Contain("plate.obj"));
    }

    /// <summary>Results of a newer version, or edited ones.</summary>
    [Test]
    public void Report_OfAnUnknownCommand_HasNoSceneAndSaysWhy()
    {
        Run("rcs", At("plate.obj"), "--tolerance", "0.5", "--out", At("rcs"));
        string results = At("rcs/results.json"), text = File.ReadAllText(results);
        foreach (string name in new[] { "rcs2", "ship" })
        {
            var json = JObject.Parse(text);
            Assert.That((string)json["command"][0], Is.EqualTo("rcs"));
            json["command"][0] = name;
            File.WriteAllText(results, json.ToString());
            var (code, _, error) = TestShell.Run("report", At("rcs"));
            Assert.That(code, Is.Zero, error);
            Assert.That(error, Does.Contain("the report has no 3-D view: the results are those of a command '" + name));
        }
    }

    JObject Report() => JObject.Parse(Regex.Match(File.ReadAllText(At("rcs/report.html")),
        "<script type=\"application/json\" id=\"data\">(.*?)</script>").Groups[1].Value);

    void AssertSame(string folder)
    {
        Assert.That(Directory.GetFiles(At(folder)).Select(Path.GetFileName), Is.EquivalentTo(s_files));
        foreach (string file in s_files.Where(file => file != "results.json"))
            Assert.That(File.ReadAllBytes(At($"{folder}/{file}")), Is.EqualTo(File.ReadAllBytes(At($"whole/{file}"))),
                file);
        Assert.That(Timeless.Json(At(folder)), Is.EqualTo(Timeless.Json(At("whole"))));
    }

    // Upright, facing -Z, where the radar is at azimuth 0.
    void WritePlate(string name, double halfHeight)
    {
        string y = halfHeight.ToString(CultureInfo.InvariantCulture);
        File.WriteAllText(At(name),
            $"v -0.15 -{y} 0\nv 0.15 -{y} 0\nv 0.15 {y} 0\nv -0.15 {y} 0\nf 1 2 3 4\n");
    }

    List<Dictionary<string, string>> Table(string name)
    {
        var lines = File.ReadAllLines(At(name)).Select(line => line.Split(',')).ToArray();
        return [.. lines.Skip(1).Select(cells =>
            lines[0].Zip(cells).ToDictionary(cell => cell.First, cell => cell.Second))];
    }

    static Complex Amplitude(Dictionary<string, string> row) => new(
        double.Parse(row["vv_re_m"], CultureInfo.InvariantCulture),
        double.Parse(row["vv_im_m"], CultureInfo.InvariantCulture));

    string At(string name) => Path.Combine(_folder, name);

    static string Run(params string[] arguments)
    {
        var (code, output, error) = TestShell.Run(arguments);
        Assert.That(code, Is.Zero, error);
        return output;
    }
}
