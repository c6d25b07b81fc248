using System;
using Glint.Core;
using Glint.Editor;
using Glint.Host;
using UnityEngine;

namespace Glint.Cli;

/// <summary>Opens the Unity project in the headless host and runs a command of the product in it.</summary>
static class Product
{
    public static int Execute(CommandLine line, Terminal terminal)
    {
        LogSink.Writer = (type, message) => terminal.Tell(Labelled(type, message));
        using var cancellation = new Cancellation(terminal);
        Project.Open(ProjectFolder.For(line.Input));
        Engine.DeviceSelector = line.Get(Options.Device);
        int exitCode = terminal.Live == null
            ? Batch.Execute(line, new ProgressLines(terminal.Out, terminal.Error, cancellation, TimeProvider.System))
            : ProgressBar.During(terminal, cancellation, progress => Batch.Execute(line, progress));
        return cancellation.IsRequested ? throw new OperationCanceledException() : exitCode;
    }

    // The log is for messages; results come through the progress sink.
    static string Labelled(LogType type, string message) => type switch
    {
        LogType.Log => message,
        LogType.Warning => "warning: " + message,
        _ => "error: " + message
    };
}
