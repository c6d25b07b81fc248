using System;
using System.Threading;

namespace Glint.Cli;

/// <summary>Handles Ctrl-C: the first stops the work, the second ends the process.</summary>
sealed class Cancellation : IDisposable
{
    readonly Terminal _terminal;
    readonly CancellationTokenSource _source = new();

    public Cancellation(Terminal terminal)
    {
        _terminal = terminal;
        Console.CancelKeyPress += OnCancel;
    }

    public bool IsRequested => _source.IsCancellationRequested;

    /// <summary>Cancelled by the first Ctrl-C.</summary>
    public CancellationToken Token => _source.Token;

    public void Dispose()
    {
        Console.CancelKeyPress -= OnCancel;
        _source.Dispose();
    }

    void OnCancel(object sender, ConsoleCancelEventArgs press) => press.Cancel = Press();

    /// <summary>Handles Ctrl-C; returns true if the process continues.</summary>
    internal bool Press()
    {
        if (IsRequested)
        {
            // The progress bar hid the cursor and will not restore it.
            _terminal.Live?.Cursor.Show(true);
            return false;
        }
        _terminal.Report("stopping; press Ctrl-C again to end immediately");
        _source.Cancel();
        return true;
    }
}
