using System;

namespace Glint.Cli;

/// <summary>Ctrl-C: the first asks the work to stop after the pose in hand, the second ends the process.</summary>
sealed class Cancellation : IDisposable
{
    readonly Terminal _terminal;
    volatile bool _isRequested;

    public Cancellation(Terminal terminal)
    {
        _terminal = terminal;
        Console.CancelKeyPress += OnCancel;
    }

    public bool IsRequested => _isRequested;

    public void Dispose() => Console.CancelKeyPress -= OnCancel;

    void OnCancel(object sender, ConsoleCancelEventArgs press) => press.Cancel = Press();

    /// <summary>Ctrl-C was pressed; returns whether the process goes on.</summary>
    internal bool Press()
    {
        if (_isRequested)
        {
            // The bar hid it and will not come to its end.
            _terminal.Live?.Cursor.Show(true);
            return false;
        }
        _isRequested = true;
        _terminal.Tell("stopping after the pose in hand; Ctrl-C again ends at once");
        return true;
    }
}
