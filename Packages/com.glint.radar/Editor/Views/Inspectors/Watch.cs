using System;
using UnityEditor;
using UnityEditor.UIElements;
using UnityEngine.UIElements;

namespace Glint.Editor.Views
{
    /// <summary>
    /// Calls back when the open scenes or the inspected object have changed and then been still for a moment, and
    /// immediately when an inspector is shown.
    /// </summary>
    sealed class Watch
    {
        const long StillForMs = 300;

        // A scene may change each frame, as a sea does in play mode.
        const double MaxSecondsPostponed = 1;

        // Pause between updates, in durations of an update.
        const double PauseInLooks = 5;

        readonly IVisualElementScheduledItem _look;
        readonly Func<double> _seconds;
        double? _changed; // when the first change came that no callback has followed

        /// <param name="inspector">Watches while this is shown.</param>
        /// <param name="look">The callback.</param>
        /// <param name="seconds">Duration of the last callback; null: negligible.</param>
        public Watch(VisualElement inspector, SerializedObject inspected, Action look, Func<double> seconds = null)
        {
            _seconds = seconds;
            _look = inspector.schedule.Execute(() =>
            {
                _changed = null;
                look();
            });
            inspector.TrackSerializedObjectValue(inspected, _ => LookSoon());
            inspector.RegisterCallback<AttachToPanelEvent>(_ =>
            {
                ObjectChangeEvents.changesPublished += Hear;
                _look.ExecuteLater(0); // for changes made while another tab was shown
            });
            inspector.RegisterCallback<DetachFromPanelEvent>(_ => ObjectChangeEvents.changesPublished -= Hear);
        }

        /// <summary>Schedules an update; further changes postpone it, by a second at most.</summary>
        public void LookSoon()
        {
            double now = EditorApplication.timeSinceStartup;
            _changed ??= now;
            if (now - _changed <= MaxSecondsPostponed)
                _look.ExecuteLater(Math.Max(StillForMs, (long)(1000 * PauseInLooks * (_seconds?.Invoke() ?? 0))));
        }

        void Hear(ref ObjectChangeEventStream changes) => LookSoon();
    }
}
