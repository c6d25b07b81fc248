using System.Collections.Generic;
using System.IO;
using System.Linq;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;
using UnityEditor.SceneManagement;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace Glint.Host.Tests;

/// <summary>Files and text exported from the window.</summary>
public sealed class WindowExportTests
{
    readonly List<string> _warnings = [];
    SweepForm _form;
    string _folder;

    [SetUp]
    public void Sweep()
    {
        _folder = Directory.CreateTempSubdirectory("glint-export-").FullName;
        EditorSceneManager.OpenScene("Packages/com.glint.scenes/CornerReflector.unity", OpenSceneMode.Single);
        _form = new SweepForm
        {
            Target = GameObject.Find("Corner Reflector").transform, [SweepAxis.Angle] = "0,20",
            Folder = Path.Combine(_folder, "results")
        };
        _form.FindRadar();
        var settings = _form.Radar.Settings;
        (settings.RaysAcross, settings.RaysDown) = (192, 108);
        _form.Radar.Settings = settings;
        using var session = SweepSession.Sweep(_form);
        while (session.IsRunning)
            session.Tick();
        _warnings.Clear();
        Application.logMessageReceived += Hear;
    }

    [TearDown]
    public void Remove()
    {
        Application.logMessageReceived -= Hear;
        EditorSceneManager.NewScene(NewSceneSetup.EmptyScene, NewSceneMode.Single);
        Directory.Delete(_folder, true);
    }

    [Test]
    public void Copy_OfAFile_IsTheFile()
    {
        string copy = Path.Combine(_folder, "copy.csv");
        File.WriteAllText(copy, "older");
        Export.Copy(_form.FolderPath, ResultsFolder.CsvName, copy);
        Assert.That(File.ReadAllBytes(copy),
            Is.EqualTo(File.ReadAllBytes(Path.Combine(_form.FolderPath, "results.csv"))));
        Assert.DoesNotThrow(
            () => Export.Copy(_form.FolderPath, ResultsFolder.CsvName, Path.Combine(_form.FolderPath, "results.csv")),
            "onto itself");
        string link = Path.Combine(_folder, "link.csv");
        File.CreateSymbolicLink(link, Path.Combine(_form.FolderPath, "results.csv"));
        Export.Copy(_form.FolderPath, ResultsFolder.CsvName, link);
        Assert.That(File.ReadAllBytes(link), Is.EqualTo(File.ReadAllBytes(copy)), "onto itself, by a link");
        Assert.That(
            () => Export.Copy(_form.FolderPath, ResultsFolder.CsvName, Path.Combine(_folder, "none", "copy.csv")),
            Throws.TypeOf<GlintException>().With.Message.Contains("cannot be written"));
        Assert.That(() => Export.Copy(_folder, ResultsFolder.JsonName, copy),
            Throws.TypeOf<GlintException>().With.Message.Contains("is complete"));
    }

    [Test]
    public void Report_OfTheOpenScene_HasItsPoseAndOpensNothing()
    {
        var scene = SceneManager.GetActiveScene();
        var (radar, rotation) = (_form.Radar, _form.Target.localRotation);
        string path = Path.Combine(_folder, "report.html");
        Export.Report(_form.FolderPath, 1, _form, path, new LogProgress());
        Assert.That(File.ReadAllText(path), Does.Contain("\"pose\":1,"));
        Assert.That((SceneManager.GetActiveScene(), _form.Radar == radar, radar != null, _form.Target.localRotation),
            Is.EqualTo((scene, true, true, rotation)));
        Assert.That(_warnings, Is.Empty);
    }

    [Test]
    public void Report_OfResultsOfAnotherTarget_HasTheRestAndSaysWhy()
    {
        _form.Target = _form.Radar.transform;
        Export.Report(_form.FolderPath, 1, _form, Path.Combine(_folder, "report.html"), new LogProgress());
        Assert.That(_warnings.Single(), Does.Contain("'Corner Reflector', is not the chosen one"));
        _warnings.Clear();
        _form.Radar = null;
        Export.Report(_form.FolderPath, 1, _form, Path.Combine(_folder, "report.html"), new LogProgress());
        Assert.That(_warnings.Single(), Does.Contain("CornerReflector.unity, is not open"));
        Assert.That(File.ReadAllText(Path.Combine(_folder, "report.html")), Does.Contain("\"amplitude_normalised\""));
    }

    void Hear(string text, string trace, LogType type)
    {
        if (type != LogType.Log)
            _warnings.Add(text);
    }
}
