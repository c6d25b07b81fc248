using System;
using System.Threading;
using Glint.Core;
using Spectre.Console;

namespace Glint.Cli;

/// <summary>Progress on a terminal: a bar with the remaining time, redrawn below the result lines.</summary>
sealed class ProgressBar : IProgressSink
{
    readonly ProgressContext _bars;
    readonly Action<string> _print;
    readonly Cancellation _cancellation;
    ProgressTask _bar;
    string _what;
    int _done;

    ProgressBar(ProgressContext bars, Action<string> print, Cancellation cancellation)
    {
        _bars = bars;
        _print = print;
        _cancellation = cancellation;
    }

    public CancellationToken Cancel => _cancellation.Token;

    /// <summary>Runs the work with a progress bar, which is removed at the end.</summary>
    public static int During(Terminal terminal, Cancellation cancellation, Func<IProgressSink, int> work)
    {
        // On a shared terminal a result line must go above the bar; a file gets the plain line.
        Action<string> print = terminal.SharesScreen ? line => terminal.Live.WriteLine(line) : terminal.Out.WriteLine;
        return terminal.Live.Progress().AutoClear(true)
            .Columns(new TaskDescriptionColumn(), new ProgressBarColumn(), new PercentageColumn(),
                new ElapsedTimeColumn(), new RemainingTimeColumn())
            .Start(bars => work(new ProgressBar(bars, print, cancellation)));
    }

    public void Start(string what, int total, int done = 0)
    {
        _what = what;
        _done = done;
        _bar = _bars.AddTask(Markup.Escape(what), maxValue: total);
        _bar.Value = done;
    }

    public void Report(double value) => _bar.Value = _done + Math.Clamp(value, 0, 1);

    public void Advance(int done, string note)
    {
        _done = done;
        _bar.Value = done;
        _bar.Description = Markup.Escape(note == null ? _what : $"{_what}: {note}");
    }

    public void Finish() => _bar?.StopTask();

    public void Print(string line) => _print(line);
}
