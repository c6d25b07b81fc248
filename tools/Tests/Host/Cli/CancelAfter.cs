using System.Threading;
using Glint.Core;

namespace Glint.Host.Tests;

/// <summary>Cancels a command when it has done some rows.</summary>
sealed class CancelAfter(int rows) : IProgressSink
{
    readonly CancellationTokenSource _source = new();

    public CancellationToken Cancel => _source.Token;

    /// <summary>Rows that the command found done.</summary>
    public int Before { get; private set; }

    public void Start(string what, int total, int done = 0) => Before = done;

    public void Report(double value) { }

    public void Advance(int done, string note)
    {
        if (done == rows)
            _source.Cancel();
    }

    public void Finish() { }

    public void Print(string line) { }
}
