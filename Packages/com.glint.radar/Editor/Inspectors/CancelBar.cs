using System;
using System.Threading;
using UnityEditor;

namespace Glint.Editor
{
    /// <summary>Unity's progress bar with a cancel button; shown until disposed.</summary>
    sealed class CancelBar : IProgress<double>, IDisposable
    {
        readonly CancellationTokenSource _source = new CancellationTokenSource();
        readonly string _what;

        /// <param name="what">Name of the work, such as "Tracing 'Radar'".</param>
        public CancelBar(string what)
        {
            _what = what;
            Report(0);
        }

        /// <summary>Cancelled by the button.</summary>
        public CancellationToken Cancel => _source.Token;

        /// <summary>Shows the fraction done, 0 to 1, and polls the button.</summary>
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
