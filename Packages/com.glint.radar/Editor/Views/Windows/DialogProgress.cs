using System;
using System.Threading;
using Glint.Core;
using UnityEditor;

namespace Glint.Editor.Views
{
    /// <summary>Progress of work that blocks the editor, with a cancel button.</summary>
    sealed class DialogProgress : IProgressSink, IDisposable
    {
        readonly CancellationTokenSource _cancel = new CancellationTokenSource();
        string _what = "";

        public CancellationToken Cancel => _cancel.Token;

        public void Start(string what, int total) => _what = what;

        public void Report(double value)
        {
            if (EditorUtility.DisplayCancelableProgressBar("Glint", _what, (float)value))
                _cancel.Cancel();
        }

        public void Advance(int done, string note)
        {
        }

        public void Finish() => EditorUtility.ClearProgressBar();

        public void Print(string line) => UnityEngine.Debug.Log(line);

        public void Dispose() => _cancel.Dispose();
    }
}
