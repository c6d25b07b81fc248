using System;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// Shows the progress of the Sweep on the same object, and the amplitude of its radar's last pose, on the screen:
    /// a player has no console.
    /// </summary>
    [AddComponentMenu("Glint/Radar Display")]
    [HelpPage("editor.md")]
    [RequireComponent(typeof(Sweep))]
    [DisallowMultipleComponent]
    public sealed class RadarDisplay : MonoBehaviour
    {
        // The screen's height in the units of the text, so that the text has the same share of every screen.
        const float ScreenHeight = 540;

        static readonly Rect s_box = new Rect(8, 8, 480, 76), s_text = new Rect(14, 10, 468, 72);

        void OnGUI()
        {
            GUI.matrix = Matrix4x4.Scale(Vector3.one * (Screen.height / ScreenHeight));
            GUI.Box(s_box, ""); // a dark ground
            GUI.Label(s_text, TextOf(GetComponent<Sweep>()));
        }

        static string TextOf(Sweep sweep)
        {
            string progress = FormattableString.Invariant($"{sweep.PosesDone} of {sweep.Poses} poses");
            // Unity makes an empty string of null when it compiles scripts during Play.
            if (!string.IsNullOrEmpty(sweep.Problem))
                return $"{progress}\n{sweep.Problem}";
            if (sweep.Poses > 0 && sweep.PosesDone == sweep.Poses)
                progress += $", written to {sweep.ResultsPath}";
            var result = sweep.Radar != null ? sweep.Radar.Result : null;
            return result == null ? progress : FormattableString.Invariant(
                $"{progress}\namplitude {result.Amplitude:g6}\n{result.RaysReceived} of {result.RaysHit} rays that hit were received");
        }
    }
}
