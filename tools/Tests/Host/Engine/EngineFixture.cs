using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Host.Tests;

/// <summary>Each test begins in edit mode with one empty scene. The log is recorded instead of printed.</summary>
public abstract class EngineFixture
{
    IAssetSource _openProject;
    Action<LogType, string> _logWriter;

    protected List<(LogType Type, string Message)> Log { get; } = new();

    protected string[] Errors =>
        Log.Where(entry => entry.Type != LogType.Log).Select(entry => entry.Message).ToArray();

    [SetUp]
    public void BeginEmpty()
    {
        _openProject = Engine.Assets;
        Engine.Assets = null;
        Engine.Reset();
        Log.Clear();
        _logWriter = LogSink.Writer;
        LogSink.Writer = (type, message) => Log.Add((type, message));
        Diary.Entries.Clear();
    }

    [TearDown]
    public void EndEmpty()
    {
        Engine.Reset();
        Engine.Assets = _openProject;
        Time.captureDeltaTime = 0f;
        Time.timeScale = 1f;
        Time.fixedDeltaTime = 0.02f;
        LogSink.Writer = _logWriter;
    }

    /// <summary>For tests that need the assets of the project.</summary>
    protected void UseProject() => Engine.Assets = _openProject;

    /// <summary>Frames of exactly the given length, so that times are predictable.</summary>
    protected static void Play(float frameSeconds = 0.25f)
    {
        Time.captureDeltaTime = frameSeconds;
        Engine.EnterPlayMode();
    }

    protected static void Steps(int count)
    {
        for (int i = 0; i < count; i++)
            Engine.Step();
    }

    /// <summary>An inactive object, for components whose fields are set before Awake.</summary>
    protected static GameObject Asleep(string name)
    {
        var item = new GameObject(name);
        item.SetActive(false);
        return item;
    }
}

/// <summary>Events in order.</summary>
internal static class Diary
{
    internal static List<string> Entries { get; } = new();

    internal static void Write(MonoBehaviour who, string what) => Entries.Add($"{who.name}.{what}");

    internal static void Clear() => Entries.Clear();

    internal static string Text => string.Join(" ", Entries);
}
