using UnityEditor;
using UnityEngine;

namespace Glint.Editor.Views
{
    /// <summary>
    /// Draws the receiver's outline and normal in Scene view while the radar or its receiver is selected. Unity draws
    /// the camera's frustum.
    /// </summary>
    static class RadarGizmos
    {
        [DrawGizmo(GizmoType.Selected | GizmoType.NonSelected)]
        static void Draw(RadarController radar, GizmoType type)
        {
            var corners = RadarOutline.Receiver(radar);
            if (corners.Length == 0
                || !Selection.Contains(radar.gameObject) && !Selection.Contains(radar.Receiver.gameObject))
                return;
            Gizmos.color = Color.white;
            Gizmos.DrawLineStrip(corners, true);
            Gizmos.DrawRay((corners[0] + corners[2]) / 2,
                Vector3.Distance(corners[0], corners[3]) / 2 * radar.Receiver.forward);
        }
    }
}
