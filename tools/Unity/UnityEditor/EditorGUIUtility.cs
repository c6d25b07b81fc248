using UnityEngine;
using Object = UnityEngine.Object;

namespace UnityEditor
{
    public sealed class EditorGUIUtility : GUIUtility
    {
        public static bool isProSkin => true;

        public static float pixelsPerPoint => 1;

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

        /// <summary>The screen is black.</summary>
        public static Color[] ReadScreenPixel(Vector2 pixelPos, int sizex, int sizey) => new Color[sizex * sizey];
    }
}
