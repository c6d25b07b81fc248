using UnityEngine;

namespace Glint
{
    /// <summary>
    /// Assigns a radar material to an object and to all objects below it without one of their own, or to one submesh of
    /// its mesh. Objects without a material are perfect conductors.
    /// </summary>
    [AddComponentMenu("Glint/Radar Surface")]
    [HelpPage("editor.md")]
    public sealed class RadarSurface : MonoBehaviour
    {
        /// <summary>Value of <see cref="Submesh"/>: the whole object, and those below it.</summary>
        public const int AllSubmeshes = -1;

        [SerializeField, Tooltip("Material of the surface. Empty: a perfect conductor.")]
        RadarMaterial _material;

        [SerializeField, Min(AllSubmeshes),
            Tooltip("Submesh of this object's mesh, from 0. -1: the whole object and its children.")]
        int _submesh = AllSubmeshes;

        /// <summary>Material of the surface; null: a perfect conductor.</summary>
        public RadarMaterial Material { get => _material; set => _material = value; }

        // In the editor a reference to an asset that is gone equals null and has a number; one never assigned has none.
        internal bool HasLostMaterial =>
            _material == null && !ReferenceEquals(_material, null) && _material.GetInstanceID() != 0;

        /// <summary>
        /// Submesh of this object's mesh, from 0; <see cref="AllSubmeshes"/>: the whole object and its children.
        /// </summary>
        public int Submesh { get => _submesh; set => _submesh = value; }
    }
}
