using System;
using System.Threading;

namespace Glint.Cli;

/// <summary>Ctrl-C: the first asks the work to stop, the second ends the process.</summary>
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

    /// <summary>Cancelled by the first.</summary>
    public CancellationToken Token => _source.Token;

    public void Dispose()
    {
        Console.CancelKeyPress -= OnCancel;
        _source.Dispose();
    }

    void OnCancel(object sender, ConsoleCancelEventArgs press) => press.Cancel = Press();

    /// <summary>Ctrl-C was pressed; returns whether the process goes on.</summary>
    internal bool Press()
    {
        if (IsRequested)
        {
            // The bar hid it and will not come to its end.
            _terminal.Live?.Cursor.Show(true);
            return false;
        }
        _terminal.Report("stopping; Ctrl-C again ends at once");
        _source.Cancel();
        return true;
    }
}
