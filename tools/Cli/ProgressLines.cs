using System;
using System.IO;
using System.Threading;
using Glint.Core;

namespace Glint.Cli;

/// <summary>Progress for logs and pipes: a line at intervals, also within a long step, and a last line.</summary>
sealed class ProgressLines(TextWriter output, TextWriter messages, Cancellation cancellation, TimeProvider clock)
    : IProgressSink
{
    static readonly TimeSpan Interval = TimeSpan.FromSeconds(5), LongStep = TimeSpan.FromSeconds(2);

    string _what;
    int _total, _before, _done;
    long _started, _stepStarted, _written;

    public CancellationToken Cancel => cancellation.Token;

    public void Start(string what, int total, int done = 0)
    {
        _what = what;
        _total = total;
        _before = _done = done;
        _started = _stepStarted = _written = clock.GetTimestamp();
    }

    public void Report(double value)
    {
        bool isFirstOfStep = _written <= _stepStarted;
        if (clock.GetElapsedTime(Math.Max(_written, _stepStarted)) < (isFirstOfStep ? LongStep : Interval))
            return;
        _written = clock.GetTimestamp();
        string step = _total > 1 ? $"{_done} of {_total}, the next " : "";
        messages.WriteLine(FormattableString.Invariant($"{_what}: {step}{100 * value:0} % done"));
    }

    public void Advance(int done, string note)
    {
        _done = done;
        _stepStarted = clock.GetTimestamp();
        if (done < _total && clock.GetElapsedTime(_written) < Interval)
            return;
        _written = _stepStarted;
        var elapsed = clock.GetElapsedTime(_started, _stepStarted);
        string left = done > _before && done < _total
            ? $", about {Text(elapsed * (_total - done) / (done - _before))} left"
            : $" in {Text(elapsed)}";
        messages.WriteLine($"{_what}: {done} of {_total}{left}{(note == null ? "" : $" ({note})")}");
    }

    public void Finish() => messages.Flush();

    public void Print(string line) => output.WriteLine(line);

    static string Text(TimeSpan time) => time.TotalMinutes < 1.5
        ? FormattableString.Invariant($"{time.TotalSeconds:0} s")
        : FormattableString.Invariant($"{time.TotalMinutes:0} min");
}
