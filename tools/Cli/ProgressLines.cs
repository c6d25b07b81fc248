using System;
using System.IO;
using Glint.Core;

namespace Glint.Cli;

/// <summary>Progress for logs and pipes: a line now and then, and the last.</summary>
sealed class ProgressLines(TextWriter output, TextWriter messages, Cancellation cancellation, TimeProvider clock) : IProgressSink
{
    static readonly TimeSpan Interval = TimeSpan.FromSeconds(5);

    string _what;
    int _total;
    long _started, _written;

    public bool IsCancelled => cancellation.IsRequested;

    public void Start(string what, int total)
    {
        _what = what;
        _total = total;
        _started = _written = clock.GetTimestamp();
    }

    public void Advance(int done, string note)
    {
        if (done < _total && clock.GetElapsedTime(_written) < Interval)
            return;
        _written = clock.GetTimestamp();
        var elapsed = clock.GetElapsedTime(_started);
        string left = done > 0 && done < _total ? $", about {Text(elapsed * (_total - done) / done)} left" : $" in {Text(elapsed)}";
        messages.WriteLine($"{_what}: {done} of {_total}{left}{(note == null ? "" : $" ({note})")}");
    }

    public void Finish() => messages.Flush();

    public void Print(string line) => output.WriteLine(line);

    static string Text(TimeSpan time) => time.TotalMinutes < 1.5
        ? FormattableString.Invariant($"{time.TotalSeconds:0} s")
        : FormattableString.Invariant($"{time.TotalMinutes:0} min");
}
