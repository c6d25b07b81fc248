using System;
using System.Threading;
using UnityEditor;

namespace Glint.Editor
{
    /// <summary>Unity's progress bar with a cancel button, there until disposed.</summary>
    sealed class CancelBar : IProgress<double>, IDisposable
    {
        readonly CancellationTokenSource _source = new CancellationTokenSource();
        readonly string _what;

        /// <param name="what">What is done, such as "Tracing 'Radar'".</param>
        public CancelBar(string what)
        {
            _what = what;
            Report(0);
        }

        /// <summary>Asked for by the button.</summary>
        public CancellationToken Cancel => _source.Token;

        /// <summary>So much is done, 0 to 1; looks whether the button was pressed.</summary>
        public void Report(double value)
        {
            if (EditorUtility.DisplayCancelableProgressBar("Glint", _what, (float)value))
                _source.Cancel();
        }

        public void Dispose()
        {
            EditorUtility.ClearProgressBar();
            _source.Dispose();
        }
    }
}
