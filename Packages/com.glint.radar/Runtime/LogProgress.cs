using System;
using System.Diagnostics;
using Glint.Core;
using UnityEngine;
using Debug = UnityEngine.Debug;

namespace Glint
{
    /// <summary>Progress as lines of Unity's console: at the first step, every two seconds, and at the last.</summary>
    public sealed class LogProgress : IProgressSink
    {
        const double SecondsBetweenLines = 2;

        readonly Stopwatch _sinceStart = new Stopwatch();
        string _what;
        int _total;
        double _lastLine;

        public bool IsCancelled => false;

        public void Start(string what, int total)
        {
            (_what, _total) = (what, total);
            _sinceStart.Restart();
            _lastLine = double.NegativeInfinity;
        }

        public void Advance(int done, string note)
        {
            double now = _sinceStart.Elapsed.TotalSeconds;
            if (done < _total && now - _lastLine < SecondsBetweenLines)
                return;
            _lastLine = now;
            double left = now / done * (_total - done);
            string rest = done < _total ? FormattableString.Invariant($", {left:0} s left") : FormattableString.Invariant($" in {now:0.0} s");
            Debug.Log($"Glint {_what}: {done} of {_total}{(note == null ? "" : $" ({note})")}{rest}");
        }

        public void Finish() { }

        public void Print(string line) => Debug.Log(line);
    }
}
