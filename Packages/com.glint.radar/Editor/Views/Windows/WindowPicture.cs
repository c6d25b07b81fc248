using UnityEditor;
using UnityEditorInternal;
using UnityEngine;
using UnityEngine.UIElements;

namespace Glint.Editor.Views
{
    /// <summary>Picture of a part of a window.</summary>
    static class WindowPicture
    {
        /// <summary>PNG of an element in its size on the screen.</summary>
        public static byte[] Png(EditorWindow window, VisualElement element)
        {
            var (rect, bound, scale) = (window.position, element.worldBound, EditorGUIUtility.pixelsPerPoint);
            int width = Mathf.RoundToInt(bound.width * scale), height = Mathf.RoundToInt(bound.height * scale);
            var picture = new Texture2D(width, height, TextureFormat.RGB24, false);
            try
            {
                picture.SetPixels(InternalEditorUtility.ReadScreenPixel(
                    (rect.position + bound.position - window.rootVisualElement.worldBound.position) * scale,
                    width, height));
                return picture.EncodeToPNG();
            }
            finally
            {
                Object.DestroyImmediate(picture);
            }
        }
    }
}
