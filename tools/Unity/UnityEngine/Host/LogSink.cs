using System;
using UnityEngine;

namespace Glint.Host;

/// <summary>
/// Destination of log messages: the console, with warnings and errors on its error stream, or another.
/// </summary>
public static class LogSink
{
    public static Action<LogType, string> Writer { get; set; } = ToConsole;

    public static void ToConsole(LogType type, string message)
    {
        if (type == LogType.Log)
            Console.Out.WriteLine(message);
        else
            Console.Error.WriteLine(message);
    }

    internal static void Write(LogType type, string message) => Writer(type, message);
}
