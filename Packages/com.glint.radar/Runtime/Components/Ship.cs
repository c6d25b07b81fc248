using Glint.Core;
using UnityEngine;

namespace Glint
{
    /// <summary>Holds the measures of a ship's mesh. <c>glint ship</c> writes both into a prefab.</summary>
    [AddComponentMenu("")]
    [HelpPage("sea.md")]
    [DisallowMultipleComponent]
    [RequireComponent(typeof(MeshFilter), typeof(MeshRenderer))]
    public sealed class Ship : MonoBehaviour
    {
        [SerializeField, Tooltip("Measures of the ship. Changes take effect when the mesh is rebuilt, "
            + "by the button below or by glint ship.")]
        ShipSettings _settings = ShipSettings.Default;

        /// <summary>The measures of the mesh.</summary>
        public ShipSettings Settings { get => _settings; set => _settings = value; }
    }
}
