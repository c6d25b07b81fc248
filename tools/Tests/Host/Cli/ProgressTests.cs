using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Threading;
using Glint.Cli;
using NUnit.Framework;
using Spectre.Console;
using UnityEngine;

namespace Glint.Host.Tests;

public sealed class ProgressTests
{
    [Test]
    public void Lines_OfQuickSteps_ComeEveryFewSecondsAndAtTheEnd()
    {
        var (output, messages, clock) = (new StringWriter(), new StringWriter(), new StoppedClock());
        using var cancellation = new Cancellation(Quiet(messages));
        var progress = new ProgressLines(output, messages, cancellation, clock);

        progress.Start("sweep", 100);
        for (int done = 1; done <= 100; done++)
        {
            clock.Seconds += 0.25;
            progress.Print($"row {done}");
            progress.Advance(done, $"{done} deg");
        }
        progress.Finish();

        Assert.That(Lines(messages), Is.EqualTo(new[]
        {
            "sweep: 20 of 100, about 20 s left (20 deg)",
            "sweep: 40 of 100, about 15 s left (40 deg)",
            "sweep: 60 of 100, about 10 s left (60 deg)",
            "sweep: 80 of 100, about 5 s left (80 deg)",
            "sweep: 100 of 100 in 25 s (100 deg)"
        }));
        Assert.That(Lines(output).Length, Is.EqualTo(100));
    }

    /// <summary>Slurm and systemd send SIGTERM, a terminal that is closed SIGHUP.</summary>
    [TestCase("TERM")]
    [TestCase("HUP")]
    [Platform("Linux")]
    public void Signal_StopsTheWorkAsCtrlCDoes(string signal)
    {
        var messages = new StringWriter();
        using var cancellation = new Cancellation(Quiet(messages));
        using (var sender = Process.Start("/bin/sh", ["-c", $"kill -{signal} {Environment.ProcessId}"]))
            sender.WaitForExit();
        if (IsIgnored(signal))
        {
            Assert.That(cancellation.IsRequested, Is.False, "under nohup a run goes on");
            return;
        }
        Assert.That(() => cancellation.IsRequested, Is.True.After(5000, 10));
        Assert.That(Lines(messages), Is.EqualTo(new[] { "stopping; send the signal again to end immediately" }));
    }

    // By those that started the tests.
    static bool IsIgnored(string signal)
    {
        string mask = File.ReadLines("/proc/self/status").Single(line => line.StartsWith("SigIgn:"))[7..];
        return (Convert.ToUInt64(mask.Trim(), 16) >> (signal == "HUP" ? 0 : 14) & 1) != 0;
    }

    [Test]
    public void Lines_WithinALongStep_ComeAfterTwoSecondsAndThenEveryFive()
    {
        var (messages, clock) = (new StringWriter(), new StoppedClock());
        using var cancellation = new Cancellation(Quiet(messages));
        var progress = new ProgressLines(TextWriter.Null, messages, cancellation, clock);

        progress.Start("sweep", 2);
        for (int part = 1; part <= 20; part++)
        {
            clock.Seconds += 0.5;
            progress.Report(part / 20.0);
        }
        progress.Advance(1, null);
        clock.Seconds += 1.5;
        progress.Report(0.9);
        clock.Seconds += 0.5;
        progress.Report(0.95);

        Assert.That(Lines(messages), Is.EqualTo(new[]
        {
            "sweep: 0 of 2, the next 20 % done",
            "sweep: 0 of 2, the next 70 % done",
            "sweep: 1 of 2, the next 95 % done"
        }));
    }

    [Test]
    public void Lines_WithinTheOnlyStep_CountNone()
    {
        var (messages, clock) = (new StringWriter(), new StoppedClock());
        using var cancellation = new Cancellation(Quiet(messages));
        var progress = new ProgressLines(TextWriter.Null, messages, cancellation, clock);

        progress.Start("plate", 1);
        clock.Seconds += 3;
        progress.Report(0.5);

        Assert.That(Lines(messages), Is.EqualTo(new[] { "plate: 50 % done" }));
    }

    /// <summary>90 steps are left at 10 s each; the 900 steps done before took none of the 100 s.</summary>
    [Test]
    public void TimeLeft_OfAResumedSweep_IsByTheStepsSinceTheStart()
    {
        var (messages, clock) = (new StringWriter(), new StoppedClock());
        using var cancellation = new Cancellation(Quiet(messages));
        var progress = new ProgressLines(TextWriter.Null, messages, cancellation, clock);

        progress.Start("sweep", 1000, 900);
        clock.Seconds += 100;
        progress.Advance(910, null);

        Assert.That(Lines(messages), Is.EqualTo(new[] { "sweep: 910 of 1000, about 15 min left" }));
    }

    /// <summary>One step took 20 ms or more, so that 99 take 2 s or more; by all 901 it would be 2 ms.</summary>
    [Test]
    public void TimeLeft_InUnitysConsole_IsByTheStepsSinceTheStart()
    {
        string line = null;
        void Listen(string text, string stack, LogType type) => line = text;
        Application.logMessageReceived += Listen;
        try
        {
            var progress = new LogProgress();
            progress.Start("sweep", 1000, 900);
            Thread.Sleep(20);
            progress.Advance(901, null);
        }
        finally
        {
            Application.logMessageReceived -= Listen;
        }
        Assert.That(line, Does.Match("^Glint sweep: 901 of 1000, [1-9][0-9]* s left$"));
    }

    [Test]
    public void Bar_OnATerminalOfItsOwn_LeavesResultsBare()
    {
        var (output, screen) = (new StringWriter(), new StringWriter());
        var terminal =
            new Terminal { Out = output, Error = screen, Live = Ansi(screen), SharesScreen = false, Width = 100 };
        using var cancellation = new Cancellation(terminal);

        int code = ProgressBar.During(terminal, cancellation, progress =>
        {
            progress.Start("[sweep]", 2);
            progress.Report(0.5);
            progress.Print("row 1");
            progress.Advance(1, "0 deg");
            progress.Print("row 2");
            progress.Advance(2, null);
            progress.Finish();
            return 7;
        });

        Assert.That(code, Is.EqualTo(7));
        Assert.That(Lines(output), Is.EqualTo(new[] { "row 1", "row 2" }));
        Assert.That(screen.ToString(), Does.Contain("[sweep]").And.Contain("100%"));
    }

    [Test]
    public void Bar_WhenTheWorkFails_PassesTheFailureOn()
    {
        var screen = new StringWriter();
        var terminal = new Terminal
        {
            Out = TextWriter.Null, Error = screen, Live = Ansi(screen), SharesScreen = false, Width = 100
        };
        using var cancellation = new Cancellation(terminal);

        Assert.Throws<InvalidDataException>(
            () => ProgressBar.During(terminal, cancellation, _ => throw new InvalidDataException()));
    }

    [Test]
    public void Cancellation_SecondPress_ShowsTheCursorAndEndsTheProcess()
    {
        const string show = "\u001b[?25h";
        var screen = new StringWriter();
        using var cancellation = new Cancellation(new Terminal
        {
            Out = TextWriter.Null, Error = screen, Live = Ansi(screen), SharesScreen = true, Width = 100
        });

        Assert.That(cancellation.Press(), Is.True);
        Assert.That(cancellation.IsRequested && cancellation.Token.IsCancellationRequested);
        Assert.That(screen.ToString(), Does.Contain("press Ctrl-C again to end immediately").And.Not.Contain(show));
        Assert.That(cancellation.Press(), Is.False);
        Assert.That(screen.ToString(), Does.EndWith(show));
    }

    static IAnsiConsole Ansi(TextWriter screen)
    {
        var console = AnsiConsole.Create(new AnsiConsoleSettings
        {
            Ansi = AnsiSupport.Yes, Interactive = InteractionSupport.Yes, Out = new AnsiConsoleOutput(screen)
        });
        console.Profile.Width = 100;
        return console;
    }

    static Terminal Quiet(TextWriter messages) =>
        new() { Out = TextWriter.Null, Error = messages, Live = null, Width = 100 };

    static string[] Lines(StringWriter text) =>
        text.ToString().Split(Environment.NewLine, StringSplitOptions.RemoveEmptyEntries).ToArray();

    sealed class StoppedClock : TimeProvider
    {
        public double Seconds { get; set; }

        public override long TimestampFrequency => 1000;

        public override long GetTimestamp() => (long)Math.Round(Seconds * 1000);
    }
}
