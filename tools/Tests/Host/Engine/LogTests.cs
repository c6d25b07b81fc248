using System;
using System.IO;
using NUnit.Framework;
using UnityEngine;

namespace Glint.Host.Tests;

public sealed class LogTests : EngineFixture
{
    [Test]
    public void Log_ReachesListenersAndTheSink()
    {
        string heard = null;
        Application.LogCallback listen = (message, _, type) => heard += $"{type}: {message};";
        Application.logMessageReceived += listen;
        Debug.Log("a");
        Debug.LogWarningFormat("{0:0.0}", 1.5);
        Debug.LogException(new ArgumentException("c"));
        Application.logMessageReceived -= listen;
        Assert.That(heard, Is.EqualTo("Log: a;Warning: 1.5;Exception: ArgumentException: c;"));
        Assert.That(Log.Count, Is.EqualTo(3));
    }

    [Test]
    public void Log_TextWithBraces_StaysAsItIs()
    {
        Debug.Log("{0} {");
        Assert.That(Log[0].Message, Is.EqualTo("{0} {"));
    }

    [Test]
    public void Console_GetsInformationOnItsOutputAndTheRestOnItsErrorStream()
    {
        TextWriter output = Console.Out, error = Console.Error;
        using StringWriter outText = new(), errorText = new();
        Console.SetOut(outText);
        Console.SetError(errorText);
        try
        {
            LogSink.ToConsole(LogType.Log, "note");
            LogSink.ToConsole(LogType.Warning, "careful");
            LogSink.ToConsole(LogType.Error, "broken");
        }
        finally
        {
            Console.SetOut(output);
            Console.SetError(error);
        }
        Assert.That(outText.ToString().Trim(), Is.EqualTo("note"));
        Assert.That(errorText.ToString().Split('\n', StringSplitOptions.TrimEntries)[..2],
            Is.EqualTo(new[] { "careful", "broken" }));
    }

    [Test]
    public void Logger_Filtered_LetsTheWorsePass()
    {
        var logger = new Logger(Debug.unityLogger.logHandler) { filterLogType = LogType.Warning };
        logger.Log("unheard");
        logger.LogWarning("tag", "heard");
        logger.LogError("tag", "heard too");
        Assert.That(Errors, Is.EqualTo(new[] { "tag: heard", "tag: heard too" }));
        Assert.That(Log.Count, Is.EqualTo(2));
    }
}
