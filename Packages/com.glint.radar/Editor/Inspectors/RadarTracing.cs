using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Threading;
using Glint.Core;
using UnityEditor;
using UnityEngine;
using Debug = UnityEngine.Debug;

namespace Glint.Editor
{
    /// <summary>
    /// Traces poses of a radar at the press of a button, with a bar that cancels. The device's buffers are kept for the
    /// next pose until this is disposed or the radar is disabled; in play mode the scene owns them.
    /// </summary>
    sealed class RadarTracing : IDisposable
    {
        readonly RadarController _radar;
        readonly double _secondsUntilBar;
        RadarResult _result;

        /// <param name="secondsUntilBar">A shorter pose shows no bar.</param>
        public RadarTracing(RadarController radar, double secondsUntilBar = CancelBar.SecondsUntilShown) =>
            (_radar, _secondsUntilBar) = (radar, secondsUntilBar);

        /// <summary>Why the last pose was not traced, for the user; null if it was traced.</summary>
        public string Problem { get; private set; }

        /// <summary>
        /// Traces one pose of the scene in its current state. A cancelled or refused pose leaves the radar's last
        /// result.
        /// </summary>
        public void Trace()
        {
            Problem = null;
            try
            {
                using (var bar = new CancelBar($"Tracing '{_radar.name}'", _secondsUntilBar))
                    _result = _radar.Trace(bar, bar.Cancel);
            }
            catch (OperationCanceledException)
            {
                Problem = "The pose was cancelled.";
            }
            catch (GlintException problem)
            {
                Problem = problem.Message;
            }
        }

        public void Dispose()
        {
            // Unless another caller, such as a sweep, has traced with it since.
            // A radar that was never active is not told that it is destroyed.
            if (_result != null && _radar.Result == _result && !Application.isPlaying)
                _radar.Release();
            _result = null;
        }

        /// <summary>A result for an inspector: label, value, meaning.</summary>
        public static IEnumerable<(string label, string value, string tooltip)> Rows(RadarResult result)
        {
            yield return ("Amplitude", FormattableString.Invariant(
                $"{result.Amplitude:g6}{(result.AmplitudeDb is double db ? FormattableString.Invariant($" ({db:0.00} dB)") : "")}"),
                "Length of the summed phasor: 1 for one ray.");
            yield return ("Normalised",
                FormattableString.Invariant($"{result.NormalisedAmplitude:g6} ")
                    + Or(result.SamplingError, error => FormattableString.Invariant($"± {error:g3}"),
                        $"(error {ResultColumn.NotEstimated})"),
                "Amplitude with 1920 x 1080 rays over the same field of view, and its estimated sampling error.");
            yield return ("Rays hit", FormattableString.Invariant($"{result.RaysHit:N0} of {result.RaysEmitted:N0}"),
                "Rays whose first segment hits anything, of those emitted.");
            yield return ("Rays received", FormattableString.Invariant($"{result.RaysReceived:N0}"),
                "Rays that reached the receiver.");
            yield return ("Path step", Or(result.LargestPathStep,
                    step => FormattableString.Invariant($"{step:0.###} wavelengths"), ResultColumn.NotEstimated),
                "Largest difference of path length between received rays that are neighbours in the picture.");
            yield return ("Undersampled", result.Sampling == null ? ResultColumn.NotEstimated
                    : result.Undersampled ? "yes: give it more rays, a narrower view, or a larger tolerance" : "no",
                "True if the rays are too far apart, or too few return, for the amplitude and its error to be "
                    + "trusted; with a tolerance, if it is not met.");
            var times = result.Statistics.Timings;
            yield return ("Times", FormattableString.Invariant(
                $"gather {times.GatherMs:0.#}, build {times.BuildMs:0.#}, upload {times.UploadMs:0.#}, trace {times.TraceMs:0.#} ms"),
                "Times of the last pose. Unchanged parts are not built or uploaded again.");
            yield return ("On the device", Text.Mebibytes(result.Statistics.BytesOnDevice),
                "Bytes of all the radar's buffers.");
        }

        static string Or(double? value, Func<double, string> text, string missing) =>
            value is double number ? text(number) : missing;
    }

    /// <summary>
    /// Unity's progress bar with a cancel button, until disposed. It is modal, so that short work does not show it.
    /// </summary>
    sealed class CancelBar : IProgressSink, IDisposable
    {
        /// <summary>A wait that a user notices.</summary>
        public const double SecondsUntilShown = 0.5;

        readonly CancellationTokenSource _source = new CancellationTokenSource();
        readonly Stopwatch _watch = Stopwatch.StartNew();
        readonly double _secondsUntilShown;
        string _what;
        bool _isShown;

        /// <param name="what">Name of the work, such as "Tracing 'Radar'".</param>
        public CancelBar(string what, double secondsUntilShown = SecondsUntilShown)
        {
            _secondsUntilShown = secondsUntilShown;
            Start(what, 1);
        }

        /// <summary>Cancelled by the button.</summary>
        public CancellationToken Cancel => _source.Token;

        public void Start(string what, int total, int done = 0)
        {
            _what = what;
            Report(0);
        }

        /// <summary>Shows the fraction done, 0 to 1, and polls the button.</summary>
        public void Report(double value)
        {
            if (_watch.Elapsed.TotalSeconds < _secondsUntilShown)
                return;
            _isShown = true;
            if (EditorUtility.DisplayCancelableProgressBar("Glint", _what, (float)value))
                _source.Cancel();
        }

        public void Advance(int done, string note) { }

        public void Finish()
        {
            if (_isShown)
                EditorUtility.ClearProgressBar();
            _isShown = false;
        }

        public void Print(string line) => Debug.Log(line);

        public void Dispose()
        {
            Finish();
            _source.Dispose();
        }
    }
}
