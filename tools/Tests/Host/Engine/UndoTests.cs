using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Glint.Host.Tests;

public sealed class UndoTests : EngineFixture
{
    [SetUp]
    public void Forget() => Undo.ClearAll();

    [Test]
    public void PerformUndo_TakesBackTheLatestGroupOnly()
    {
        var first = new GameObject("First");
        Undo.RegisterCreatedObjectUndo(first, "Make");
        Undo.IncrementCurrentGroup();
        Undo.RecordObject(first.transform, "Move");
        first.transform.position = Vector3.one;
        Undo.RecordObject(first, "Rename");
        first.name = "Renamed";

        Undo.PerformUndo();
        Assert.That((first.transform.position, first.name), Is.EqualTo((Vector3.zero, "First")));
        Undo.PerformUndo();
        Assert.That(first == null);
        Undo.PerformUndo(); // nothing to undo
    }

    [Test]
    public void CollapseUndoOperations_MakesOneStepOfLaterGroups()
    {
        var item = new GameObject("Item");
        Undo.IncrementCurrentGroup();
        int group = Undo.GetCurrentGroup();
        Undo.AddComponent<Camera>(item);
        Undo.IncrementCurrentGroup();
        Undo.RecordObject(item, "Switch off");
        item.SetActive(false);
        Undo.CollapseUndoOperations(group);

        Undo.PerformUndo();
        Assert.That(item.activeInHierarchy);
        Assert.That(item.GetComponent<Camera>() == null);
    }

    [Test]
    public void RecordObject_MarksTheSceneChanged()
    {
        var item = new GameObject("Item");
        Assert.That(item.scene.isDirty, Is.False);
        Undo.RecordObject(item, "Rename");
        Assert.That(item.scene.isDirty);
    }
}
