using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using Glint.Editor.Views;
using Glint.Tests;
using NUnit.Framework;
using UnityEditor;
using UnityEditor.UIElements;
using UnityEngine;
using UnityEngine.UIElements;
using Object = UnityEngine.Object;

namespace Glint.Host.Tests;

/// <summary>The inspectors' element trees, as Unity requests them.</summary>
public sealed class InspectorViewTests
{
    static readonly Type[] Inspected = typeof(RadarWindow).Assembly.GetTypes()
        .Select(type => type.GetCustomAttribute<CustomEditor>()?.InspectedType)
        .Where(type => type is not null).ToArray();

    readonly List<Object> _objects = new();
    readonly List<string> _exceptions = new();
    Action<LogType, string> _writer;

    [SetUp]
    public void ListenForExceptions()
    {
        _writer = LogSink.Writer;
        LogSink.Writer = (type, message) =>
        {
            if (type == LogType.Exception)
                _exceptions.Add(message);
        };
    }

    [TearDown]
    public void RemoveObjects()
    {
        LogSink.Writer = _writer;
        foreach (Object made in _objects)
            Object.DestroyImmediate(made);
        _objects.Clear();
        Assert.That(_exceptions.ToArray(), Is.Empty);
        _exceptions.Clear();
    }

    [Test]
    public void Inspectors_AreThereForComponentsAndMaterials() =>
        Assert.That(Inspected, Is.SupersetOf(
            new[]
            {
                typeof(RadarController), typeof(RadarCrossSection), typeof(RadarMaterial), typeof(RayPaths),
                typeof(Sweep), typeof(Sea), typeof(Ship)
            }));

    [TestCaseSource(nameof(Inspected))]
    public void Inspector_OfOneObject_BuildsATreeAndLooksAtTheObject(Type type)
    {
        VisualElement inspector = Inspect(Make(type));
        Run(inspector);
        Assert.That(Fields(inspector), Is.Not.Empty);
        foreach (string path in Fields(inspector))
            Assert.That(IsSerialized(type, path), Is.True, $"{type.Name} has no serialized field {path}");
    }

    [TestCaseSource(nameof(Inspected))]
    public void Inspector_OfTwoObjects_ShowsEverySerializedFieldAndLooksAtNone(Type type)
    {
        VisualElement inspector = Inspect(Make(type), Make(type));
        string[] shown = Fields(inspector).ToArray();
        Assert.That(shown, Is.EquivalentTo(SerializedPaths(type, shown)));
        Assert.That(inspector.Tree().SelectMany(element => element.Scheduled), Is.Empty);
    }

    [Test]
    public void TraceNow_OfARadarBeforeAPlate_ShowsTheResult()
    {
        RadarController radar = MakeRadarBeforeAPlate();
        VisualElement inspector = Inspect(radar);
        Run(inspector);
        inspector.Find<Button>(button => button.text == "Trace now").Click();
        Assert.That(radar.Result.RaysHit, Is.GreaterThan(0));
        VisualElement result = inspector.Find<Foldout>(group => group.text == "Last result");
        string hit = result.Find<TextField>(row => row.label == "Rays hit").value;
        Assert.That(hit, Is.EqualTo($"{radar.Result.RaysHit} of 14,400"));
    }

    // A user selects a figure to copy it; a field that is made again has lost the selection.
    [Test]
    public void Figures_ThatChange_StayInTheirFields()
    {
        RadarController radar = MakeRadarBeforeAPlate();
        VisualElement inspector = Inspect(radar);
        Run(inspector);
        VisualElement figures = inspector.Find<Foldout>(group => group.text == "Figures");
        TextField[] before = figures.Tree().OfType<TextField>().ToArray();
        TextField rays = before.Single(field => field.label == "Rays");
        string text = rays.value;
        radar.Settings = TestRadar.Settings(320, 180);
        Run(inspector);
        Assert.That(figures.Tree().OfType<TextField>(), Is.EqualTo(before));
        Assert.That(rays.value, Is.Not.EqualTo(text));
    }

    [Test]
    public void TraceNow_WithoutAReceiver_SaysWhyNot()
    {
        var radar = (RadarController)Make(typeof(RadarController));
        VisualElement inspector = Inspect(radar);
        Run(inspector);
        HelpBox problem = inspector.Children().OfType<HelpBox>().Single();
        Assert.That(problem.style.display.value, Is.EqualTo(DisplayStyle.None));
        inspector.Find<Button>(button => button.text == "Trace now").Click();
        Assert.That((problem.text, problem.style.display.value), Is.EqualTo((radar.HasNoReceiver, DisplayStyle.Flex)));
    }

    [Test]
    public void Snapshot_ChosenInTheSeasInspector_IsShownUntilUndone()
    {
        var sea = (Sea)Make(typeof(Sea));
        sea.Snapshots.AddRange(new SeaSnapshot[3]);
        VisualElement inspector = Inspect(sea);
        Run(inspector);
        var snapshot = inspector.Find<DropdownField>(field => field.label == "Snapshot");
        Assert.That(snapshot.choices, Has.Count.EqualTo(3));
        snapshot.value = snapshot.choices[2];
        Assert.That(sea.Snapshot, Is.EqualTo(3));
        Undo.PerformUndo();
        Assert.That(sea.Snapshot, Is.EqualTo(1));
    }

    [Test]
    public void Published_ChosenInTheMaterialsInspector_IsTheMaterialUntilUndone()
    {
        var material = (RadarMaterial)Make(typeof(RadarMaterial));
        VisualElement inspector = Inspect(material);
        Run(inspector);
        var published = inspector.Find<DropdownField>(field => field.label == "Published");
        Assert.That(published.enabledSelf, Is.False);
        material.Kind = RadarMaterialKind.Published;
        Run(inspector);
        Assert.That(published.enabledSelf);
        Assert.That(inspector.Tree().OfType<HelpBox>().Single().text, Does.Contain("no published material"));
        published.value = "itu_brick";
        Assert.That(material.Published, Is.EqualTo("itu_brick"));
        Run(inspector);
        Assert.That(inspector.Tree().OfType<HelpBox>(), Is.Empty);
        Assert.That(inspector.Find<TextField>(row => row.label == "Source").value, Does.Contain("P.2040-3"));
        Undo.PerformUndo();
        Assert.That(material.Published, Is.Empty);
    }

    [Test]
    public void Change_InTheScene_IsLookedAtWhileTheInspectorIsShown()
    {
        VisualElement inspector = Inspect(Make(typeof(Ship)));
        ScheduledItem look = inspector.Scheduled.Single();
        ObjectChangeEvents.Raise();
        Assert.That(look.Delays, Is.Zero, "not attached yet");
        inspector.Raise(new AttachToPanelEvent());
        int attached = look.Delays;
        ObjectChangeEvents.Raise();
        Assert.That(look.Delays, Is.EqualTo(attached + 1));
        inspector.Raise(new DetachFromPanelEvent());
        ObjectChangeEvents.Raise();
        Assert.That(look.Delays, Is.EqualTo(attached + 1));
    }

    RadarController MakeRadarBeforeAPlate()
    {
        var radar = (RadarController)Make(typeof(RadarController));
        GameObject plate = Keep(GameObject.CreatePrimitive(PrimitiveType.Quad));
        (plate.transform.position, plate.transform.localScale) = (new Vector3(0, 0, 20), new Vector3(4, 4, 1));
        (radar.Settings, radar.Kernel) = (TestRadar.Settings(), TestKernels.Trace);
        radar.Receiver = MeshFileScene.MakeReceiver(radar.transform, false);
        radar.Roots.Add(plate.transform);
        return radar;
    }

    Object Make(Type type) => type.IsSubclassOf(typeof(ScriptableObject))
        ? Keep(ScriptableObject.CreateInstance(type))
        : Keep(new GameObject(type.Name)).AddComponent(type);

    T Keep<T>(T made)
        where T : Object
    {
        _objects.Add(made);
        return made;
    }

    VisualElement Inspect(params Object[] targets)
    {
        UnityEditor.Editor editor = UnityEditor.Editor.CreateEditor(targets);
        _objects.Insert(0, editor);
        return editor.CreateInspectorGUI();
    }

    static void Run(VisualElement inspector)
    {
        foreach (ScheduledItem item in inspector.Tree().SelectMany(element => element.Scheduled).ToArray())
            item.Run();
    }

    static IEnumerable<string> Fields(VisualElement inspector) =>
        inspector.Tree().OfType<PropertyField>().Select(field => field.bindingPath);

    static bool IsSerialized(Type type, string path)
    {
        foreach (string name in path.Split('.'))
        {
            type = SerializedFields.Of(type).FirstOrDefault(field => field.Name == name)?.FieldType;
            if (type is null)
                return false;
        }
        return true;
    }

    // The fields of a struct shown field by field must all be visible.
    static IEnumerable<string> SerializedPaths(Type type, string[] shown) =>
        SerializedFields.Of(type)
            .Where(field => !field.IsDefined(typeof(HideInInspector)))
            .SelectMany(field => shown.Contains(field.Name)
                ? new[] { field.Name }
                : SerializedFields.Of(field.FieldType).Select(part => $"{field.Name}.{part.Name}"));
}
