using UnityEngine;

namespace UnityEditor.SceneManagement;

public static class StageUtility
{
    /// <summary>There is no stage but the scenes: an object stays where it was made.</summary>
    public static void PlaceGameObjectInCurrentStage(GameObject gameObject)
    {
    }
}
