using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>
    /// Releases the buffers of radars traced in edit mode before scripts are reloaded or their scene is closed: Unity
    /// sends them no OnDisable then.
    /// </summary>
    [InitializeOnLoad]
    static class ReleaseBuffers
    {
        static ReleaseBuffers()
        {
            AssemblyReloadEvents.beforeAssemblyReload += ReleaseAll;
            // Not after a mode has begun: its first poses may have been traced.
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
