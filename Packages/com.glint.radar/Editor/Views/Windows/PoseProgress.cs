using System;
using System.Diagnostics;
using UnityEditor;

namespace Glint.Editor.Views
{
    /// <summary>
    /// Progress of a long pose, with a cancel button. A pose blocks the editor, so that the window's own Cancel cannot
    /// be pressed.
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
