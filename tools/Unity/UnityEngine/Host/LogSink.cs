using System;
using UnityEngine;

namespace Glint.Host;

/// <summary>
/// Where log messages are written: the console, warnings and worse to its error stream, or elsewhere.
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
