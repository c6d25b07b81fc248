using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor
{
    public sealed class EditorGUIUtility : GUIUtility
    {
        public static bool isProSkin => true;

        public static void PingObject(Object obj)
        {
        }
    }
}

namespace UnityEditorInternal
{
    public class InternalEditorUtility
    {
        public static void RepaintAllViews()
        {
        }
    }
}
