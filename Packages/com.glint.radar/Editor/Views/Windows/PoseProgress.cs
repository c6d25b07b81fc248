using System;
using System.Diagnostics;
using UnityEditor;

namespace Glint.Editor.Views
{
    /// <summary>
    /// Shows how much of a long pose is done, with a button that ends it. A pose holds the editor,
    /// so that the window's own Cancel cannot be pressed within one.
    /// </summary>
    sealed class PoseProgress : IProgress<double>, IDisposable
    {
        const double SecondsUntilShown = 1;

        readonly Stopwatch _watch = Stopwatch.StartNew();
        readonly SweepSession _session;
        bool _isShown;

        public PoseProgress(SweepSession session) => _session = session;

        public void Report(double value)
        {
            if (_watch.Elapsed.TotalSeconds < SecondsUntilShown)
                return;
            _isShown = true;
            if (EditorUtility.DisplayCancelableProgressBar("Glint",
                $"{_session.Status()}; the next {100 * value:0} % done", (float)value))
                _session.Cancel();
        }

        public void Dispose()
        {
            if (_isShown)
                EditorUtility.ClearProgressBar();
        }
    }
}
