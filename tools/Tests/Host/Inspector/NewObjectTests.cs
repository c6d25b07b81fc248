using Glint.Editor;
using Glint.Reference;
using NUnit.Framework;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;

namespace Glint.Host.Tests;

/// <summary>Where the menu GameObject > Glint puts what it makes, and what Undo does with it.</summary>
public sealed class NewObjectTests
{
    static readonly Vector3 Pivot = new(30f, 4f, -7f);

    [SetUp]
    public void BeginEmpty()
    {
        EditorSceneManager.NewScene(NewSceneSetup.EmptyScene, NewSceneMode.Single);
        Undo.ClearAll();
        EditorHooks.ScenePivot = Pivot;
    }

    [TearDown]
    public void LeaveAnEmptyScene()
    {
        EditorHooks.ScenePivot = Vector3.zero;
        EditorUtility.ClearDefaultParentObject();
        Selection.activeGameObject = null;
        Undo.ClearAll();
        EditorSceneManager.NewScene(NewSceneSetup.EmptyScene, NewSceneMode.Single);
    }

    [Test]
    public void Object_WithoutAParent_IsWhereTheSceneViewLooks()
    {
        Assert.That(SceneObjects.MakeCornerReflector(null).transform.position, Is.EqualTo(Pivot));
        Vector3 water = new(Pivot.x, 0f, Pivot.z);
        Assert.That(SceneObjects.MakeSea(null).transform.position, Is.EqualTo(water));
        Assert.That(SceneObjects.MakeShip(null).transform.position, Is.EqualTo(water));
        LooksAt(SceneObjects.MakeRadar(null), Pivot);
    }

    [Test]
    public void Object_WithADefaultParent_IsBelowIt()
    {
        var parent = new GameObject("Parent") { layer = 3 };
        (parent.transform.position, parent.transform.localScale) = (new Vector3(5f, 6f, 7f), 2 * Vector3.one);
        EditorUtility.SetDefaultParentObject(parent);
        GameObject reflector = SceneObjects.MakeCornerReflector(null);
        Assert.That((reflector.transform.parent, reflector.transform.GetChild(0).gameObject.layer),
            Is.EqualTo((parent.transform, 3)));
        RadarController radar = SceneObjects.MakeRadar(null);
        Assert.That(radar.transform.parent, Is.SameAs(parent.transform));
        LooksAt(radar, parent.transform.position);
    }

    // One step: the object and its selection.
    [Test]
    public void Undo_OfANewObject_RestoresTheSelectionToo()
    {
        var before = new GameObject("Before");
        Selection.activeGameObject = before;
        Undo.IncrementCurrentGroup();
        GameObject made = SceneObjects.MakeCornerReflector(null);
        Assert.That(Selection.activeGameObject, Is.SameAs(made));
        Undo.PerformUndo();
        Assert.That((made == null, Selection.activeGameObject), Is.EqualTo((true, before)));
    }

    static void LooksAt(RadarController radar, Vector3 centre) =>
        Near.Point(radar.transform.position + (float)CornerReflector.Distance * radar.transform.forward,
            centre.x, centre.y, centre.z, 1e-4);
}
