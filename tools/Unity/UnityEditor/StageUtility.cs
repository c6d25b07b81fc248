using UnityEngine;

namespace UnityEditor.SceneManagement;

public static class StageUtility
{
    /// <summary>The host has no prefab stage: an object remains in its scene.</summary>
    public static void PlaceGameObjectInCurrentStage(GameObject gameObject)
    {
    }
}
