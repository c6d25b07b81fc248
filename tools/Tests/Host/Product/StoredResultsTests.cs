using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Runtime.CompilerServices;
using Glint.Core;
using Glint.Editor;
using Newtonsoft.Json.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Host.Tests;

/// <summary>
/// Results without a schema version are read, resumed, compared and reported. Version0 is a corner reflector at 0, 2
/// and 4 degrees with 192 x 108 rays; its unfinished sweep was killed after two poses.
/// </summary>
public sealed class StoredResultsTests
{
    string _folder;

    /// <summary>Files of before there was a schema version.</summary>
    internal static string Version0(string folder) => Path.Combine(Path.GetDirectoryName(ThisFile()), "Version0", folder);

    static string Stored => Version0("");

    [SetUp]
    public void MakeFolder() => _folder = Directory.CreateTempSubdirectory("glint-stored-").FullName;

    [TearDown]
    public void Remove() => Directory.Delete(_folder, true);

    [Test]
    public void Json_OfVersion0_HasTheFiguresOfItsCsv()
    {
        StoredRun run = StoredRun.Read(Path.Combine(Stored, "Finished"));
        string[][] lines = File.ReadAllLines(Path.Combine(Stored, "Finished", "results.csv"))
            .Select(line => line.Split(',')).ToArray();
        Assert.That(run.Count, Is.EqualTo(3));
        for (int i = 0; i < 3; i++)
            foreach (ResultColumn column in ResultColumn.All.Where(column => !column.IsOptional))
            {
                string cell = lines[i + 1][Array.IndexOf(lines[0], column.Name)];
                Assert.That(run.Rows[i][column] is double value ? Numbers.Format(value) : "", Is.EqualTo(cell));
            }
        Assert.That(run.Info.Settings.Select(setting => setting.Name), Has.No.Member("sampling_error"));
    }

    [Test]
    public void Resume_OfVersion0_GivesTheRowsOfTheFinishedSweep()
    {
        Copy("Unfinished");
        StoredRun whole = Finished();
        using (ResultsFolder results = ResultsFolder.Open(_folder))
        {
            results.Begin(UnfinishedSweep.Read(results.PartialPath).Identity, DateTime.UtcNow);
            Assert.That(results.Resume(3), Is.EqualTo(2));
            results.Append(whole.Rows[2]);
            results.Finish(whole.Info);
        }
        Assert.That(Timeless.Csv(_folder), Is.EqualTo(Timeless.Csv(Path.Combine(Stored, "Finished"))));
        Assert.That((int)JObject.Parse(File.ReadAllText(Path.Combine(_folder, "results.json")))["schema"],
            Is.EqualTo(1));
    }

    // A version with more columns resumes a sweep with fewer.
    [Test]
    public void Resume_OfASweepWithoutTheLastColumns_WritesThemAll()
    {
        Copy("Unfinished");
        string[] missing = { "ray_area_m2", "range_m" };
        string csv = Path.Combine(_folder, "results.csv"), partial = Path.Combine(_folder, "results.partial");
        string[][] lines = File.ReadAllLines(csv).Select(line => line.Split(',')).ToArray();
        int[] kept = Enumerable.Range(0, lines[0].Length).Where(i => !missing.Contains(lines[0][i])).ToArray();
        File.WriteAllText(csv,
            string.Concat(lines.Select(line => string.Join(",", kept.Select(i => line[i])) + "\n")));
        File.WriteAllText(partial, missing.Aggregate(File.ReadAllText(partial),
            (text, column) => text.Replace($"\"{column}\":null,", "")));
        StoredRun whole = Finished();
        using (ResultsFolder results = ResultsFolder.Open(_folder))
        {
            results.Begin(UnfinishedSweep.Read(partial).Identity, DateTime.UtcNow);
            Assert.That(results.Resume(3), Is.EqualTo(2));
            results.Append(whole.Rows[2]);
            results.Finish(whole.Info);
        }
        Assert.That(Timeless.Csv(_folder), Is.EqualTo(Timeless.Csv(Path.Combine(Stored, "Finished"))));
    }

    // The command resumes on the device that wrote the results; another device is refused by name.
    [Test]
    public void Resume_ByTheCommand_TakesTheSweepOrNamesTheDevice()
    {
        Copy("Unfinished");
        CommandLine line = CommandLine.Parse(Commands.Sweep, new[] { "Scenes/CornerReflector.unity", "--target",
            "Corner Reflector", "--angles", "0:4:2", "--size", "192x108", "--resume", "--out", _folder });
        string device = UnfinishedSweep.Read(Path.Combine(_folder, "results.partial")).Identity.Entries
            .Single(entry => entry.Key == "device").Value;
        if (device != SystemInfo.graphicsDeviceName)
        {
            Assert.That(() => Batch.Execute(line, new LogProgress()),
                Throws.TypeOf<GlintException>().With.Message.Contains("device was"));
            return;
        }
        try
        {
            Batch.Execute(line, new LogProgress());
        }
        catch (GlintException error) when (error.Message.Contains("graphics_api was"))
        {
            return; // another version of the same driver
        }
        Assert.That(Timeless.Csv(_folder), Is.EqualTo(Timeless.Csv(Path.Combine(Stored, "Finished"))));
    }

    [Test]
    public void Report_OfVersion0_KnowsTitlesAndUnits()
    {
        StoredRun run = StoredRun.Read(Path.Combine(Stored, "Finished"));
        string page = ReportFile.Fill(ReportFile.Placeholder, run, null, "No scene.");
        var columns = (JObject)JObject.Parse(page)["run"]["columns"];
        Assert.That((string)columns["rays_hit"]["title"], Is.EqualTo("Rays hit"));
        Assert.That(columns.Properties().Select(column => column.Name),
            Is.EqualTo(ResultColumn.All.Where(column => !column.IsOptional).Select(column => column.Name)));
    }

    [Test]
    public void Window_ShowsBothOfVersion0()
    {
        Assert.That(StoredRun.RowsOf(Path.Combine(Stored, "Finished")).Count, Is.EqualTo(3));
        IReadOnlyList<StoredRow> rows = StoredRun.RowsOf(Path.Combine(Stored, "Unfinished"));
        Assert.That(rows.Count, Is.EqualTo(2));
        Assert.That(rows[0].Text(), Does.Contain(", undersampled, 6 of 2,170 rays"));
    }

    [TestCase("Finished", "results.json")]
    [TestCase("Unfinished", "results.partial")]
    public void Results_OfANewerSchema_AreRefusedWithTheWayOut(string stored, string file)
    {
        Copy(stored);
        string path = Path.Combine(_folder, file), text = File.ReadAllText(path);
        File.WriteAllText(path, text.Insert(text.IndexOf('{') + 1, "\"schema\": 2,"));
        Assert.That(() => StoredRun.RowsOf(_folder), Throws.TypeOf<GlintException>().With.Message
            .StartsWith(path + ": has schema 2").And.Message.Contains("update Glint"));
    }

    void Copy(string stored)
    {
        foreach (string file in Directory.GetFiles(Path.Combine(Stored, stored)))
            File.Copy(file, Path.Combine(_folder, Path.GetFileName(file)));
    }

    static StoredRun Finished() => StoredRun.Read(Path.Combine(Stored, "Finished"));

    static string ThisFile([CallerFilePath] string path = null) => path;
}
