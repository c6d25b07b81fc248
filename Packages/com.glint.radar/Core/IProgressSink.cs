using System;
using System.Threading;

namespace Glint.Core
{
    /// <summary>
    /// What a command tells its host while it works. The terminal draws a bar,
    /// Unity's batch mode writes lines to the log.
    /// Reported numbers are the part of the step in hand that is done, 0 to 1.
    /// </summary>
    public interface IProgressSink : IProgress<double>
    {
        /// <summary>Asks to stop: what is done is kept, the step in hand is given up.</summary>
        CancellationToken Cancel { get; }

        /// <summary>Work of <paramref name="total"/> steps begins.</summary>
        void Start(string what, int total);

        /// <summary>
        /// So many of the steps are done; <paramref name="note"/> says in a few words what was last (may be null).
        /// </summary>
        void Advance(int done, string note);

        /// <summary>The work has ended, complete or not.</summary>
        void Finish();

        /// <summary>A line of the command's result: standard output, not the message stream.</summary>
        void Print(string line);
    }
}
