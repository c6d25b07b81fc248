using System;
using System.Globalization;
using System.Linq;
using Glint.Core;
using UnityEditor;
using UnityEngine;

namespace Glint.Editor.Views
{
    /// <summary>
    /// Handles in Scene view: the edges of a radar's receiver or aperture and of its region, and the ends of a sweep's
    /// angles.
    /// </summary>
    static class SceneHandles
    {
        // Of the size that Unity gives to handles at their place.
        const float DotSize = 0.05f, RegionDistance = 4, ArcRadius = 2;

        const float MinSize = 1e-3f; // m

        /// <summary>Draws the handles of a radar and applies what the user drags.</summary>
        public static void Draw(RadarController radar)
        {
            if (!radar.TryGetComponent<Camera>(out var camera))
                return;
            DrawReceiver(radar, camera);
            if (!radar.IsFitted)
                DrawRegion(radar, camera);
        }

        /// <summary>
        /// Draws the arc of a sweep's angles FROM:TO:STEP about its target, with a handle at each end that moves it in
        /// whole steps. A list of angles has no arc.
        /// </summary>
        public static void Draw(Sweep sweep)
        {
            var parts = sweep.Angles.Split(':');
            var range = parts.Select(part => double.TryParse(part, NumberStyles.Float, CultureInfo.InvariantCulture,
                out double number) ? number : double.NaN).ToArray();
            if (sweep.Target == null || range.Length != 3 || range.Any(double.IsNaN))
                return;
            var centre = sweep.Target.position;
            float radius = ArcRadius * HandleUtility.GetHandleSize(centre);
            Handles.color = Color.white;
            Handles.DrawWireArc(centre, Vector3.up, AtAzimuth(range[0]), (float)(range[1] - range[0]), radius);
            for (int end = 0; end < 2; end++)
            {
                var direction = AtAzimuth(range[end]);
                if (!Drag(centre + radius * direction, Vector3.Cross(Vector3.up, direction), out float moved))
                    continue;
                double steps = Math.Round(Mathf.Rad2Deg * Mathf.Atan2(moved, radius) / range[2]);
                parts[end] = Numbers.Format(range[end] + steps * range[2]);
                SetAngles(sweep, string.Join(":", parts));
            }
        }

        static void SetAngles(Sweep sweep, string angles)
        {
            try
            {
                SweepAxis.Angle.List.Read(angles);
            }
            catch (FormatException)
            {
                return; // dragged past the other end, or out of range
            }
            Fix.Change(sweep, "Change Angles", it => it.Angles = angles);
        }

        static Vector3 AtAzimuth(double degrees) =>
            Quaternion.AngleAxis((float)degrees, Vector3.up) * Vector3.forward;

        static void DrawReceiver(RadarController radar, Camera camera)
        {
            var corners = RadarGizmos.ReceiverOutline(radar);
            if (corners.Length == 0)
                return;
            bool isAperture = RadarGizmos.IsAperture(radar, camera);
            if (Drag((corners[2] + corners[3]) / 2, radar.Receiver.up, out float up))
                if (isAperture)
                    Fix.Change(camera, "Change Aperture",
                        it => it.orthographicSize = Mathf.Max(MinSize, it.orthographicSize + up));
                else
                    Resize(radar, new Vector2(0, 2 * up));
            if (!isAperture && Drag((corners[1] + corners[2]) / 2, radar.Receiver.right, out float right))
                Resize(radar, new Vector2(2 * right, 0));
        }

        static void Resize(RadarController radar, Vector2 change) => Fix.Change(radar, "Change Receiver Size",
            it => it.ReceiverSize = Vector2.Max(it.ReceiverSize + change, MinSize * Vector2.one));

        // The traced part of the picture, on a plane before the camera.
        static void DrawRegion(RadarController radar, Camera camera)
        {
            var settings = radar.Settings;
            var region = settings.TracedRegion;
            var view = camera.transform;
            float distance = RegionDistance * HandleUtility.GetHandleSize(view.position);
            float halfHeight = camera.orthographic
                ? camera.orthographicSize
                : distance * Mathf.Tan(Mathf.Deg2Rad * camera.fieldOfView / 2);
            float ray = 2 * halfHeight / settings.RaysDown;
            Vector3 At(float across, float down) => view.position + distance * view.forward
                + ray * ((across - settings.RaysAcross / 2f) * view.right + (down - settings.RaysDown / 2f) * view.up);
            int right = region.Left + region.Width, top = region.Bottom + region.Height;
            float middleAcross = region.Left + region.Width / 2f, middleDown = region.Bottom + region.Height / 2f;
            Handles.color = Color.white;
            Handles.DrawPolyLine(At(region.Left, region.Bottom), At(right, region.Bottom), At(right, top),
                At(region.Left, top), At(region.Left, region.Bottom));
            if (Drag(At(region.Left, middleDown), view.right, out float moved))
                SetRegion(radar, Moved(region.Left, moved / ray, 0, right - 1), region.Bottom, right, top);
            if (Drag(At(right, middleDown), view.right, out moved))
                SetRegion(radar, region.Left, region.Bottom,
                    Moved(right, moved / ray, region.Left + 1, settings.RaysAcross), top);
            if (Drag(At(middleAcross, region.Bottom), view.up, out moved))
                SetRegion(radar, region.Left, Moved(region.Bottom, moved / ray, 0, top - 1), right, top);
            if (Drag(At(middleAcross, top), view.up, out moved))
                SetRegion(radar, region.Left, region.Bottom, right,
                    Moved(top, moved / ray, region.Bottom + 1, settings.RaysDown));
        }

        static int Moved(int edge, float rays, int min, int max) => Mathf.Clamp(edge + Mathf.RoundToInt(rays), min, max);

        static void SetRegion(RadarController radar, int left, int bottom, int right, int top)
        {
            var settings = radar.Settings;
            bool isWhole = right - left == settings.RaysAcross && top - bottom == settings.RaysDown;
            settings.Region = isWhole ? default : new RayRegion
            {
                Left = left, Bottom = bottom, Width = right - left, Height = top - bottom
            };
            Fix.Change(radar, "Change Region", it => it.Settings = settings);
        }

        // A dot that slides along a line; moved: metres since the last event.
        static bool Drag(Vector3 position, Vector3 direction, out float moved)
        {
            EditorGUI.BeginChangeCheck();
            var dragged = Handles.Slider(position, direction, DotSize * HandleUtility.GetHandleSize(position),
                Handles.DotHandleCap, 0);
            moved = Vector3.Dot(dragged - position, direction);
            return EditorGUI.EndChangeCheck();
        }
    }
}
