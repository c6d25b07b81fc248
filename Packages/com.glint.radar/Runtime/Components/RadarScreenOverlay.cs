using UnityEngine;

namespace Glint
{
    /// <summary>
    /// Draws the picture of the <see cref="RadarScreen"/> on the same object over the game view. It is the quickest way
    /// to see it; UI Toolkit, uGUI and materials take <see cref="RadarScreen.Picture"/>.
    /// </summary>
    [AddComponentMenu("Glint/Radar Screen Overlay")]
    [HelpPage("screen.md")]
    [RequireComponent(typeof(RadarScreen))]
    [DisallowMultipleComponent]
    public sealed class RadarScreenOverlay : MonoBehaviour
    {
        [SerializeField, Range(0.1f, 1), Tooltip("Side of the picture, as a part of the height of the game view.")]
        float _part = 1;

        RadarScreen _screen;

        void OnEnable() => _screen = GetComponent<RadarScreen>();

        void OnGUI()
        {
            if (_screen.Picture == null)
                return;
            float side = _part * Screen.height;
            GUI.DrawTexture(new Rect(Screen.width - side, 0, side, side), _screen.Picture);
        }
    }
}
