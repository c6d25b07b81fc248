using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>
    /// Lets radars that were traced outside play mode go of their buffers before scripts are
    /// reloaded or their scene is closed:
    /// Unity sends them no OnDisable then.
    /// </summary>
    [InitializeOnLoad]
    static class ReleaseBuffers
    {
        static ReleaseBuffers()
        {
            AssemblyReloadEvents.beforeAssemblyReload += ReleaseAll;
            // Not when a mode has begun: its first poses are traced by then.
            EditorApplication.playModeStateChanged += change =>
            {
                if (change == PlayModeStateChange.ExitingEditMode || change == PlayModeStateChange.ExitingPlayMode)
                    ReleaseAll();
            };
            EditorSceneManager.sceneClosing += (scene, removing) => ReleaseAll();
        }

        static void ReleaseAll()
        {
            foreach (var radar in Object.FindObjectsByType<RadarController>(FindObjectsInactive.Include,
                FindObjectsSortMode.None))
                radar.Release();
        }
    }
}
