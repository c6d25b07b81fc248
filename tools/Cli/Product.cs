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
        LogSink.Writer = (type, message) => terminal.Report(Labelled(type, message));
        using var cancellation = new Cancellation(terminal);
        Project.Open(ProjectFolder.For(line.Input));
        Engine.DeviceSelector = line.Get(Options.Device);
        string[] report = [];
        int Work(IProgressSink progress)
        {
            if (line.Command == Commands.Verify)
            {
                (report, int code) = new VerifyCommand(terminal).Execute(line, progress);
                return code;
            }
            if (line.Command == Commands.Experiments)
            {
                report = new ExperimentsCommand(terminal).Execute(line, progress);
                return 0;
            }
            if (line.Command != Commands.Bench)
                return Batch.Execute(line, progress);
            report = new BenchCommand(terminal).Execute(line, progress);
            return 0;
        }

        int exitCode = terminal.Live == null
            ? Work(new ProgressLines(terminal.Out, terminal.Error, cancellation, TimeProvider.System))
            : ProgressBar.During(terminal, cancellation, Work);
        if (cancellation.IsRequested)
            throw new OperationCanceledException();
        // In one piece when the bars are gone: they would be drawn anew below every line.
        foreach (string text in report)
            terminal.Out.WriteLine(text);
        return exitCode;
    }

    // The log is for messages; results come through the progress sink.
    static string Labelled(LogType type, string message) => type switch
    {
        LogType.Log => message,
        LogType.Warning => "warning: " + message,
        _ => "error: " + message
    };
}
