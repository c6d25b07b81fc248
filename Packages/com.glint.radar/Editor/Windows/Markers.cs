using System.Linq;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>Marker shapes that distinguish lines without colour.</summary>
    static class Markers
    {
        const float OutlineWidth = 1.5f;

        // Number of corners on a circle, and angle of the first one, in degrees from the right.
        static readonly (int corners, float first)[] s_shapes = { (16, 0), (4, 45), (3, -90), (4, 0), (3, 90), (6, 0) };

        /// <param name="kind">Index from 0; the shapes repeat.</param>
        /// <param name="isHollow">Outlined, for the compared run.</param>
        public static void Draw(IChartCanvas canvas, Vector2 at, int kind, float radius, Color colour, bool isHollow)
        {
            var (corners, first) = s_shapes[kind % s_shapes.Length];
            var outline = Enumerable.Range(0, corners).Select(i => Mathf.Deg2Rad * (first + 360f * i / corners))
                .Select(angle => at + radius * new Vector2(Mathf.Cos(angle), Mathf.Sin(angle))).ToArray();
            if (isHollow)
                canvas.Line(outline, true, OutlineWidth, colour);
            else
                canvas.Area(outline, colour);
        }
    }
}
