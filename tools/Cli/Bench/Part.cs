using System;

namespace Glint.Cli;

/// <summary>Progress of one of several equal parts of a step. Any thread may report.</summary>
sealed class Part(IProgress<double> whole, int done, int count) : IProgress<double>
{
    public void Report(double value)
    {
        lock (whole)
            whole.Report((done + value) / count);
    }
}
