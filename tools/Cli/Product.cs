using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using Glint.Editor;
using Glint.Host;
using UnityEngine;

namespace Glint.Cli;

/// <summary>Runs the product's commands and those of the headless host.</summary>
sealed class Product
{
    readonly Terminal _terminal;
    readonly List<string> _report = [];

    public Product(Terminal terminal)
    {
        _terminal = terminal;
        Commands.Info.Handler = (line, _) => new InfoReport(terminal).Write(line);
        Commands.Completion.Handler = (line, _) =>
        {
            terminal.Out.Write(new CompletionScript(line.Input).Write());
            return 0;
        };
        Commands.Bench.Handler = (line, progress) => Report(new BenchCommand(terminal).Execute(line, progress));
        Commands.Experiments.Handler =
            (line, progress) => Report(new ExperimentsCommand(terminal).Execute(line, progress));
        Commands.Verify.Handler = (line, progress) =>
        {
            var (report, exitCode) = new VerifyCommand(terminal).Execute(line, progress);
            return Report(report, exitCode);
        };
    }

    /// <summary>Executes a command line, in its Unity project where the command needs one.</summary>
    /// <returns>The exit code.</returns>
    public int Execute(CommandLine line)
    {
        if (!line.Command.NeedsProject)
            return Batch.Execute(line, null);
        using var cancellation = new Cancellation(_terminal);
        return Execute(line, cancellation);
    }

    /// <inheritdoc cref="Execute(CommandLine)"/>
    internal int Execute(CommandLine line, Cancellation cancellation)
    {
        LogSink.Writer = (type, message) => _terminal.Report(Labelled(type, message));
        Engine.DeviceSelector = line.Get(Options.Device);
        if (line.Command.Options.Contains(Options.Device))
            GraphicsDevice.BeginOpening();
        Project.Open(ProjectFolder.For(line.Input));
        int Work(IProgressSink progress) =>
            line.Command == Commands.Ppi ? TurnScreen(line, progress) : Batch.Execute(line, progress);
        int exitCode = _terminal.Live == null
            ? Work(new ProgressLines(_terminal.Out, _terminal.Error, cancellation, TimeProvider.System))
            : ProgressBar.During(_terminal, cancellation, Work);
        // Work that was complete when it was asked to stop has its result.
        if (exitCode == Batch.Cancelled)
            throw new OperationCanceledException();
        // Written after the progress bars, which would be redrawn below every line.
        foreach (string text in _report)
            _terminal.Out.WriteLine(text);
        return exitCode;
    }

    // Unity has profilers for the time on the device.
    int TurnScreen(CommandLine line, IProgressSink progress)
    {
        var clock = GraphicsDevice.IsNull ? null : GraphicsDevice.Current.Clock;
        if (clock is not { IsSupported: true })
            return Batch.Execute(line, progress);
        clock.IsOn = true;
        clock.Reset();
        try
        {
            int exitCode = Batch.Execute(line, progress);
            return exitCode != 0 ? exitCode
                : Report([FormattableString.Invariant($"kernels on the device: {clock.Read():0.0} ms in all")]);
        }
        finally
        {
            clock.IsOn = false;
        }
    }

    int Report(string[] lines, int exitCode = 0)
    {
        _report.AddRange(lines);
        return exitCode;
    }

    // The log carries messages; results come through the progress sink.
    static string Labelled(LogType type, string message) => type switch
    {
        LogType.Log => message,
        LogType.Warning => "warning: " + message,
        _ => "error: " + message
    };
}
