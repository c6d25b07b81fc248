using System;
using System.Threading;
using Glint.Core;
using UnityEditor;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>Unity's progress bar with a cancel button, there until disposed.</summary>
    sealed class CancelBar : IProgressSink, IDisposable
    {
        readonly CancellationTokenSource _source = new CancellationTokenSource();
        string _what;

        /// <param name="what">What is done, such as "Tracing 'Radar'".</param>
        public CancelBar(string what) => Start(what, 1);

        /// <summary>Asked for by the button.</summary>
        public CancellationToken Cancel => _source.Token;

        public void Start(string what, int total)
        {
            _what = what;
            Report(0);
        }

        /// <summary>So much is done, 0 to 1; looks whether the button was pressed.</summary>
        public void Report(double value)
        {
            if (EditorUtility.DisplayCancelableProgressBar("Glint", _what, (float)value))
                _source.Cancel();
        }

        public void Advance(int done, string note) { }

        public void Finish() => EditorUtility.ClearProgressBar();

        public void Print(string line) => Debug.Log(line);

        public void Dispose()
        {
            Finish();
            _source.Dispose();
        }
    }
}
