using System.Collections.Generic;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Glint.Host.Tests;

public sealed class EditorTests : EngineFixture
{
    [Test]
    public void Exit_IsLeftToTheHost()
    {
        var exit = EditorHooks.Exit;
        int? code = null;
        EditorHooks.Exit = value => code = value;
        EditorApplication.Exit(2);
        EditorHooks.Exit = exit;
        Assert.That(code, Is.EqualTo(2));
    }

    [Test]
    public void PlayMode_AskedForByTheEditor_BeginsBetweenFramesAndIsAnnounced()
    {
        var changes = new List<PlayModeStateChange>();
        EditorApplication.playModeStateChanged += changes.Add;
        EditorApplication.isPlaying = true;
        Assert.That(EditorApplication.isPlaying, Is.False);
        Assert.That(EditorApplication.isPlayingOrWillChangePlaymode);
        Steps(1);
        Assert.That(Application.isPlaying);
        EditorApplication.ExitPlaymode();
        Steps(1);
        EditorApplication.playModeStateChanged -= changes.Add;
        Assert.That(changes, Is.EqualTo(new[]
        {
            PlayModeStateChange.ExitingEditMode, PlayModeStateChange.EnteredPlayMode,
            PlayModeStateChange.ExitingPlayMode, PlayModeStateChange.EnteredEditMode,
        }));
    }

    [Test]
    public void DelayCall_RunsOnceUpdateEveryFrame()
    {
        int delayed = 0, updates = 0;
        EditorApplication.CallbackFunction update = () => updates++;
        EditorApplication.update += update;
        EditorApplication.delayCall += () => delayed++;
        Steps(3);
        EditorApplication.update -= update;
        Assert.That((delayed, updates), Is.EqualTo((1, 3)));
    }

    [Test]
    public void AssetDatabase_AnswersFromTheProject()
    {
        var asset = ScriptableObject.CreateInstance<Preset>();
        var project = new FakeProject();
        project.Assets["Assets/P.asset"] = asset;
        Engine.Assets = project;
        Assert.That(AssetDatabase.LoadAssetAtPath<Preset>("Assets/P.asset"), Is.SameAs(asset));
        Assert.That(AssetDatabase.GetAssetPath(asset), Is.EqualTo("Assets/P.asset"));
        Assert.That(AssetDatabase.GUIDToAssetPath(AssetDatabase.AssetPathToGUID("Assets/P.asset")),
            Is.EqualTo("Assets/P.asset"));
        Assert.That(AssetDatabase.LoadAssetAtPath<Mesh>("Assets/P.asset"), Is.Null);
        Assert.That(AssetDatabase.LoadAssetAtPath<Preset>("Assets/No.asset"), Is.Null);
        Assert.That(FileUtil.GetPhysicalPath("Assets/P.asset"), Is.EqualTo("/project/Assets/P.asset"));
    }

    [Test]
    public void InitializeOnLoad_TypesAndMethods_RunAtStartup()
    {
        EditorStartup.Run();
        Assert.That(OnLoad.Constructed && OnLoad.Called);
    }

    [Test]
    public void Quit_InPlayMode_IsRecordedUnlessSomebodyObjects()
    {
        Application.Quit(3);
        Assert.That(Engine.QuitCode, Is.Null, "edit mode");
        Play();
        System.Func<bool> objection = () => false;
        Application.wantsToQuit += objection;
        Application.Quit(3);
        Application.wantsToQuit -= objection;
        Assert.That(Engine.QuitCode, Is.Null);
        Application.Quit(3);
        Assert.That(Engine.QuitCode, Is.EqualTo(3));
    }

    sealed class Preset : ScriptableObject
    {
    }

    [InitializeOnLoad]
    static class OnLoad
    {
        static OnLoad() => Constructed = true;

        internal static bool Constructed { get; }
        internal static bool Called { get; private set; }

        [InitializeOnLoadMethod]
        static void Call() => Called = true;
    }
}
