using Glint.Host;
using UnityEngine;

namespace UnityEditor;

public static class ObjectFactory
{
    /// <summary>
    /// Below the parent, or the scene's default parent, and on its layer; else at the Scene view's pivot. The object
    /// gets a name of its own and is selected.
    /// </summary>
    public static void PlaceGameObject(GameObject go, GameObject parent = null)
    {
        if (parent == null)
            parent = EditorUtility.DefaultParent;
        if (parent != null)
        {
            go.transform.SetParent(parent.transform, false);
            go.transform.SetLocalPositionAndRotation(Vector3.zero, Quaternion.identity);
            go.transform.localScale = Vector3.one;
            go.layer = parent.layer;
        }
        else
        {
            go.transform.position = EditorHooks.ScenePivot;
        }
        GameObjectUtility.EnsureUniqueNameForSibling(go);
        Undo.SetCurrentGroupName($"Create {go.name}");
        Selection.activeGameObject = go;
    }
}
