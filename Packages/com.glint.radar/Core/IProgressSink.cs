using System;
using System.Threading;

namespace Glint.Core
{
    /// <summary>
    /// Progress of a command. The terminal draws a bar; Unity's batch mode writes lines to the log. Report takes the
    /// completed fraction of the current step, 0 to 1.
    /// </summary>
    public interface IProgressSink : IProgress<double>
    {
        /// <summary>Requests a stop: finished steps are kept and the current step is abandoned.</summary>
        CancellationToken Cancel { get; }

        /// <summary>
        /// Work of <paramref name="total"/> steps begins, of which <paramref name="done"/> were done before.
        /// </summary>
        void Start(string what, int total, int done = 0);

        /// <summary>
        /// Reports the number of finished steps; <paramref name="note"/> describes the last one in a few words (may be
        /// null).
        /// </summary>
        void Advance(int done, string note);

        /// <summary>The work has ended, complete or not.</summary>
        void Finish();

        /// <summary>A line of the command's result: standard output, not the message stream.</summary>
        void Print(string line);
    }
}
