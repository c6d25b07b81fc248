using System;
using System.Collections;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace Glint.Host;

/// <summary>The engine as driven by the host: its project, play mode, and one frame at a time.</summary>
public static class Engine
{
    /// <summary>The open project; null without one.</summary>
    public static IAssetSource Assets { get; set; }

    /// <summary>The Vulkan device to open: null for the preferred one, else its index or a part of its name.</summary>
    public static string DeviceSelector { get; set; }

    /// <summary>Whether the host is a player build, which has a screen, instead of the editor in batch mode.</summary>
    public static bool IsPlayer { get; private set; }

    public static bool IsPlaying { get; private set; }

    /// <summary>Exit code of Application.Quit in play mode; null until it is called.</summary>
    public static int? QuitCode { get; internal set; }

    /// <summary>Play mode requested or ending; it takes effect between two frames.</summary>
    internal static bool? PlayModeRequest { get; set; }

    /// <summary>Raised at the start of every frame.</summary>
    internal static event Action FrameBegins;

    internal static event Action<PlayModeStep> PlayModeChanged;

    /// <summary>Begins as a player does: with the first scene of the build settings.</summary>
    public static void StartPlayer()
    {
        if (SceneLoads.BuildScenes.Count == 0)
            throw new UnityException("ProjectSettings/EditorBuildSettings.asset enables no scene: a player needs one");
        IsPlayer = true;
        EnterPlayMode();
        SceneLoads.Load(SceneLoads.BuildScenes[0], LoadSceneMode.Single);
    }

    /// <summary>
    /// Whether Play reloads the scenes, a setting of Unity's editor. Else scripts that ran in edit mode are not started
    /// again.
    /// </summary>
    internal static bool ReloadsScenes { get; set; } = true;

    /// <summary>Reloads the open scenes as play mode does and wakes them.</summary>
    public static void EnterPlayMode()
    {
        if (IsPlaying)
            return;
        PlayModeChanged?.Invoke(PlayModeStep.ExitingEditMode);
        IsPlaying = true;
        QuitCode = null;
        Clock.Restart();
        RuntimeInitializers.Run(RuntimeInitializeLoadType.SubsystemRegistration);
        RuntimeInitializers.Run(RuntimeInitializeLoadType.AfterAssembliesLoaded);
        RuntimeInitializers.Run(RuntimeInitializeLoadType.BeforeSplashScreen);
        RuntimeInitializers.Run(RuntimeInitializeLoadType.BeforeSceneLoad);
        SceneRegistry.Reload();
        RuntimeInitializers.Run(RuntimeInitializeLoadType.AfterSceneLoad);
        PlayModeChanged?.Invoke(PlayModeStep.EnteredPlayMode);
    }

    /// <summary>Sends OnApplicationQuit, destroys all objects and restores the scenes of edit mode.</summary>
    public static void ExitPlayMode()
    {
        if (!IsPlaying)
            return;
        PlayModeChanged?.Invoke(PlayModeStep.ExitingPlayMode);
        PlayerLoop.Send("OnApplicationQuit");
        Application.RaiseQuitting();
        SceneRegistry.DestroyAll();
        Coroutines.Clear();
        Destruction.Clear();
        SceneLoads.Clear();
        IsPlaying = false;
        SceneRegistry.RestoreEditMode();
        PlayModeChanged?.Invoke(PlayModeStep.EnteredEditMode);
    }

    /// <summary>Runs one frame, in Unity's order.</summary>
    public static void Step()
    {
        FollowRequest();
        Clock.Advance();
        FrameBegins?.Invoke();
        SceneLoads.Complete();
        Destruction.Flush();
        PlayerLoop.StartPending();
        while (Clock.NextFixedStep())
        {
            PlayerLoop.Send("FixedUpdate");
            PlayerLoop.StartPending();
            Coroutines.Resume(ResumePoint.FixedUpdate);
        }
        PlayerLoop.Send("Update");
        PlayerLoop.StartPending();
        Coroutines.Resume(ResumePoint.Update);
        PlayerLoop.Send("LateUpdate");
        Destruction.Flush();
        ScreenText.Clear();
        if (IsPlayer)
            PlayerLoop.Send("OnGUI");
        Coroutines.Resume(ResumePoint.EndOfFrame);
        FollowRequest();
    }

    /// <summary>Leaves play mode, closes all scenes, and opens one untitled scene. The open project is kept.</summary>
    public static void Reset()
    {
        ExitPlayMode();
        SceneRegistry.Clear();
        ReloadsScenes = true;
        QuitCode = null;
        PlayModeRequest = null;
    }

    /// <summary>
    /// Runs a host routine beside those of the behaviours, for example a play-mode test. It resumes after Update like
    /// any other. Call Step until it is done; its exception is stored instead of logged.
    /// </summary>
    internal static Coroutine StartCoroutine(IEnumerator routine) => Coroutines.Start(null, routine, null);

    static void FollowRequest()
    {
        bool? play = PlayModeRequest;
        PlayModeRequest = null;
        if (play == true)
            EnterPlayMode();
        else if (play == false)
            ExitPlayMode();
    }
}
