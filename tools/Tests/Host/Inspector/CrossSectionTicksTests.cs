using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using Glint.Core;
using Glint.Editor;
using NUnit.Framework;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEditor.UIElements;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.UIElements;
using Glint.Editor.Views;
using Object = UnityEngine.Object;

namespace Glint.Host.Tests;

/// <summary>A RadarCrossSection in edit mode, as its inspector runs it: ticks, cancelling, files, errors.</summary>
public sealed class CrossSectionTicksTests
{
    const string Scene = "Packages/com.glint.scenes/CrossSection.unity";

    readonly List<float?> _bar = [];
    readonly List<string> _errors = [];
    RadarCrossSection _radar;
    string _folder;

    [SetUp]
    public void OpenScene()
    {
        _folder = Directory.CreateTempSubdirectory("glint-ticks-").FullName;
        EditorSceneManager.OpenScene(Scene, OpenSceneMode.Single);
        _radar = Object.FindFirstObjectByType<RadarCrossSection>();
        (_radar.Azimuths, _radar.OutputFolder) = ("0:359:45", Path.Combine(_folder, "component"));
        _bar.Clear();
        _errors.Clear();
        Application.logMessageReceived += Hear;
        EditorHooks.ProgressBar = value => { _bar.Add(value); return false; };
    }

    [TearDown]
    public void Close()
    {
        GraphicsDevice.Type = GraphicsDeviceType.Vulkan;
        EditorHooks.ProgressBar = _ => false;
        EditorHooks.Reveal = _ => { };
        Application.logMessageReceived -= Hear;
        EditorSceneManager.NewScene(NewSceneSetup.EmptyScene, NewSceneMode.Single);
        Assert.That(EditorApplication.update, Is.Null, "nothing ticks any more");
        Directory.Delete(_folder, true);
    }

    // The scene has nothing but the target.
    [Test]
    public void Run_OfAScene_WritesTheRowsOfTheCommand()
    {
        CrossSectionTicks.Run(_radar, 3600);
        Assert.That((_radar.IsRunning, _radar.Rows.Count), Is.EqualTo((true, 0)));
        for (int done = 1; done <= 8; done++)
        {
            Tick();
            Assert.That(_radar.Rows, Has.Count.EqualTo(done), "a direction a tick");
        }
        Assert.That(_radar.IsRunning, Is.False);
        Tick();

        string command = Path.Combine(_folder, "command");
        Assert.That(Batch.Execute(CommandLine.Parse(Commands.Rcs,
            [Scene, "--azimuth", "0:359:45", "--polarisation", "vv,hh", "--out", command]), new LogProgress()), Is.Zero);
        foreach (string file in new[] { "rcs.csv", "rcs.npz" })
            Assert.That(File.ReadAllBytes(Path.Combine(_radar.ResultsPath, file)),
                Is.EqualTo(File.ReadAllBytes(Path.Combine(command, file))), file);
        Assert.That(File.Exists(Path.Combine(_radar.ResultsPath, "results.json")));
        Assert.That(_bar, Is.Empty, "no direction took an hour");
    }

    static readonly Dictionary<string, (Action<RadarCrossSection> change, string[] options)> Settings = new()
    {
        ["range"] = (it => (it.Azimuths, it.Range) = ("0,20,100", 3), ["--azimuth", "0,20,100", "--range", "3"]),
        ["fixed receiver"] = (
            it => (it.Azimuths, it.Receiver, it.ReceiverAzimuth, it.ReceiverElevation)
                = ("0,20", CrossSectionReceiver.Fixed, 40, 10),
            ["--azimuth", "0,20", "--bistatic", "40,10"]),
        // The trace of a direction has 16 receivers at most.
        ["receivers"] = (
            it => (it.Azimuths, it.Elevations, it.Receiver, it.ReceiverAzimuths)
                = ("20", "5", CrossSectionReceiver.Sweep, "0:80:5"),
            ["--azimuth", "20", "--elevation", "5", "--receivers", "0:80:5"]),
        ["receivers at a range, two frequencies"] = (
            it => (it.Azimuths, it.Frequencies, it.Receiver, it.ReceiverAzimuths, it.Range)
                = ("20,30", "5e9,10e9", CrossSectionReceiver.Sweep, "-60:60:60", 3),
            ["--azimuth", "20,30", "--frequency", "5e9,10e9", "--receivers", "-60:60:60", "--range", "3"])
    };

    static IEnumerable<string> SettingNames => Settings.Keys;

    // The rows bit for bit, and what results.json says of them. They need no accuracy: few tubes.
    [TestCaseSource(nameof(SettingNames))]
    public void Run_WithReceiversOrARange_WritesTheResultsOfTheCommand(string name)
    {
        (Action<RadarCrossSection> change, string[] options) = Settings[name];
        change(_radar);
        _radar.ToleranceDb = 3;
        CrossSectionTicks.Run(_radar, 3600);
        while (_radar.IsRunning)
            Tick();
        Tick();
        Assert.That(_radar.Problem, Is.Null);
        string command = Path.Combine(_folder, "command");
        Assert.That(Batch.Execute(CommandLine.Parse(Commands.Rcs,
            [Scene, .. options, "--tolerance", "3", "--polarisation", "vv,hh", "--out", command]), new LogProgress()), Is.Zero);
        foreach (string file in new[] { "rcs.csv", "rcs.npz" })
            Assert.That(File.ReadAllBytes(Path.Combine(_radar.ResultsPath, file)),
                Is.EqualTo(File.ReadAllBytes(Path.Combine(command, file))), file);
        foreach (string part in new[] { "settings", "sweep", "rows" })
            Assert.That(Json(_radar.ResultsPath, part), Is.EqualTo(Json(command, part)), part);
    }

    static string Json(string folder, string part) =>
        JsonDocument.Parse(File.ReadAllText(Path.Combine(folder, "results.json"))).RootElement.GetProperty(part)
            .GetRawText();

    /// <summary>Before there were sweeps of receivers, scenes had a switch for a fixed receiver, and no range.</summary>
    [TestCase(0, CrossSectionReceiver.Radar)]
    [TestCase(1, CrossSectionReceiver.Fixed)]
    public void Scene_StoredWithASwitchForAFixedReceiver_KeepsIt(int stored, CrossSectionReceiver expected)
    {
        string root = Project.FindRoot(AppContext.BaseDirectory);
        string[] later = ["  _receiverAzimuths:", "  _range:"];
        string[] lines = File.ReadAllLines(Path.Combine(root, "Scenes/CrossSection.unity"));
        string[] before = lines.Where(line => !later.Any(line.StartsWith)).Select(line => line switch
        {
            "  _receiver: 0" => $"  _isBistatic: {stored}",
            "  _receiverAzimuth: 0" => "  _receiverAzimuth: -30.5",
            "  _receiverElevation: 0" => "  _receiverElevation: 7",
            _ => line
        }).ToArray();
        Assert.That(before.Except(lines).Count(), Is.EqualTo(3));
        using var scene = new TemporaryScene(string.Join("\n", before) + "\n");
        EditorSceneManager.OpenScene(scene.Path, OpenSceneMode.Single);
        _radar = Object.FindFirstObjectByType<RadarCrossSection>();
        Assert.That((_radar.Receiver, _radar.ReceiverAzimuth, _radar.ReceiverElevation, _radar.Range),
            Is.EqualTo((expected, -30.5, 7.0, 0.0)));
        Assert.That(_radar.Setup(new SceneGatherer()).Range, Is.EqualTo(double.PositiveInfinity));
    }

    [Test]
    public void Inspector_OfASweepOfReceivers_PlotsOverThem()
    {
        (_radar.Azimuths, _radar.Receiver, _radar.ReceiverAzimuths)
            = ("20", CrossSectionReceiver.Sweep, "0:90:30");
        var editor = UnityEditor.Editor.CreateEditor(_radar);
        VisualElement inspector = editor.CreateInspectorGUI();
        Show(inspector);
        var plot = inspector.Find<PolarView>(_ => true);
        plot.Size = new Rect(0, 0, 400, 340);
        CrossSectionTicks.Run(_radar);
        Tick();
        Show(inspector);
        Tick();
        Assert.That(_radar.Rows, Has.Count.EqualTo(4));
        Assert.That(plot.Children().OfType<Label>().Select(label => label.text),
            Does.Contain("over receivers").And.Contain("radar at 20°"));
        Object.DestroyImmediate(editor);
    }

    [TestCase(CrossSectionReceiver.Radar)]
    [TestCase(CrossSectionReceiver.Fixed, "_receiverAzimuth", "_receiverElevation")]
    [TestCase(CrossSectionReceiver.Sweep, "_receiverAzimuths")]
    public void Inspector_EnablesTheFieldsOfTheReceiver(CrossSectionReceiver receiver, params string[] enabled)
    {
        _radar.Receiver = receiver;
        var editor = UnityEditor.Editor.CreateEditor(_radar);
        VisualElement inspector = editor.CreateInspectorGUI();
        Show(inspector);
        Assert.That(inspector.Tree().OfType<PropertyField>()
            .Where(field => field.bindingPath.StartsWith("_receiver") && field.bindingPath != "_receiver"
                && field.enabledSelf).Select(field => field.bindingPath), Is.EqualTo(enabled));
        Object.DestroyImmediate(editor);
    }

    [Test]
    public void Run_CancelledByTheBarOfALongDirection_EndsAndKeepsTheRows()
    {
        CrossSectionTicks.Run(_radar, 0);
        Tick();
        EditorHooks.ProgressBar = value => { _bar.Add(value); return true; };
        Tick();
        Assert.That((_radar.IsRunning, _radar.Rows.Count, _radar.Problem), Is.EqualTo((false, 1, (string)null)));
        Assert.That(_bar.Last(), Is.Null, "the bar is closed");
        Tick();
        Assert.That(File.ReadAllLines(Path.Combine(_radar.ResultsPath, "rcs.csv")), Has.Length.EqualTo(2));
    }

    [Test]
    public void Run_OfAnObjectThatIsDestroyed_GivesTheFolderBack()
    {
        CrossSectionTicks.Run(_radar);
        Tick();
        string folder = _radar.ResultsPath;
        Object.DestroyImmediate(_radar.gameObject);
        Assert.That(() => ResultsFolder.Open(folder, ResultTable.CrossSection).Dispose(), Throws.Nothing);
        Tick();
    }

    [Test]
    public void Run_TwiceIntoOneFolder_IsRefusedUntilTheFirstEnds()
    {
        var other = SceneObjects.MakeCrossSection(_radar.Target.gameObject);
        (other.Azimuths, other.OutputFolder) = ("0", _radar.OutputFolder);
        CrossSectionTicks.Run(_radar);
        CrossSectionTicks.Run(other);
        Assert.That(other.Problem, Does.Contain(_radar.OutputFolder));
        Assert.That(_errors, Is.EqualTo(new[] { other.Problem }));
        _radar.Cancel();
        CrossSectionTicks.Run(other);
        Tick();
        Assert.That((other.Rows.Count, other.Problem), Is.EqualTo((1, (string)null)));
        Tick();
    }

    [TestCase(GraphicsDeviceType.Null, "start Unity without -nographics")]
    [TestCase(GraphicsDeviceType.OpenGLES3, "has no 'precise': use Vulkan")]
    public void Run_OnADeviceThatCannotTrace_SaysWhyAndTheWayOut(GraphicsDeviceType device, string message)
    {
        GraphicsDevice.Type = device;
        CrossSectionTicks.Run(_radar);
        Assert.That(_radar.Problem, Does.Contain(message));
        Assert.That(_errors, Is.EqualTo(new[] { _radar.Problem }));
        Assert.That((_radar.IsRunning, Directory.Exists(_radar.OutputFolder)), Is.EqualTo((false, false)));
        Tick();
    }

    [Test]
    public void Inspector_RunAndCancel_ShowProgressPlotAndFolder()
    {
        var editor = UnityEditor.Editor.CreateEditor(_radar);
        VisualElement inspector = editor.CreateInspectorGUI();
        Show(inspector);
        var plot = inspector.Find<PolarView>(_ => true);
        plot.Size = new Rect(0, 0, 400, 340);
        var button = inspector.Find<Button>(it => it.text == "Run");
        var open = inspector.Find<Button>(it => it.text == "Open results folder");
        var progress = inspector.Find<ProgressBar>(_ => true);
        Assert.That((open.enabledSelf, plot.style.display.value, plot.Paint().Strokes),
            Is.EqualTo((false, DisplayStyle.None, 0)));

        button.Click();
        Assert.That(button.text, Is.EqualTo("Cancel"));
        for (int i = 0; i < 3; i++)
            Tick();
        Show(inspector);
        Assert.That((progress.value, progress.highValue, progress.title), Is.EqualTo((3f, 8f, "3 of 8 rows")));
        Assert.That(plot.style.display.value, Is.EqualTo(DisplayStyle.Flex));
        Assert.That(plot.Paint().Strokes, Is.GreaterThan(2 + 12), "two curves, spokes and rings");
        Assert.That(plot.Children().OfType<Label>().Select(label => label.text), Does.Contain("90°").And.Contain("VV"));

        button.Click();
        Assert.That((button.text, _radar.IsRunning), Is.EqualTo(("Run", false)));
        string revealed = null;
        EditorHooks.Reveal = path => revealed = path;
        Assert.That(open.enabledSelf);
        open.Click();
        Assert.That(revealed, Is.EqualTo(_radar.ResultsPath));
        Tick();
        Object.DestroyImmediate(editor);
    }

    [Test]
    public void Inspector_OfARefusedRun_ShowsTheMessage()
    {
        var editor = UnityEditor.Editor.CreateEditor(_radar);
        VisualElement inspector = editor.CreateInspectorGUI();
        Show(inspector);
        _radar.Frequencies = "0";
        inspector.Find<Button>(it => it.text == "Run").Click();
        var problem = inspector.Children().OfType<HelpBox>().Single();
        Assert.That((problem.text, problem.style.display.value), Is.EqualTo((_radar.Problem, DisplayStyle.Flex)));
        Assert.That(problem.text, Does.Contain("frequencies 0: each frequency must be"));
        Tick();
        Object.DestroyImmediate(editor);
    }

    static void Tick() => EditorApplication.update?.Invoke();

    static void Show(VisualElement inspector)
    {
        foreach (ScheduledItem item in inspector.Tree().SelectMany(element => element.Scheduled).ToArray())
            item.Run();
    }

    void Hear(string message, string trace, LogType type)
    {
        if (type is LogType.Error or LogType.Exception)
            _errors.Add(message);
    }
}
