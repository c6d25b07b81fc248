using System;
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
            var corners = ReceiverOutline(radar);
            if (corners.Length == 0
                || !Selection.Contains(radar.gameObject) && !Selection.Contains(radar.Receiver.gameObject))
                return;
            Gizmos.color = Color.white;
            Gizmos.DrawLineStrip(corners, true);
            Gizmos.DrawRay((corners[0] + corners[2]) / 2,
                Vector3.Distance(corners[0], corners[3]) / 2 * radar.Receiver.forward);
        }

        /// <summary>
        /// Corners of the receiver in the world, in order, without gathering the scene; empty without a receiver, or if
        /// its size is that of a fitted aperture.
        /// </summary>
        internal static Vector3[] ReceiverOutline(RadarController radar)
        {
            if (radar.Receiver == null || !radar.TryGetComponent<Camera>(out var camera))
                return Array.Empty<Vector3>();
            var centre = radar.Receiver.position;
            var size = radar.ReceiverSize;
            if (IsAperture(radar, camera))
            {
                if (radar.FitAperture)
                    return Array.Empty<Vector3>();
                size = 2 * camera.orthographicSize * new Vector2((float)radar.Settings.Aspect, 1);
                centre = camera.transform.position
                    + Vector3.Project(centre - camera.transform.position, camera.transform.forward);
            }
            Vector3 right = size.x / 2 * radar.Receiver.right, up = size.y / 2 * radar.Receiver.up;
            return new[] { centre - right - up, centre + right - up, centre + right + up, centre - right + up };
        }

        /// <summary>Whether the receiver is the aperture of an orthographic camera.</summary>
        internal static bool IsAperture(RadarController radar, Camera camera) =>
            camera.orthographic && radar.ReceiverSize == Vector2.zero;
    }
}
