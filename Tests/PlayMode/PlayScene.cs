using System.Collections;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace Glint.Tests
{
    /// <summary>Plays a scene of com.glint.scenes in a test.</summary>
    static class PlayScene
    {
        /// <summary>Loads a scene and waits until every Start has run. A sweep or cross section in it does not begin.</summary>
        public static IEnumerator Load(string name)
        {
            SceneManager.sceneLoaded += StopRuns;
            PlayAsset.LoadScene($"Packages/com.glint.scenes/{name}.unity");
            yield return null;
            yield return null;
            SceneManager.sceneLoaded -= StopRuns;
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
