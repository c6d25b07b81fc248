using System;
using Glint.Host;

namespace UnityEditor;

public enum PlayModeStateChange
{
    EnteredEditMode,
    ExitingEditMode,
    EnteredPlayMode,
    ExitingPlayMode,
}

public sealed class EditorApplication
{
    public delegate void CallbackFunction();

    public static CallbackFunction update;
    public static CallbackFunction delayCall;

    static EditorApplication()
    {
        Engine.FrameBegins += Tick;
        Engine.PlayModeChanged += step => playModeStateChanged?.Invoke((PlayModeStateChange)(int)step);
    }

    public static event Action<PlayModeStateChange> playModeStateChanged;

    public static event Action quitting;

    /// <summary>Setting it takes effect between two frames.</summary>
    public static bool isPlaying
    {
        get => Engine.IsPlaying;
        set => Engine.PlayModeRequest = value;
    }

    public static bool isPlayingOrWillChangePlaymode => Engine.PlayModeRequest ?? Engine.IsPlaying;

    public static bool isCompiling => false;

    public static bool isUpdating => false;

    public static double timeSinceStartup => Clock.SinceStartup;

    public static void EnterPlaymode() => isPlaying = true;

    public static void ExitPlaymode() => isPlaying = false;

    public static void QueuePlayerLoopUpdate()
    {
    }

    /// <summary>Ends the process, unless the host replaces the action.</summary>
    public static void Exit(int returnValue)
    {
        quitting?.Invoke();
        EditorHooks.Exit(returnValue);
    }

    static void Tick()
    {
        CallbackFunction calls = delayCall;
        delayCall = null;
        calls?.Invoke();
        update?.Invoke();
    }
}
