using UnityEngine;
using UnityEngine.UIElements;

namespace Glint.Editor.Views
{
    /// <summary>Marker shapes that distinguish lines without colour.</summary>
    static class Markers
    {
        // Number of corners on a circle, and angle of the first one, in degrees from the right.
        static readonly (int corners, float first)[] s_shapes = { (16, 0), (4, 45), (3, -90), (4, 0), (3, 90), (6, 0) };

        /// <param name="kind">Index from 0; the shapes repeat.</param>
        /// <param name="isHollow">Outlined, for the compared run.</param>
        public static void Draw(Painter2D painter, Vector2 at, int kind, float radius, Color colour, bool isHollow)
        {
            var (corners, first) = s_shapes[kind % s_shapes.Length];
            painter.BeginPath();
            for (int i = 0; i < corners; i++)
            {
                float angle = Mathf.Deg2Rad * (first + 360f * i / corners);
                var corner = at + radius * new Vector2(Mathf.Cos(angle), Mathf.Sin(angle));
                if (i == 0)
                    painter.MoveTo(corner);
                else
                    painter.LineTo(corner);
            }
            painter.ClosePath();
            if (isHollow)
            {
                painter.strokeColor = colour;
                painter.lineWidth = 1.5f;
                painter.Stroke();
            }
            else
            {
                painter.fillColor = colour;
                painter.Fill();
            }
        }
    }
}
