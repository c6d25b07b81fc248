using System;
using System.Runtime.InteropServices;
using System.Threading;

namespace Glint.Cli;

/// <summary>
/// Handles Ctrl-C and the signals by which systems end a process, SIGTERM and SIGHUP: the first stops the work, the second
/// ends the process.
/// </summary>
sealed class Cancellation : IDisposable
{
    readonly Terminal _terminal;
    readonly CancellationTokenSource _source = new();
    readonly PosixSignalRegistration[] _signals;

    public Cancellation(Terminal terminal)
    {
        _terminal = terminal;
        Console.CancelKeyPress += OnCancel;
        _signals =
        [
            PosixSignalRegistration.Create(PosixSignal.SIGTERM, OnSignal),
            PosixSignalRegistration.Create(PosixSignal.SIGHUP, OnSignal)
        ];
    }

    public bool IsRequested => _source.IsCancellationRequested;

    /// <summary>Cancelled by the first Ctrl-C or signal.</summary>
    public CancellationToken Token => _source.Token;

    public void Dispose()
    {
        Console.CancelKeyPress -= OnCancel;
        foreach (var signal in _signals)
            signal.Dispose();
        _source.Dispose();
    }

    void OnCancel(object sender, ConsoleCancelEventArgs press) => press.Cancel = Press();

    void OnSignal(PosixSignalContext context) => context.Cancel = Press("send the signal again");

    /// <summary>Handles Ctrl-C or a signal; returns true if the process continues.</summary>
    /// <param name="again">What ends it.</param>
    internal bool Press(string again = "press Ctrl-C again")
    {
        if (IsRequested)
        {
            // The progress bar hid the cursor and will not restore it.
            _terminal.Live?.Cursor.Show(true);
            return false;
        }
        _terminal.Report($"stopping; {again} to end immediately");
        _source.Cancel();
        return true;
    }
}
