using Glint.Core;
using UnityEngine;

namespace Glint
{
    /// <summary>Holds the measures of a ship's mesh. <c>glint ship</c> writes both into a prefab.</summary>
    [AddComponentMenu("")]
    [HelpPage("sea.md")]
    [DisallowMultipleComponent]
    public sealed class Ship : MonoBehaviour
    {
        [SerializeField, Tooltip("The measures that the mesh was made from. "
            + "Changed ones change the mesh when it is made anew, by the button below or by glint ship.")]
        ShipSettings _settings = ShipSettings.Default;

        /// <summary>The measures of the mesh.</summary>
        public ShipSettings Settings { get => _settings; set => _settings = value; }
    }
}
