using System;
using System.Diagnostics;
using Glint.Host;

namespace UnityEngine;

public class Debug
{
    const string Assertions = "UNITY_ASSERTIONS";

    public static ILogger unityLogger { get; } = new Logger(new LogHandler());

    public static bool isDebugBuild => true;

    public static void Log(object message) => unityLogger.Log(LogType.Log, message);

    public static void Log(object message, Object context) => unityLogger.Log(LogType.Log, message, context);

    public static void LogFormat(string format, params object[] args) =>
        unityLogger.LogFormat(LogType.Log, format, args);

    public static void LogFormat(Object context, string format, params object[] args) =>
        unityLogger.LogFormat(LogType.Log, context, format, args);

    public static void LogFormat(
        LogType logType, LogOption logOptions, Object context, string format, params object[] args) =>
        unityLogger.LogFormat(logType, context, format, args);

    public static void LogWarning(object message) => unityLogger.Log(LogType.Warning, message);

    public static void LogWarning(object message, Object context) => unityLogger.Log(LogType.Warning, message, context);

    public static void LogWarningFormat(string format, params object[] args) =>
        unityLogger.LogFormat(LogType.Warning, format, args);

    public static void LogWarningFormat(Object context, string format, params object[] args) =>
        unityLogger.LogFormat(LogType.Warning, context, format, args);

    public static void LogError(object message) => unityLogger.Log(LogType.Error, message);

    public static void LogError(object message, Object context) => unityLogger.Log(LogType.Error, message, context);

    public static void LogErrorFormat(string format, params object[] args) =>
        unityLogger.LogFormat(LogType.Error, format, args);

    public static void LogErrorFormat(Object context, string format, params object[] args) =>
        unityLogger.LogFormat(LogType.Error, context, format, args);

    public static void LogException(Exception exception) => unityLogger.LogException(exception, null);

    public static void LogException(Exception exception, Object context) =>
        unityLogger.LogException(exception, context);

    [Conditional(Assertions)]
    public static void Assert(bool condition) => Assert(condition, (object)"Assertion failed", null);

    [Conditional(Assertions)]
    public static void Assert(bool condition, Object context) => Assert(condition, (object)"Assertion failed", context);

    [Conditional(Assertions)]
    public static void Assert(bool condition, object message) => Assert(condition, message, null);

    [Conditional(Assertions)]
    public static void Assert(bool condition, string message) => Assert(condition, (object)message, null);

    [Conditional(Assertions)]
    public static void Assert(bool condition, string message, Object context) =>
        Assert(condition, (object)message, context);

    [Conditional(Assertions)]
    public static void Assert(bool condition, object message, Object context)
    {
        if (!condition)
            unityLogger.Log(LogType.Assert, message, context);
    }

    [Conditional(Assertions)]
    public static void LogAssertion(object message) => unityLogger.Log(LogType.Assert, message);

    [Conditional(Assertions)]
    public static void LogAssertion(object message, Object context) =>
        unityLogger.Log(LogType.Assert, message, context);

    public static void DrawLine(Vector3 start, Vector3 end)
    {
    }

    public static void DrawLine(Vector3 start, Vector3 end, Color color)
    {
    }

    public static void DrawLine(Vector3 start, Vector3 end, Color color, float duration)
    {
    }

    public static void DrawLine(Vector3 start, Vector3 end, Color color, float duration, bool depthTest)
    {
    }

    public static void DrawRay(Vector3 start, Vector3 dir)
    {
    }

    public static void DrawRay(Vector3 start, Vector3 dir, Color color)
    {
    }

    public static void DrawRay(Vector3 start, Vector3 dir, Color color, float duration)
    {
    }

    public static void DrawRay(Vector3 start, Vector3 dir, Color color, float duration, bool depthTest)
    {
    }
}
