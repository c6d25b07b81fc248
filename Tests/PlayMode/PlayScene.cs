using System;
using System.Collections;
using UnityEngine;
using UnityEngine.SceneManagement;
using Object = UnityEngine.Object;

namespace Glint.Tests
{
    /// <summary>Plays a scene of com.glint.scenes in a test.</summary>
    static class PlayScene
    {
        /// <summary>Loads a scene and waits until every Start has run. A sweep or cross section in it does not begin.</summary>
        /// <param name="change">Changes the scene before its first frame; may be null.</param>
        public static IEnumerator Load(string name, Action change = null)
        {
            void Change(Scene scene, LoadSceneMode mode) => change?.Invoke();
            SceneManager.sceneLoaded += StopRuns;
            SceneManager.sceneLoaded += Change;
            PlayAsset.LoadScene($"Packages/com.glint.scenes/{name}.unity");
            yield return null;
            yield return null;
            SceneManager.sceneLoaded -= StopRuns;
            SceneManager.sceneLoaded -= Change;
        }

        /// <summary>
        /// Sums, counts and lists of rays are the same without the sampling error, which takes most of a trace's time.
        /// </summary>
        public static void SkipSamplingError(RadarController radar)
        {
            var settings = radar.Settings;
            settings.SkipSamplingError = true;
            radar.Settings = settings;
        }

        /// <summary>Before the scene's radar traces by itself: a quarter of the published rays.</summary>
        public static void TraceAQuarter() => SetRays(960, 540);

        /// <summary>The same: a sixteenth.</summary>
        public static void TraceASixteenth() => SetRays(480, 270);

        static void SetRays(int across, int down)
        {
            var radar = Object.FindFirstObjectByType<RadarController>();
            var settings = radar.Settings;
            (settings.RaysAcross, settings.RaysDown) = (across, down);
            radar.Settings = settings;
        }

        // Runs after OnEnable and before Start.
        static void StopRuns(Scene scene, LoadSceneMode mode)
        {
            Disable<Sweep>();
            Disable<RadarCrossSection>();
        }

        static void Disable<T>() where T : Behaviour
        {
            foreach (var it in Object.FindObjectsByType<T>(FindObjectsInactive.Exclude, FindObjectsSortMode.None))
                it.enabled = false;
        }
    }
}
