using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Host.Tests;

public sealed class DestroyTests : EngineFixture
{
    [Test]
    public void Destroy_InUpdate_TakesEffectAfterLateUpdate()
    {
        Play();
        var item = new GameObject("a");
        item.AddComponent<Actor>().OnUpdate = actor => Object.Destroy(actor.gameObject);
        item.AddComponent<Talker>();
        Diary.Clear();
        Steps(2);
        Assert.That(Diary.Text, Is.EqualTo("a.Start a.Update a.LateUpdate a.OnDisable a.OnDestroy"));
        Assert.That(item == null);
    }

    [Test]
    public void Destroy_BetweenFrames_LeavesTheObjectUntilTheNextFrameBegins()
    {
        Play();
        var item = new GameObject("a", typeof(Talker));
        Object.Destroy(item);
        Assert.That(item != null);
        Diary.Clear();
        Steps(1);
        Assert.That(Diary.Text, Is.EqualTo("a.OnDisable a.OnDestroy"));
    }

    [Test]
    public void Destroy_WithDelay_WaitsForGameTime()
    {
        Play(0.25f);
        var item = new GameObject("a");
        Object.Destroy(item, 0.5f);
        Steps(1);
        Assert.That(item != null);
        Steps(1);
        Assert.That(item == null);
    }

    [Test]
    public void Destroyed_Object_EqualsNullAndIsFalse()
    {
        var item = new GameObject("a");
        Object alias = item;
        Object.DestroyImmediate(item);
        Assert.That(item == null && !item && alias == null && item.Equals(null));
        Assert.That(item != null, Is.False);
        Assert.That(item.ToString(), Is.EqualTo("null"));
        Assert.That(ReferenceEquals(item, null), Is.False);
    }

    [Test]
    public void Destroyed_Object_RefusesUse()
    {
        var item = new GameObject("a");
        var behaviour = item.AddComponent<Actor>();
        Transform transform = item.transform;
        Object.DestroyImmediate(item);
        Assert.Throws<MissingReferenceException>(() => _ = item.name);
        Assert.Throws<MissingReferenceException>(() => _ = behaviour.transform);
        Assert.Throws<MissingReferenceException>(() => _ = transform.position);
        Assert.Throws<MissingReferenceException>(() => item.GetComponent<Actor>());
        Assert.Throws<MissingReferenceException>(() => behaviour.StartCoroutine("Any"));
    }

    [Test]
    public void Objects_OfTheSameKind_AreEqualOnlyToThemselves()
    {
        GameObject one = new("a"), two = new("a");
        Assert.That(one == two, Is.False);
        Assert.That(one.GetInstanceID(), Is.Not.EqualTo(two.GetInstanceID()));
        Assert.That(one.GetHashCode(), Is.EqualTo(one.GetInstanceID()));
    }

    [Test]
    public void Parent_Destroyed_TakesChildrenAlong()
    {
        Play();
        var parent = new GameObject("p", typeof(Talker));
        var child = new GameObject("c", typeof(Talker));
        child.transform.SetParent(parent.transform);
        Diary.Clear();
        Object.DestroyImmediate(parent);
        Assert.That(Diary.Text, Is.EqualTo("c.OnDisable p.OnDisable p.OnDestroy c.OnDestroy"));
        Assert.That(child == null);
        Assert.That(Object.FindObjectsByType<Talker>(FindObjectsSortMode.None), Is.Empty);
    }

    [Test]
    public void Component_Destroyed_LeavesTheObject()
    {
        var item = new GameObject("a");
        var actor = item.AddComponent<Actor>();
        Object.DestroyImmediate(actor);
        Assert.That(item.GetComponent<Actor>() == null);
        Assert.That(item != null);
    }

    [Test]
    public void NeverAwake_Behaviour_IsNotToldOfItsEnd()
    {
        Play();
        GameObject item = Asleep("a");
        item.AddComponent<Talker>();
        Diary.Clear();
        Object.DestroyImmediate(item);
        Assert.That(Diary.Text, Is.Empty);
    }

    [Test]
    public void RequiredComponent_Destroy_IsRefusedByName()
    {
        var item = new GameObject("a");
        item.AddComponent<Demanding>();
        Object.DestroyImmediate(item.GetComponent<MeshFilter>());
        Assert.That(item.GetComponent<MeshFilter>() != null);
        Assert.That(Errors[0], Is.EqualTo("Can't remove MeshFilter because Demanding (Script) depends on it"));
    }

    [Test]
    public void Transform_Destroy_IsRefused()
    {
        var item = new GameObject("a");
        Object.DestroyImmediate(item.transform);
        Assert.That(item.transform != null);
        Assert.That(Errors[0], Does.StartWith("Can't destroy Transform component of 'a'"));
    }

    [Test]
    public void Destroy_InEditMode_IsRefused()
    {
        var item = new GameObject("a");
        Object.Destroy(item);
        Steps(1);
        Assert.That(item != null);
        Assert.That(Errors[0], Does.StartWith("Destroy may not be called from edit mode!"));
    }

    [Test]
    public void Asset_DestroyImmediate_NeedsPermission()
    {
        var asset = ScriptableObject.CreateInstance<Settings>();
        asset.AssetPath = "Assets/Settings.asset";
        Object.DestroyImmediate(asset);
        Assert.That(asset != null);
        Assert.That(Errors[0], Does.StartWith("Destroying assets is not permitted"));
        Object.DestroyImmediate(asset, true);
        Assert.That(asset == null);
    }

    [Test]
    public void Null_Destroyed_DoesNothing()
    {
        Play();
        Object.Destroy(null);
        Object.DestroyImmediate(null);
        Assert.That(Errors, Is.Empty);
    }

    sealed class Settings : ScriptableObject
    {
    }
}
