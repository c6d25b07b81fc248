using UnityEngine;

namespace Glint
{
    /// <summary>Marks a tile of a <see cref="Sea"/>. A copy of the sea keeps it, a player loses hide flags.</summary>
    [AddComponentMenu("")]
    [HelpPage("sea.md")]
    [DisallowMultipleComponent]
    sealed class SeaTile : MonoBehaviour
    {
    }
}
