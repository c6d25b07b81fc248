using System;
using System.Collections;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Glint.Host.Tests;

/// <summary>Frames last 0.25 s. The diary records the frame and the phase in which a routine continues.</summary>
public sealed class CoroutineTests : EngineFixture
{
    Actor _actor;

    [SetUp]
    public void BeginPlaying()
    {
        Play(0.25f);
        _actor = new GameObject("a").AddComponent<Actor>();
        Steps(1);
        _actor.OnUpdate = _ => Note("Update");
        _actor.OnLateUpdate = _ => Note("LateUpdate");
    }

    [Test]
    public void Coroutine_Started_RunsToItsFirstYieldAtOnce()
    {
        _actor.StartCoroutine(After(null));
        Assert.That(Diary.Text, Is.EqualTo("1:begin"));
    }

    [Test]
    public void YieldNull_GoesOnInTheNextFrameBetweenUpdateAndLateUpdate()
    {
        _actor.StartCoroutine(After(null));
        Steps(1);
        Assert.That(Diary.Text, Is.EqualTo("1:begin 2:Update 2:end 2:LateUpdate"));
    }

    [Test]
    public void YieldNull_InStart_GoesOnInTheNextFrame()
    {
        new GameObject("b").AddComponent<StartRoutine>();
        Steps(1);
        Assert.That(Diary.Text, Is.EqualTo("2:Start 2:Update 2:LateUpdate"));
        Steps(1);
        Assert.That(Diary.Entries, Has.Member("3:Started"));
    }

    [TestCase(0.5f, 3)]
    [TestCase(0.6f, 4)]
    [TestCase(0f, 2)]
    public void WaitForSeconds_GoesOnInTheFirstFrameThatLate(float seconds, int frame)
    {
        _actor.StartCoroutine(After(new WaitForSeconds(seconds)));
        Steps(5);
        Assert.That(Diary.Entries, Has.Member(frame + ":end"));
    }

    [Test]
    public void WaitForSeconds_FollowsTimeScale()
    {
        Time.timeScale = 0.5f;
        _actor.StartCoroutine(After(new WaitForSeconds(0.5f)));
        Steps(5);
        Assert.That(Diary.Entries, Has.Member("5:end"));
    }

    [Test]
    public void WaitForSecondsRealtime_IgnoresTimeScale()
    {
        Time.timeScale = 0f;
        double begin = Time.realtimeSinceStartupAsDouble;
        _actor.StartCoroutine(After(new WaitForSecondsRealtime(0.02f)));
        while (!Diary.Text.Contains("end") && Time.realtimeSinceStartupAsDouble < begin + 5.0)
            Engine.Step();
        Assert.That(Time.realtimeSinceStartupAsDouble - begin, Is.InRange(0.02, 5.0));
    }

    [Test]
    public void WaitForEndOfFrame_GoesOnAfterLateUpdateOfTheSameFrame()
    {
        _actor.OnUpdate = actor =>
        {
            actor.OnUpdate = null;
            actor.StartCoroutine(After(new WaitForEndOfFrame()));
        };
        Steps(1);
        Assert.That(Diary.Text, Is.EqualTo("2:begin 2:LateUpdate 2:end"));
    }

    [Test]
    public void WaitForFixedUpdate_GoesOnBeforeUpdate()
    {
        _actor.StartCoroutine(After(new WaitForFixedUpdate()));
        Steps(1);
        Assert.That(Diary.Text, Is.EqualTo("1:begin 2:end 2:Update 2:LateUpdate"));
    }

    [Test]
    public void WaitUntil_GoesOnWhenTheConditionHolds()
    {
        bool ready = false;
        _actor.StartCoroutine(After(new WaitUntil(() => ready)));
        Steps(2);
        Assert.That(Diary.Text, Does.Not.Contain("end"));
        ready = true;
        Steps(1);
        Assert.That(Diary.Entries, Has.Member("4:end"));
    }

    [Test]
    public void WaitWhile_ConditionAlreadyGone_GoesOnAtOnce()
    {
        _actor.StartCoroutine(After(new WaitWhile(() => false)));
        Assert.That(Diary.Text, Is.EqualTo("1:begin 1:end"));
    }

    [Test]
    public void NestedEnumerator_RunsWithinTheOuterOne()
    {
        _actor.StartCoroutine(After(Frames(2)));
        Steps(3);
        Assert.That(Diary.Text, Does.StartWith("1:begin 1:frame 2:Update 2:frame 2:LateUpdate 3:Update 3:end"));
    }

    [Test]
    public void NestedCoroutine_Finished_OuterGoesOnInTheSameFrame()
    {
        _actor.StartCoroutine(After(_actor.StartCoroutine(Frames(2))));
        Steps(2);
        Assert.That(Diary.Text, Does.EndWith("3:Update 3:end 3:LateUpdate"));
    }

    [Test]
    public void AsyncOperation_GoesOnOnceItIsDone()
    {
        var operation = new AsyncOperation();
        _actor.StartCoroutine(After(operation));
        Steps(1);
        Assert.That(Diary.Text, Does.Not.Contain("end"));
        operation.Finish();
        Steps(1);
        Assert.That(Diary.Entries, Has.Member("3:end"));
    }

    [Test]
    public void StopCoroutine_ByCoroutineRoutineOrName_Stops()
    {
        IEnumerator routine = After(null);
        Coroutine byRoutine = _actor.StartCoroutine(routine);
        Coroutine byHandle = _actor.StartCoroutine(After(null));
        var named = _actor.gameObject.AddComponent<NamedRoutine>();
        named.StartCoroutine("Count", 3);
        _actor.StopCoroutine(routine);
        _actor.StopCoroutine(byHandle);
        named.StopCoroutine("Count");
        Steps(2);
        Assert.That(byRoutine.IsDone && byHandle.IsDone);
        Assert.That(Diary.Text, Does.Not.Contain("end"));
        Assert.That(named.Counted, Is.EqualTo(3));
    }

    [Test]
    public void Coroutine_ObjectDeactivated_IsGoneForGood()
    {
        _actor.StartCoroutine(After(null));
        _actor.gameObject.SetActive(false);
        _actor.gameObject.SetActive(true);
        Steps(2);
        Assert.That(Diary.Text, Does.Not.Contain("end"));
    }

    [Test]
    public void Coroutine_BehaviourDisabled_GoesOn()
    {
        _actor.StartCoroutine(After(null));
        _actor.enabled = false;
        Steps(1);
        Assert.That(Diary.Entries, Has.Member("2:end"));
    }

    [Test]
    public void Coroutine_ObjectDestroyed_IsStopped()
    {
        _actor.StartCoroutine(After(new WaitForSeconds(1f)));
        Object.Destroy(_actor.gameObject);
        Steps(6);
        Assert.That(Diary.Text, Does.Not.Contain("end"));
        Assert.That(Errors, Is.Empty);
    }

    [Test]
    public void Coroutine_OnInactiveObject_IsRefusedWithAnError()
    {
        _actor.gameObject.SetActive(false);
        Assert.That(_actor.StartCoroutine(After(null)), Is.Null);
        Assert.That(Errors[0], Does.Contain("'a' is inactive"));
    }

    [Test]
    public void Coroutine_Throwing_IsLoggedAndEndsAlone()
    {
        _actor.StartCoroutine(Throwing());
        _actor.StartCoroutine(After(null));
        Steps(1);
        Assert.That(Errors[0], Does.StartWith("InvalidOperationException: broken"));
        Assert.That(Diary.Entries, Has.Member("2:end"));
    }

    [Test]
    public void HostRoutine_KeepsItsExceptionInsteadOfLoggingIt()
    {
        Coroutine routine = Engine.StartCoroutine(Throwing());
        Steps(1);
        Assert.That(routine.IsDone);
        Assert.That(routine.Error, Is.InstanceOf<InvalidOperationException>());
        Assert.That(Errors, Is.Empty);
    }

    static void Note(string what) => Diary.Entries.Add($"{Time.frameCount}:{what}");

    static IEnumerator After(object wait)
    {
        Note("begin");
        yield return wait;
        Note("end");
    }

    static IEnumerator Frames(int count)
    {
        for (int i = 0; i < count; i++)
        {
            Note("frame");
            yield return null;
        }
    }

    static IEnumerator Throwing()
    {
        yield return null;
        throw new InvalidOperationException("broken");
    }

    sealed class StartRoutine : MonoBehaviour
    {
        IEnumerator Start()
        {
            Note("Start");
            yield return null;
            Note("Started");
        }
    }

    sealed class NamedRoutine : MonoBehaviour
    {
        internal int Counted;

        IEnumerator Count(int step)
        {
            while (true)
            {
                Counted += step;
                yield return null;
            }
        }
    }
}
