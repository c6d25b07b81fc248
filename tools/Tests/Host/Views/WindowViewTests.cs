using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Glint.Editor;
using Glint.Editor.Views;
using NUnit.Framework;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEditor.UIElements;
using UnityEngine;
using UnityEngine.UIElements;
using Object = UnityEngine.Object;

namespace Glint.Host.Tests;

/// <summary>Window > Glint > Radar, operated by its buttons and fields.</summary>
public sealed class WindowViewTests
{
    readonly List<string> _exceptions = new();
    Action<LogType, string> _writer;
    string _folder;
    RadarController _radar;
    RadarWindow _window;
    VisualElement _tree;

    [SetUp]
    public void OpenWindow()
    {
        _writer = LogSink.Writer;
        LogSink.Writer = (type, message) =>
        {
            if (type == LogType.Exception)
                _exceptions.Add(message);
        };
        _folder = Directory.CreateTempSubdirectory("glint-window-").FullName;
        EditorSceneManager.OpenScene("Packages/com.glint.scenes/CornerReflector.unity", OpenSceneMode.Single);
        _radar = Object.FindFirstObjectByType<RadarController>();
        var settings = _radar.Settings;
        (settings.RaysAcross, settings.RaysDown) = (192, 108);
        _radar.Settings = settings;
        _window = EditorWindow.GetWindow<RadarWindow>();
        _tree = _window.rootVisualElement;
    }

    [TearDown]
    public void CloseWindow()
    {
        EditorHooks.FileDialog = _ => "";
        _window.Close();
        EditorSceneManager.NewScene(NewSceneSetup.EmptyScene, NewSceneMode.Single);
        Directory.Delete(_folder, true);
        LogSink.Writer = _writer;
        Assert.That(_exceptions.ToArray(), Is.Empty);
        _exceptions.Clear();
    }

    // Of 1280 points the inspector takes 320; half of the rest is for the Scene view.
    [Test]
    public void Window_OnALaptop_CanBeDockedBesideTheInspector()
    {
        Assert.That(_window.minSize.x, Is.LessThanOrEqualTo((1280 - 320) / 2));
        Assert.That(_window.minSize.y, Is.LessThanOrEqualTo(300));
    }

    [Test]
    public void Window_OfASceneWithOneRadar_HasItAndCanTrace()
    {
        Assert.That(_window.titleContent.text, Is.EqualTo("Radar"));
        Assert.That(_tree.Find<ObjectField>(field => field.label == "Radar").value, Is.EqualTo(_radar));
        Assert.That((Button("Trace").enabledSelf, Button("Cancel").enabledSelf), Is.EqualTo((true, false)));
        Assert.That(EditorWindow.GetWindow<RadarWindow>(), Is.SameAs(_window));
    }

    [Test]
    public void Trace_ShowsThePoseInTheCharts()
    {
        Button("Trace").Click();
        Tick();
        foreach (VisualElement plot in Plots())
        {
            plot.Size = new Rect(0, 0, 400, 200);
            plot.Raise(new GeometryChangedEvent());
            Assert.That(plot.Children().OfType<Label>().Count(), Is.GreaterThan(3), "ticks and titles");
            Painter2D painter = plot.Paint();
            Assert.That(painter.Strokes, Is.GreaterThan(4), "grid and frame");
            Assert.That(painter.BadCorners, Is.Zero);
        }
        Label readout = _tree.Find<Label>(label => label.GetClasses().Contains("glint-readout"));
        Assert.That(readout.text, Does.Contain("rays that hit were received"));
    }

    [Test]
    public void Sweep_OfEveryColumn_HasLinesOfFiniteCorners()
    {
        Sweep();
        var show = _tree.Find<DropdownField>(field => field.label == "Show");
        Assert.That(show.value, Is.EqualTo("Amplitude, normalised"));
        foreach (bool inDecibels in new[] { false, true })
        {
            _tree.Find<ToolbarToggle>(toggle => toggle.text == "Decibels").value = inDecibels;
            foreach (string column in show.choices)
            {
                show.value = column;
                VisualElement plot = Plots().Single();
                plot.Size = new Rect(0, 0, 400, 200);
                plot.Raise(new GeometryChangedEvent());
                Assert.That(plot.Paint().BadCorners, Is.Zero, column);
                Assert.That(plot.Children().OfType<Label>().Select(label => label.text),
                    Has.Some.StartsWith(column));
            }
        }
    }

    [Test]
    public void Sweep_IsExportedAsItsFile()
    {
        Sweep();
        Assert.That(_tree.Find<ProgressBar>(_ => true).title, Is.EqualTo("2 of 2 poses"));
        string copy = Path.Combine(_folder, "copy.csv");
        EditorHooks.FileDialog = asked => asked == "results.csv" ? copy : "";
        Menu("Export", "results.csv");
        Assert.That(File.ReadAllText(copy), Is.EqualTo(File.ReadAllText(Path.Combine(_folder, "run", "results.csv"))));
    }

    // Neither where the window is nor whether it is seen has any part in it.
    [Test]
    public void Chart_IsExportedFromItsDataAndNotFromTheScreen()
    {
        Sweep();
        var pictures = new List<byte[]>();
        foreach (Rect place in new[] { new Rect(0, 0, 900, 600), new Rect(-5000, 7000, 480, 300) })
        {
            _window.position = place;
            string path = Path.Combine(_folder, $"chart{pictures.Count}.png");
            EditorHooks.FileDialog = asked => asked == "chart.png" ? path : "";
            Menu("Export", "Chart as PNG");
            pictures.Add(File.ReadAllBytes(path));
        }
        Assert.That(pictures[1], Is.EqualTo(pictures[0]));
        (int width, int height, Color32[] pixels) = PngFile.Read(pictures[0]);
        Assert.That((width, height > 800), Is.EqualTo((1600, true)));
        // Two poses: a line across the whole chart.
        Color32 line = ChartColours.Light.Line(0);
        Assert.That(pixels.Count(pixel => pixel.Equals(line)), Is.GreaterThan(1300));
        _tree.Find<ToolbarToggle>(toggle => toggle.text == "Decibels").value = true;
        Menu("Export", "Chart as PNG");
        Assert.That(File.ReadAllBytes(Path.Combine(_folder, "chart1.png")), Is.Not.EqualTo(pictures[0]));
    }

    [Test]
    public void Compare_WithAPublishedTable_NamesItsLines()
    {
        Sweep();
        var compare = _tree.Find<ToolbarMenu>(menu => menu.text == "Compare");
        Menu("Compare", compare.menu.MenuItems().OfType<DropdownMenuAction>().ElementAt(1).name);
        Assert.That(compare.tooltip, Does.StartWith("Laid over: "));
        Menu("Compare", "Nothing");
        Assert.That(compare.tooltip, Does.Not.StartWith("Laid over: "));
    }

    [Test]
    public void LookNow_ShowsThePictureAndWhatAPixelMet()
    {
        Button("Look now").Click();
        Image image = _tree.Find<Image>(_ => true);
        Assert.That(((Texture2D)image.image).Pixels.Distinct().Count(), Is.GreaterThan(2));
        image.Size = new Rect(0, 0, image.image.width, image.image.height);
        Label words = image.parent.Children().OfType<Label>().Single();
        image.Raise(new PointerMoveEvent { localPosition = image.Size.center });
        Assert.That(words.text, Is.Not.Empty);
        image.Raise(new PointerMoveEvent { localPosition = image.Size.max });
        Assert.That(words.text, Is.Empty, "beside the picture");
    }

    [Test]
    public void LookNow_WithoutARadar_SaysWhatToDo()
    {
        _tree.Find<ObjectField>(field => field.label == "Radar").value = null;
        Button("Look now").Click();
        Assert.That(_tree.Tree().OfType<Label>().Select(label => label.text), Has.Member("choose a radar first"));
        Assert.That(Button("Trace").enabledSelf, Is.False);
    }

    [Test]
    public void Angles_ThatAreNoNumbers_AreRefusedBesideTheField()
    {
        Text("Angles, deg").value = "zero";
        Assert.That(_tree.Tree().OfType<Label>().Where(label => label.text.Contains("zero")), Is.Not.Empty);
        Assert.That(Button("Sweep").enabledSelf, Is.False);
    }

    void Sweep()
    {
        _tree.Find<ObjectField>(field => field.label == "Target").value = GameObject.Find("Corner Reflector").transform;
        Text("Angles, deg").value = "0,20";
        Text("Results folder").value = Path.Combine(_folder, "run");
        Button("Sweep").Click();
        while (Button("Cancel").enabledSelf)
            Tick();
    }

    // As in the editor between two frames.
    static void Tick() => EditorApplication.update();

    Button Button(string text) => _tree.Find<Button>(button => button.text == text);

    TextField Text(string label) => _tree.Find<TextField>(field => field.label == label);

    void Menu(string menu, string action) =>
        _tree.Find<ToolbarMenu>(found => found.text == menu).menu.MenuItems()
            .OfType<DropdownMenuAction>().Single(item => item.name == action).Execute();

    IEnumerable<VisualElement> Plots() =>
        _tree.Tree().Where(element => element.GetClasses().Contains("glint-plot")).ToArray();
}
