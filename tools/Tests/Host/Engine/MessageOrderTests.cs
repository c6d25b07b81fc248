using System;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Host.Tests;

public sealed class MessageOrderTests : EngineFixture
{
    [Test]
    public void Behaviour_AddedInPlayMode_WakesAtOnceAndStartsBeforeItsFirstUpdate()
    {
        Play();
        new GameObject("a").AddComponent<Talker>();
        Assert.That(Diary.Text, Is.EqualTo("a.OnValidate a.Awake a.OnEnable"));
        Diary.Clear();
        Steps(2);
        Assert.That(Diary.Text, Is.EqualTo("a.Start a.Update a.LateUpdate a.Update a.LateUpdate"));
    }

    [Test]
    public void Behaviour_OfDerivedType_HearsPrivateMessagesOfItsBase()
    {
        Play();
        new GameObject("a").AddComponent<QuietHeir>();
        Steps(1);
        Assert.That(Diary.Entries, Has.Member("a.Start").And.Member("a.Update"));
    }

    [Test]
    public void Behaviour_AddedDuringUpdate_StartsBeforeItsLateUpdateInThatFrame()
    {
        Play();
        bool done = false;
        new GameObject("maker").AddComponent<Actor>().OnUpdate = _ =>
        {
            if (!done)
                new GameObject("late").AddComponent<Talker>();
            done = true;
        };
        Steps(1);
        Assert.That(Diary.Text, Is.EqualTo("late.OnValidate late.Awake late.OnEnable late.Start late.LateUpdate"));
    }

    [Test]
    public void Behaviour_WithoutFrameMessagesAddedDuringUpdate_StartsInThatFrame()
    {
        Play();
        int startedIn = 0;
        new GameObject("maker").AddComponent<Actor>().OnUpdate = maker =>
        {
            maker.OnUpdate = null;
            new GameObject("late").AddComponent<OnlyStart>().Started = () => startedIn = Time.frameCount;
        };
        Steps(2);
        Assert.That(startedIn, Is.EqualTo(1));
    }

    [Test]
    public void Behaviours_OfDifferentOrder_RunByDefaultExecutionOrder()
    {
        Transform root = Asleep("root").transform;
        foreach (Type type in new[] { typeof(Latecomer), typeof(Talker), typeof(EarlyBird) })
            new GameObject(type.Name, type).transform.SetParent(root);
        Play();
        Diary.Clear();
        root.gameObject.SetActive(true);
        Assert.That(
            Diary.Text,
            Is.EqualTo("EarlyBird.Awake EarlyBird.OnEnable Talker.Awake Talker.OnEnable Latecomer.Awake "
                + "Latecomer.OnEnable"));
        Diary.Clear();
        Steps(1);
        Assert.That(
            Diary.Text,
            Is.EqualTo("EarlyBird.Start Talker.Start Latecomer.Start EarlyBird.Update Talker.Update "
                + "Latecomer.Update Talker.LateUpdate"));
    }

    [Test]
    public void Behaviour_OnInactiveObject_WakesOnlyWhenActivated()
    {
        Play();
        GameObject item = Asleep("a");
        item.AddComponent<Talker>();
        Steps(1);
        Assert.That(Diary.Text, Is.EqualTo("a.OnValidate"));
        item.SetActive(true);
        Assert.That(Diary.Text, Is.EqualTo("a.OnValidate a.Awake a.OnEnable"));
    }

    [Test]
    public void Behaviour_Disabled_IsAwakeButNeitherEnabledNorStarted()
    {
        Play();
        GameObject item = Asleep("a");
        var talker = item.AddComponent<Talker>();
        talker.enabled = false;
        Diary.Clear();
        item.SetActive(true);
        Steps(1);
        Assert.That(Diary.Text, Is.EqualTo("a.Awake"));
        talker.enabled = true;
        Steps(1);
        Assert.That(Diary.Text, Is.EqualTo("a.Awake a.OnEnable a.Start a.Update a.LateUpdate"));
    }

    [Test]
    public void SetParent_WhileTheParentIsDeactivated_IsRefusedWithUnitysMessage()
    {
        Play();
        var parent = new GameObject("p", typeof(Mover)).transform;
        var child = new GameObject("c").transform;
        child.SetParent(parent);
        parent.GetComponent<Mover>().Disabled = () => child.SetParent(null);
        parent.gameObject.SetActive(false);
        Assert.That(child.parent, Is.SameAs(parent));
        Assert.That(Errors, Is.EqualTo(new[] { "Cannot set the parent of the GameObject 'c' while activating or "
            + "deactivating the parent GameObject 'p'." }));
        child.SetParent(null);
        Assert.That(child.parent == null, "it has been deactivated");
    }

    [Test]
    public void Parent_Deactivated_DisablesChildrenAndBackAgain()
    {
        Play();
        var parent = new GameObject("p", typeof(Talker));
        var child = new GameObject("c", typeof(Talker));
        child.transform.SetParent(parent.transform);
        Diary.Clear();
        parent.SetActive(false);
        Assert.That(child.activeSelf && !child.activeInHierarchy);
        parent.SetActive(true);
        Assert.That(Diary.Text, Is.EqualTo("c.OnDisable p.OnDisable p.OnEnable c.OnEnable"));
    }

    [Test]
    public void Child_MovedUnderInactiveParent_IsDisabled()
    {
        Play();
        GameObject parent = Asleep("p");
        var child = new GameObject("c", typeof(Talker));
        Diary.Clear();
        child.transform.SetParent(parent.transform);
        Assert.That(Diary.Text, Is.EqualTo("c.OnDisable"));
    }

    [Test]
    public void Exception_InMessage_IsLoggedAndTheLoopGoesOn()
    {
        Play();
        new GameObject("bad").AddComponent<Actor>().OnUpdate = _ => throw new InvalidOperationException("no luck");
        new GameObject("good").AddComponent<Talker>();
        Steps(2);
        Assert.That(Errors.Length, Is.EqualTo(2));
        Assert.That(Log[0].Type, Is.EqualTo(LogType.Exception));
        Assert.That(Errors[0], Does.StartWith("InvalidOperationException: no luck"));
        Assert.That(Diary.Entries.FindAll(entry => entry == "good.Update").Count, Is.EqualTo(2));
    }

    [Test]
    public void Object_DestroyedByAnEarlierAwake_NeverWakes()
    {
        Transform root = Asleep("root").transform;
        var victim = new GameObject("victim");
        var killer = new GameObject("killer").AddComponent<Actor>();
        killer.transform.SetParent(root);
        victim.transform.SetParent(root);
        victim.AddComponent<Talker>();
        Play();
        Diary.Clear();
        killer.OnAwake = _ => Object.DestroyImmediate(victim);
        root.gameObject.SetActive(true);
        Assert.That(Diary.Text, Is.Empty);
    }

    [Test]
    public void PlayMode_Left_SendsQuitThenDisableThenDestroy()
    {
        Play();
        new GameObject("a").AddComponent<Talker>();
        Steps(1);
        Diary.Clear();
        Engine.ExitPlayMode();
        Assert.That(Diary.Text, Is.EqualTo("a.OnApplicationQuit a.OnDisable a.OnDestroy"));
        Assert.That(Application.isPlaying, Is.False);
    }

    [Test]
    public void PlayMode_Entered_WakesObjectsOfAnUnsavedScene()
    {
        new GameObject("a").AddComponent<Talker>();
        Diary.Clear();
        Play();
        Assert.That(Diary.Text, Is.EqualTo("a.OnValidate a.Awake a.OnEnable"));
    }

    [Test]
    public void EditMode_OrdinaryBehaviour_HearsOnlyOnValidateAndReset()
    {
        var item = new GameObject("a");
        item.AddComponent<Talker>();
        Steps(2);
        item.SetActive(false);
        item.SetActive(true);
        Object.DestroyImmediate(item);
        Assert.That(Diary.Text, Is.EqualTo("a.OnValidate a.Reset"));
    }

    [Test]
    public void EditMode_ExecuteAlwaysBehaviour_HearsItsMessages()
    {
        var item = new GameObject("a");
        item.AddComponent<EditTalker>();
        Object.DestroyImmediate(item);
        Assert.That(Diary.Text, Is.EqualTo("a.Awake a.OnEnable a.OnDisable a.OnDestroy"));
    }

    [Test]
    public void FixedUpdate_RunsAsOftenAsStepsFitIntoTheTime()
    {
        Play(0.25f);
        Time.fixedDeltaTime = 0.1f;
        int calls = 0;
        new GameObject("a").AddComponent<Actor>().OnFixedUpdate = _ =>
        {
            calls++;
            Assert.That(Time.deltaTime, Is.EqualTo(0.1f));
        };
        Steps(3);
        Assert.That(calls, Is.EqualTo(7), "0.75 s hold seven steps of 0.1 s");
        Assert.That(Errors, Is.Empty);
    }
}
