using System;
using System.Diagnostics;
using System.Threading;
using Glint.Core;
using Debug = UnityEngine.Debug;

namespace Glint
{
    /// <summary>
    /// Progress as lines of Unity's console: at the first step, every two seconds (also within a long step), and at the
    /// last.
    /// </summary>
    public sealed class LogProgress : IProgressSink
    {
        const double SecondsBetweenLines = 2;

        readonly Stopwatch _sinceStart = new Stopwatch();
        string _what;
        int _total, _before, _done;
        double _stepStart, _lastLine;

        /// <inheritdoc/>
        public CancellationToken Cancel => CancellationToken.None;

        /// <inheritdoc/>
        public void Start(string what, int total, int done = 0)
        {
            (_what, _total, _before, _done) = (what, total, done, done);
            _sinceStart.Restart();
            _stepStart = 0;
            _lastLine = double.NegativeInfinity;
        }

        /// <inheritdoc/>
        public void Report(double value)
        {
            double now = _sinceStart.Elapsed.TotalSeconds;
            if (now - Math.Max(_stepStart, _lastLine) < SecondsBetweenLines)
                return;
            _lastLine = now;
            Debug.Log(
                FormattableString.Invariant($"Glint {_what}: {_done} of {_total}, the next {100 * value:0} % done"));
        }

        /// <inheritdoc/>
        public void Advance(int done, string note)
        {
            double now = _sinceStart.Elapsed.TotalSeconds;
            (_done, _stepStart) = (done, now);
            if (done < _total && now - _lastLine < SecondsBetweenLines)
                return;
            _lastLine = now;
            double left = now / (done - _before) * (_total - done);
            string rest = done < _total
                ? FormattableString.Invariant($", {left:0} s left")
                : FormattableString.Invariant($" in {now:0.0} s");
            Debug.Log($"Glint {_what}: {done} of {_total}{(note == null ? "" : $" ({note})")}{rest}");
        }

        /// <inheritdoc/>
        public void Finish() { }

        /// <inheritdoc/>
        public void Print(string line) => Debug.Log(line);
    }
}
