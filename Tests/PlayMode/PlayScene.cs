using System.Collections;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace Glint.Tests
{
    /// <summary>Plays a scene of com.glint.scenes in a test.</summary>
    static class PlayScene
    {
        /// <summary>Loads a scene and waits until every Start has run. A sweep in it does not begin.</summary>
        public static IEnumerator Load(string name)
        {
            SceneManager.sceneLoaded += StopSweep;
            PlayAsset.LoadScene($"Packages/com.glint.scenes/{name}.unity");
            yield return null;
            yield return null;
            SceneManager.sceneLoaded -= StopSweep;
        }

        // Runs after OnEnable and before Start.
        static void StopSweep(Scene scene, LoadSceneMode mode)
        {
            foreach (var sweep in Object.FindObjectsByType<Sweep>(FindObjectsInactive.Exclude,
                FindObjectsSortMode.None))
                sweep.enabled = false;
        }
    }
}
