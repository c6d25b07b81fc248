using System;
using System.IO;
using System.Linq;
using Glint.Host;

namespace UnityEngine;

/// <summary>
/// The host presents itself as the editor in batch mode, for the product compiled with the editor's symbols, or as a
/// player on a desktop (<see cref="Engine.IsPlayer"/>).
/// </summary>
public class Application
{
    static readonly StackTraceLogType[] _stackTraces =
        Enumerable.Repeat(StackTraceLogType.ScriptOnly, Enum.GetValues<LogType>().Length).ToArray();

    public delegate void LogCallback(string condition, string stackTrace, LogType type);

    public static event LogCallback logMessageReceived;

    public static event LogCallback logMessageReceivedThreaded;

    public static event Func<bool> wantsToQuit;

    public static event Action quitting;

    public static bool isPlaying => Engine.IsPlaying;

    public static bool isEditor => !Engine.IsPlayer;

    public static bool isBatchMode => !Engine.IsPlayer;

    public static bool isFocused => true;

    public static bool runInBackground { get; set; } = true;

    public static int targetFrameRate { get; set; } = -1;

    public static string unityVersion => ProjectVersion.Unity;

    public static string productName => ProjectVersion.Product;

    public static string companyName => ProjectVersion.Company;

    public static string version => ProjectVersion.Version;

    public static string dataPath => Engine.IsPlayer
        ? Path.Combine(AppContext.BaseDirectory, productName + "_Data")
        : Path.Combine(ProjectVersion.Root, "Assets");

    public static string streamingAssetsPath => Path.Combine(dataPath, "StreamingAssets");

    public static string persistentDataPath => Folder(
        Environment.GetFolderPath(Environment.SpecialFolder.ApplicationData, Environment.SpecialFolderOption.Create));

    public static string temporaryCachePath => Folder(Path.GetTempPath());

    public static RuntimePlatform platform =>
        OperatingSystem.IsWindows() ? isEditor ? RuntimePlatform.WindowsEditor : RuntimePlatform.WindowsPlayer
        : OperatingSystem.IsMacOS() ? isEditor ? RuntimePlatform.OSXEditor : RuntimePlatform.OSXPlayer
        : isEditor ? RuntimePlatform.LinuxEditor : RuntimePlatform.LinuxPlayer;

    public static StackTraceLogType GetStackTraceLogType(LogType logType) => _stackTraces[(int)logType];

    /// <summary>Of no effect on the host's log, which has no stack traces but those of exceptions.</summary>
    public static void SetStackTraceLogType(LogType logType, StackTraceLogType stackTraceType) =>
        _stackTraces[(int)logType] = stackTraceType;

    public static void Quit() => Quit(0);

    /// <summary>Takes effect only in play mode; the host ends the loop.</summary>
    public static void Quit(int exitCode)
    {
        if (!isPlaying)
            return;
        bool willing = wantsToQuit is null
            || wantsToQuit.GetInvocationList().Cast<Func<bool>>().All(question => question());
        if (willing)
            Engine.QuitCode = exitCode;
    }

    public static bool IsPlaying(Object obj) =>
        isPlaying && !Object.IsNull(obj) && (obj as GameObject ?? (obj as Component)?.Owner) is not { SceneData: null };

    internal static void RaiseQuitting() => quitting?.Invoke();

    internal static void RaiseLog(string message, string stackTrace, LogType type)
    {
        logMessageReceived?.Invoke(message, stackTrace, type);
        logMessageReceivedThreaded?.Invoke(message, stackTrace, type);
    }

    static string Folder(string parent) => Path.Combine(parent, companyName, productName);
}
