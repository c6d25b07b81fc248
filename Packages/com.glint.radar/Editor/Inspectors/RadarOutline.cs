using System;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>
    /// Outline of a radar's receiver, from its fields and transforms, without gathering the scene.
    /// </summary>
    static class RadarOutline
    {
        /// <summary>
        /// Corners of the receiver in the world, in order; empty without a receiver, or if its size is that of a fitted
        /// aperture.
        /// </summary>
        public static Vector3[] Receiver(RadarController radar)
        {
            if (radar.Receiver == null || !radar.TryGetComponent<Camera>(out var camera))
                return Array.Empty<Vector3>();
            var centre = radar.Receiver.position;
            var size = radar.ReceiverSize;
            if (camera.orthographic && size == Vector2.zero)
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
    }
}
