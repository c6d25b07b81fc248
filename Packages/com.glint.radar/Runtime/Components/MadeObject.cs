using UnityEngine;

namespace Glint
{
    /// <summary>Engine objects that a component has made.</summary>
    static class MadeObject
    {
        /// <summary>Destroys one, at once in edit mode.</summary>
        public static void Free(Object made)
        {
            if (Application.isPlaying)
                Object.Destroy(made);
            else
                Object.DestroyImmediate(made);
        }
    }
}
