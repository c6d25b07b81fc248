using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Glint.Core;
using Glint.Editor;
using Newtonsoft.Json.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Glint.Host.Tests;

/// <summary>glint clutter: echo, models, level, moments, files, report, refusals. The stored sea has tiles of 64 m.</summary>
[Category("Slow")]
public sealed class ClutterCommandTests
{
    const string Scene = "Scenes/SeaState5.unity";

    // Few rays, and few tubes for the clutter.
    static readonly string[] s_coarse = ["--size", "96x54", "--frequency", "3e9"];

    string _folder;

    [SetUp]
    public void MakeFolder() => _folder = Directory.CreateTempSubdirectory("glint-clutter-").FullName;

    [TearDown]
    public void RemoveFolder() => Directory.Delete(_folder, true);

    /// <summary>At 60 degrees of grazing nothing is in the shade: the sum of the table over the facets, per area.</summary>
    [Test]
    public void Sigma0_OfALitSea_IsTheSumOverItsFacets()
    {
        Run("--clutter", "on", "--grazing", "60", "--azimuth", "30", "--snapshots", "3", "--out", At("out"));
        var row = Rows("out").Single();
        var sea = UnityEngine.Object.FindFirstObjectByType<Sea>();
        var clutter = sea.CurrentClutter();
        var table = clutter.TableAt(10e9);
        var scattering =
            new SeaScattering(10e9, clutter.Water.At(10e9).permittivity, clutter.ShortWaves.Spectrum.Density);
        var toRadar = RadarAspect.At(30, 60).ToRadar;
        var (corners, triangles) = (sea.CurrentSnapshot.Tile.vertices, sea.CurrentSnapshot.Tile.triangles);
        var sum = default(Sigma0);
        for (int i = 0; i < triangles.Length / 3; i++)
        {
            double3 Corner(int number) => (float3)corners[triangles[3 * i + number]];
            double3 section = math.cross(Corner(1) - Corner(0), Corner(2) - Corner(0)) / 2;
            double area = math.length(section), breaking = SeaScattering.Breaking(toRadar.y);
            var sigma = table.Read(section / area, toRadar, clutter.Wind, clutter.LogWinds[i / 2]);
            sum += area * (clutter.BreakingFacets[i]
                ? new Sigma0(breaking, breaking, scattering.BreakingCross(toRadar.y)) : sigma);
        }
        Assert.That(Number(row, "lit_fraction"), Is.EqualTo(1).Within(1e-6));
        Assert.That(Number(row, "sigma0_vv_db"), Is.EqualTo(Sigma0.Decibels(sum.VV / 4096)).Within(0.005));
        Assert.That(Number(row, "sigma0_hh_db"), Is.EqualTo(Sigma0.Decibels(sum.HH / 4096)).Within(0.005));
        Assert.That(Number(row, "sigma0_hv_db"), Is.EqualTo(Sigma0.Decibels(sum.HV / 4096)).Within(0.005));
        Assert.That(Number(row, "time_s"), Is.EqualTo(20));
        Assert.That(Number(row, "snapshot"), Is.EqualTo(3));
    }

    /// <summary>The wind blows along -Z: a radar at azimuth 0 looks against it.</summary>
    [Test]
    public void Rows_HaveTheModelsOfTheSeasState_WhereTheyHold()
    {
        Run("--clutter", "on", "--grazing", "1,10,70", "--azimuth", "0,90,180", "--frequency", "3e9,9.4e9",
            "--cell", "8", "--out", At("out"));
        var rows = Rows("out");
        Assert.That(rows.Select(row => $"{row["frequency_hz"]} {row["azimuth_deg"]} {row["grazing_deg"]}").Take(10),
            Is.EqualTo(new[] { "3000000000 0 1", "3000000000 0 10", "3000000000 0 70", "3000000000 90 1",
                "3000000000 90 10", "3000000000 90 70", "3000000000 180 1", "3000000000 180 10", "3000000000 180 70",
                "9400000000 0 1" }));
        foreach (var row in rows)
        {
            Assert.That(Number(row, "wind_angle_deg"), Is.EqualTo(Number(row, "azimuth_deg")).Within(1e-4));
            var at = new ClutterConditions(Number(row, "frequency_hz"), Number(row, "grazing_deg"),
                SeaStateFits.OfWaveHeight(2.5), Number(row, "azimuth_deg"));
            foreach (var model in ClutterModel.All)
                foreach (var polarisation in new[] { Polarisation.VV, Polarisation.HH })
                {
                    string cell = row[$"{model.Name}_{polarisation}_db"];
                    if (at.GrazingDegrees == 70)
                        Assert.That(cell, Is.Empty);
                    else
                        Assert.That(double.Parse(cell, CultureInfo.InvariantCulture),
                            Is.EqualTo(model.Decibels(polarisation, at)).Within(1e-4));
                }
            Assert.That(Number(row, "cells"), Is.EqualTo(64));
            Assert.That(Number(row, "shape_vv"), Is.GreaterThan(0));
            if (at.GrazingDegrees == 70 || at.Frequency == 3e9)
                Assert.That(row["measured_shape_hh"], Is.Empty, "measured up to 10 degrees, at X band");
            else
                Assert.That(Number(row, "measured_shape_hh"),
                    Is.EqualTo(ClutterStatistics.EmpiricalShape(at.GrazingDegrees, 64, true, 45)).Within(1e-9));
        }
    }

    /// <summary>The large sea is made from its waves; their mean echo hardly changes in time.</summary>
    [Test]
    public void Times_OfASeaWithoutSnapshots_MoveItsWaves()
    {
        var (code, _, error) = TestShell.Run("clutter", "Scenes/ShipLargeSea.unity", "--clutter", "on", "--grazing", "20",
            "--times", "0,5", "--cell", "8", "--out", At("out"));
        Assert.That(code, Is.Zero, error);
        var rows = Rows("out");
        Assert.That(rows.Select(row => row["time_s"]), Is.EqualTo(new[] { "0", "5" }));
        Assert.That(rows.Select(row => row["snapshot"]), Is.All.Empty);
        Assert.That(rows[1]["sigma0_hh_db"], Is.Not.EqualTo(rows[0]["sigma0_hh_db"]));
        Assert.That(Number(rows[1], "sigma0_hh_db"), Is.EqualTo(Number(rows[0], "sigma0_hh_db")).Within(1));
        (code, _, error) = TestShell.Run("clutter", "Scenes/ShipLargeSea.unity", "--clutter", "on", "--snapshots", "1");
        Assert.That((code, error.Trim()), Is.EqualTo((1, "glint: Sea of 'Sea' has no snapshots: put prefabs that glint "
            + "sea wrote into its list Snapshots")));
    }

    /// <summary>The mean is the model's, also between the angles of its factors; the texture is that of the waves.</summary>
    [TestCase("nrl", 11, Category = "Stress")]
    [TestCase("git", 6)]
    [TestCase("nathanson", 11, Category = "Stress")]
    public void Level_OfAModel_GivesItsMeanAndKeepsTheTexture(string name, int angles)
    {
        Run("--cell", "8", "--clutter", name, "--out", At("default"));
        Assert.That(Rows("default"), Has.Count.EqualTo(angles), "those at which the model holds");
        string[] options = ["--cell", "8", "--grazing", "0.3,1,4,8.5"];
        Run([.. options, "--clutter", name, "--out", At("model")]);
        Run([.. options, "--clutter", "physics", "--out", At("physics")]);
        foreach (var (row, own) in Rows("model").Zip(Rows("physics")))
        {
            foreach (string polarisation in new[] { "vv", "hh" })
                Assert.That(Number(row, $"sigma0_{polarisation}_db"),
                    Is.EqualTo(Number(row, $"{name}_{polarisation}_db")).Within(0.3), row["grazing_deg"]);
            foreach (string same in new[] { "shape_vv", "shape_hh", "lit_fraction", "nrl_vv_db" })
                Assert.That(row[same], Is.EqualTo(own[same]));
        }
        Assert.That(Rows("model").Zip(Rows("physics"), (row, own) =>
            Math.Abs(Number(row, "sigma0_hh_db") - Number(own, "sigma0_hh_db"))).Max(), Is.GreaterThan(2));
        foreach (string folder in new[] { "model", "physics" })
            Assert.That((string)JObject.Parse(File.ReadAllText(At(folder + "/results.json")))["settings"]["level"],
                Is.EqualTo(folder == "model" ? name : folder));
    }

    /// <summary>
    /// The published sea returns no ray; with clutter each snapshot answers, and nothing else of its rows changes.
    /// </summary>
    [Test]
    public void Sweep_OfSnapshots_AnswersWithClutterOnly()
    {
        void Sweep(string folder, params string[] options)
        {
            var (code, _, error) = TestShell.Run(["sweep", Scene, "--snapshots", "1,6", .. s_coarse, .. options,
                "--out", At(folder)]);
            Assert.That(code, Is.Zero, error);
        }

        Sweep("off");
        Sweep("on", "--clutter", "on");
        foreach (var (off, on) in Rows("off", "results.csv").Zip(Rows("on", "results.csv")))
        {
            foreach (string column in off.Keys.Where(column => column != "trace_ms"))
                Assert.That(on[column], Is.EqualTo(off[column]), column);
            Assert.That(off.ContainsKey("sigma_clutter_vv_dbsm"), Is.False);
            Assert.That(Number(on, "amplitude"), Is.Zero);
            Assert.That(Number(on, "sigma_clutter_vv_dbsm"), Is.GreaterThan(Number(on, "sigma_clutter_hh_dbsm") + 5));
            // One moment of speckle is exponential: within 25 dB below and 8 dB above its mean but for 0.5 %.
            foreach (string polarisation in new[] { "vv", "hh" })
                Assert.That(Number(on, $"sigma_{polarisation}_dbsm") - Number(on, $"sigma_clutter_{polarisation}_dbsm"),
                    Is.InRange(-25, 8));
            Assert.That(on["signal_to_clutter_vv_db"], Is.Empty, "nothing but the sea");
        }
    }

    // All snapshots are scaled as the first one, which a part does not trace.
    [Test]
    public void Sweep_OfAPartOfTheSnapshots_HasTheLevelOfTheWhole()
    {
        Dictionary<string, string> LastOf(string folder, params string[] options)
        {
            var (code, _, error) = TestShell.Run(["sweep", Scene, "--snapshots", "1:2", .. s_coarse, "--clutter", "nrl",
                .. options, "--out", At(folder)]);
            Assert.That(code, Is.Zero, error);
            return Rows(folder, "results.csv").Last();
        }

        var (whole, part) = (LastOf("whole"), LastOf("part", "--shard", "2/2"));
        foreach (string column in whole.Keys.Where(column => column.StartsWith("sigma_")))
            Assert.That(part[column], Is.EqualTo(whole[column]), column);
    }

    [Test]
    public void Run_OfASeaWithClutter_PrintsTheFiguresOfItsFiles()
    {
        var (code, output, error) = TestShell.Run(["run", Scene, .. s_coarse, "--clutter", "on", "--out", At("on")]);
        Assert.That(code, Is.Zero, error);
        var row = Rows("on", "results.csv").Single();
        foreach (string polarisation in new[] { "vv", "hh" })
            Assert.That(output, Does.Contain(string.Format(CultureInfo.InvariantCulture,
                "{0} {1:0.00} dBsm, clutter {2:0.00} dBsm, signal to clutter - dB", polarisation.ToUpperInvariant(),
                Number(row, $"sigma_{polarisation}_dbsm"), Number(row, $"sigma_clutter_{polarisation}_dbsm"))));
        (_, output, _) = TestShell.Run(["run", Scene, .. s_coarse, "--clutter", "off"]);
        Assert.That(output, Does.Not.Contain("dBsm"));
    }

    [Test]
    public void Report_HasTheRows()
    {
        Run("--clutter", "on", "--grazing", "1,10", "--out", At("out"));
        var (code, _, error) = TestShell.Run("report", At("out"));
        Assert.That(code, Is.Zero, error);
        string page = File.ReadAllText(At("out/report.html"));
        const string start = "<script type=\"application/json\" id=\"data\">";
        int from = page.IndexOf(start) + start.Length;
        var data = JObject.Parse(page[from..page.IndexOf("</script>", from)]);
        Assert.That((string)data["run"]["table"], Is.EqualTo("clutter"));
        Assert.That(data["run"]["rows"].Select(row => (double)row["grazing_deg"]), Is.EqualTo(new[] { 1, 10 }));
        (code, _, error) = TestShell.Run("report", At("out"), "--pose", "1");
        Assert.That((code, error.Trim()),
            Is.EqualTo((1, "glint: --pose 1: a report of glint clutter shows no pose: leave it out")));
        (code, _, error) = TestShell.Run("merge", At("out"), "--out", At("merged"));
        Assert.That((code, error.Trim()),
            Is.EqualTo((1, $"glint: {At("out")}: is not part of a sweep made with --shard")));
    }

    [Test]
    public void Run_Cancelled_KeepsItsRows()
    {
        var line = CommandLine.Parse(Commands.Clutter, [Scene, "--clutter", "on", "--out", At("out")]);
        Project.Open(Project.FindRoot(AppContext.BaseDirectory));
        Assert.That(Batch.Execute(line, new CancelAfter(5)), Is.EqualTo(130));
        Assert.That(Rows("out"), Has.Count.EqualTo(5));
        Assert.That(File.Exists(At("out/results.json")), Is.False);
    }

    [Test]
    public void Cells_TooFewForAShape_AreWarnedOf()
    {
        var (code, _, error) = Execute("--clutter", "on", "--grazing", "10", "--out", At("out"));
        Assert.That(code, Is.Zero, error);
        Assert.That(error, Does.StartWith("warning: Scenes/SeaState5.unity: Sea of 'Sea': where its mesh ends, at waves of "
            + "2.032 m, the short waves of a clutter wind of 10.4 m/s are 3.1 dB below the long ones"));
        Assert.That(error, Does.Contain("warning: SeaState5: at azimuth 0 deg a tile of 64 m has 8 cells of "
            + "15 x 30 m, and shapes take 10: their columns are empty; give the sea a larger tile, or a smaller --cell"));
        Assert.That(Rows("out").Single()["shape_vv"], Is.Empty);
    }

    // At 10 GHz the model has 11 of the option's angles, at 35 GHz none of the lowest.
    [TestCase("10e9,35e9")]
    [TestCase("35e9,10e9")]
    public void Angles_WhereTheModelDoesNotHoldAtEachFrequency_AreLeftOut(string frequencies)
    {
        var setup = new ClutterSetup(CommandLine.Parse(Commands.Clutter, new[]
            { "Scenes/SeaState5.unity", "--clutter", "nathanson", "--cell", "8", "--frequency", frequencies }));
        double[] expected = [.. new double[] { 1, 2, 3, 5, 7, 10, 15, 20, 30, 45, 60, 70 }.Where(grazing =>
            new[] { 10e9, 35e9 }.All(frequency =>
                setup.Model.Holds(setup.First.Clutter.ConditionsAt(frequency, 0, grazing))))];
        Assert.That(setup.Rows().Select(row => row.Grazing).Distinct(), Is.EqualTo(expected));
        Assert.That(expected, Has.Length.InRange(1, 10));
    }

    [TestCase(1, "glint: Scenes/SeaState5.unity: the clutter of 'Sea' is off: switch it on in its inspector, or give "
        + "--clutter on")]
    [TestCase(1, "--times", "--times", "1", "--clutter", "on")]
    [TestCase(1, "has no snapshot 11: it has 1 to 10", "--snapshots", "11", "--clutter", "on")]
    [TestCase(2, "--frequency 6e10: each frequency must be from 1e9 to 4.7e10 hertz", "--frequency", "6e10",
        "--clutter", "on")]
    [TestCase(1, "clutter model nrl: the grazing angle 70 deg must be from 0.1 to 60 deg", "--clutter", "nrl",
        "--grazing", "1,70")]
    [TestCase(2, "--clutter gauss: must be one of on, physics, nrl, git, nathanson", "--clutter", "gauss")]
    [TestCase(2, "--grazing 0: each grazing angle must be from 0.1 to 90 degrees", "--grazing", "0")]
    [TestCase(2, "--times: not with --snapshots", "--times", "0", "--snapshots", "1")]
    [TestCase(2, "--azimuth 10,10: the azimuth 10 degrees is given twice: give each once", "--azimuth", "10,10")]
    [TestCase(2, "there are more than 1,000,000 rows: shorten a list", "--azimuth", "0:359.999:0.001", "--frequency",
        "9e9,10e9,11e9", "--clutter", "on")]
    [TestCase(2, "--cell 0.1: each number must be from 0.5 to 10000", "--cell", "0.1")]
    public void Input_ThatCannotBeComputed_IsRefusedBeforeAnyFile(int code, string message, params string[] options)
    {
        var (actual, _, error) = Execute([.. options, "--out", At("out")]);
        Assert.That(error, Does.Contain(message));
        Assert.That(actual, Is.EqualTo(code));
        Assert.That(Directory.Exists(At("out")), Is.False);
    }

    [TestCase(1, "CornerReflector.unity: has no Sea component", "Scenes/CornerReflector.unity")]
    [TestCase(2, "x.obj: clutter does not take such a file: give a scene (.unity)", "x.obj")]
    public void Scene_WithoutASea_IsRefused(int code, string message, string input)
    {
        var (actual, _, error) = TestShell.Run("clutter", input, "--out", At("out"));
        Assert.That(error, Does.Contain(message));
        Assert.That(actual, Is.EqualTo(code));
    }

    List<Dictionary<string, string>> Rows(string folder, string table = "clutter.csv")
    {
        var lines = File.ReadAllLines(At($"{folder}/{table}")).Select(line => line.Split(',')).ToArray();
        return [.. lines.Skip(1).Select(cells =>
            lines[0].Zip(cells).ToDictionary(cell => cell.First, cell => cell.Second))];
    }

    static double Number(Dictionary<string, string> row, string column) =>
        double.Parse(row[column], CultureInfo.InvariantCulture);

    string At(string name) => Path.Combine(_folder, name);

    static void Run(params string[] options)
    {
        var (code, _, error) = Execute(options);
        Assert.That(code, Is.Zero, error);
    }

    static (int code, string output, string error) Execute(params string[] options) =>
        TestShell.Run(["clutter", Scene, .. options]);
}
