using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Host.Tests;

public sealed class ComponentTests : EngineFixture
{
    GameObject _root, _child, _sleeper;

    [SetUp]
    public void BuildHierarchy()
    {
        _root = new GameObject("root", typeof(Camera));
        _child = new GameObject("child", typeof(Actor), typeof(Talker));
        _child.transform.SetParent(_root.transform);
        _sleeper = Asleep("sleeper");
        _sleeper.AddComponent<Actor>();
        _sleeper.transform.SetParent(_child.transform);
    }

    [Test]
    public void GetComponent_ByTypeBaseOrInterface_FindsTheFirst()
    {
        Assert.That(_child.GetComponent<MonoBehaviour>(), Is.InstanceOf<Actor>());
        Assert.That(_child.GetComponent(typeof(Talker)), Is.InstanceOf<Talker>());
        Assert.That(_child.GetComponent<System.Collections.IEnumerable>(), Is.SameAs(_child.transform));
        Assert.That(_child.GetComponent<Camera>(), Is.Null);
        Assert.That(_child.TryGetComponent(out Actor actor) && actor != null);
        Assert.That(_child.TryGetComponent<Camera>(out _), Is.False);
    }

    [Test]
    public void GetComponentsInChildren_LeavesOutInactiveObjectsUnlessAsked()
    {
        Assert.That(_root.GetComponentsInChildren<Actor>().Length, Is.EqualTo(1));
        Assert.That(_root.GetComponentsInChildren<Actor>(true).Length, Is.EqualTo(2));
        Assert.That(_sleeper.GetComponentInChildren<Actor>(), Is.Null);
        var found = new List<Transform> { null };
        _root.GetComponentsInChildren(true, found);
        Assert.That(found, Is.EqualTo(new[] { _root.transform, _child.transform, _sleeper.transform }));
    }

    [Test]
    public void GetComponentInParent_StartsWithTheObjectItself()
    {
        Assert.That(_child.GetComponentInParent<Camera>(), Is.SameAs(_root.GetComponent<Camera>()));
        Assert.That(_child.GetComponentInParent<Actor>(), Is.SameAs(_child.GetComponent<Actor>()));
        Assert.That(_sleeper.GetComponentsInParent<Actor>(true).Length, Is.EqualTo(2));
        Assert.That(_sleeper.GetComponentInParent<Actor>(), Is.SameAs(_child.GetComponent<Actor>()));
    }

    [Test]
    public void AddComponent_BringsWhatItRequires()
    {
        var item = new GameObject("a");
        item.AddComponent<Demanding>();
        Assert.That(item.GetComponent<MeshFilter>() != null && item.GetComponent<Actor>() != null);
        Assert.That(item.GetComponentCount(), Is.EqualTo(4));
        Assert.That(item.GetComponentIndex(item.GetComponent<Demanding>()), Is.EqualTo(3));
    }

    [Test]
    public void AddComponent_OfASingleKindTwice_IsRefusedByName()
    {
        var item = new GameObject("a", typeof(Demanding));
        Assert.That(item.AddComponent<Demanding>() == null);
        Assert.That(item.AddComponent<MeshFilter>() == null);
        Assert.That(Errors[0],
            Is.EqualTo("Can't add 'Demanding' to a because a 'Demanding' is already added to the game object!"));
        Assert.That(item.AddComponent<Actor>() != null, "an ordinary one may be there twice");
    }

    [Test]
    public void Tag_Undefined_IsRefused()
    {
        Assert.Throws<UnityException>(() => _root.tag = "no such tag");
        Assert.Throws<UnityException>(() => _root.CompareTag("no such tag"));
        _root.tag = "MainCamera";
        Assert.That(_root.GetComponent<Camera>().CompareTag("MainCamera"));
        Assert.That(GameObject.FindWithTag("MainCamera"), Is.SameAs(_root));
        Assert.That(Camera.main, Is.SameAs(_root.GetComponent<Camera>()));
    }

    [Test]
    public void Layer_OutOfRange_IsRefused()
    {
        _root.layer = 31;
        _root.layer = 32;
        Assert.That(_root.layer, Is.EqualTo(31));
        Assert.That(Errors.Length, Is.EqualTo(1));
    }

    [Test]
    public void Find_ByNameOrPath_SeesActiveObjectsOnly()
    {
        Assert.That(GameObject.Find("child"), Is.SameAs(_child));
        Assert.That(GameObject.Find("/root/child"), Is.SameAs(_child));
        Assert.That(GameObject.Find("root/child"), Is.SameAs(_child));
        Assert.That(GameObject.Find("/child"), Is.Null);
        Assert.That(GameObject.Find("sleeper"), Is.Null);
    }

    [Test]
    public void FindObjectsByType_SortsAndFiltersAsAsked()
    {
        Assert.That(Object.FindObjectsByType<Actor>(FindObjectsSortMode.None).Length, Is.EqualTo(1));
        Actor[] all = Object.FindObjectsByType<Actor>(FindObjectsInactive.Include, FindObjectsSortMode.InstanceID);
        Assert.That(all.Length, Is.EqualTo(2));
        Assert.That(all[0].GetInstanceID(), Is.LessThan(all[1].GetInstanceID()));
        Assert.That(Object.FindAnyObjectByType<Camera>(), Is.SameAs(_root.GetComponent<Camera>()));
        Assert.That(Object.FindFirstObjectByType<SkinnedMeshRenderer>(), Is.Null);
        _root.GetComponent<Camera>().hideFlags = HideFlags.DontSave;
        Assert.That(Object.FindAnyObjectByType<Camera>(), Is.Null, "what is not saved is not found");
        Assert.That(Resources.FindObjectsOfTypeAll<Camera>(), Has.Member(_root.GetComponent<Camera>()));
    }
}
