using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>A polar plot in a rectangle: the largest circle that leaves room for its labels.</summary>
    sealed class PolarDrawing
    {
        const float Margin = 26, LabelGap = 4, KeyLength = 18, KeyRow = 16;
        const int DegreesOfSpoke = 30, CornersOfRing = 120;

        // Above this number of points the markers would hide the lines.
        const int MaxMarkers = 90;

        readonly PolarPlot _plot;
        readonly Rect _area;

        public PolarDrawing(PolarPlot plot, Rect area) => (_plot, _area) = (plot, area);

        Vector2 Centre => _area.center;

        float Radius => Math.Max(0, Math.Min(_area.width, _area.height) / 2 - Margin);

        /// <summary>The labels, which the canvas does not draw.</summary>
        public IEnumerable<ChartText> Texts()
        {
            for (int azimuth = 0; azimuth < 360; azimuth += DegreesOfSpoke)
            {
                var outwards = Direction(azimuth);
                yield return Label($"{azimuth}°", Centre + (Radius + LabelGap) * outwards, (Vector2.one - outwards) / 2);
            }
            foreach (var (position, label) in _plot.Levels.Ticks)
                yield return Label(label, At(0, position) + LabelGap / 2 * Vector2.right, new Vector2(0, 0.5f));
            yield return Label(_plot.Title, _area.min, Vector2.zero);
            for (int i = 0; i < _plot.Notes.Count; i++)
                yield return Label(_plot.Notes[i],
                    new Vector2(_area.xMax, _area.yMax - KeyRow * (_plot.Notes.Count - i - 0.5f)), new Vector2(1, 0.5f));
            for (int i = 0; i < _plot.Curves.Count; i++)
                yield return Label(_plot.Curves[i].Name, KeyOf(i) + (KeyLength + LabelGap) * Vector2.right,
                    new Vector2(0, 0.5f));
        }

        public void Draw(IChartCanvas canvas, ChartColours colours)
        {
            foreach (var (position, _) in _plot.Levels.Ticks.Where(tick => tick.Position > 0))
                canvas.Line(Enumerable.Range(0, CornersOfRing)
                    .Select(i => At(360.0 * i / CornersOfRing, position)).ToArray(), true, 1, colours.Grid);
            for (int azimuth = 0; azimuth < 360; azimuth += DegreesOfSpoke)
                canvas.Line(new[] { Centre, At(azimuth, 1) }, false, 1, colours.Grid);
            if (_plot.OtherAzimuth is double other)
                canvas.Line(new[] { Centre, At(other, 1) }, false, 1.5f, colours.Mark);
            for (int i = 0; i < _plot.Curves.Count; i++)
            {
                var (curve, colour) = (_plot.Curves[i], colours.Line(i));
                canvas.Line(new[] { KeyOf(i), KeyOf(i) + KeyLength * Vector2.right }, false, 1.5f, colour);
                var path = PathOf(curve);
                if (path.Count > 1)
                    canvas.Line(path, _plot.IsWholeTurn, 1.5f, colour);
                if (path.Count <= MaxMarkers)
                    foreach (var corner in path)
                        Markers.Draw(canvas, corner, i, 2.5f, colour, false);
            }
        }

        /// <summary>The corners of a curve.</summary>
        public IReadOnlyList<Vector2> PathOf(PolarCurve curve) =>
            Thinning.Line(curve.Points).Select(point => At(_plot.AzimuthOf(point), point.Y)).ToArray();

        // y points downwards.
        Vector2 At(double azimuthDegrees, double radius) =>
            Centre + Radius * (float)radius * Direction(azimuthDegrees);

        static Vector2 Direction(double azimuthDegrees)
        {
            double azimuth = Math.PI / 180 * azimuthDegrees;
            return new Vector2((float)Math.Sin(azimuth), (float)-Math.Cos(azimuth));
        }

        // Left end of the key of a curve, in the lower left corner.
        Vector2 KeyOf(int curve) =>
            new Vector2(_area.xMin, _area.yMax - KeyRow * (_plot.Curves.Count - curve - 0.5f));

        static ChartText Label(string text, Vector2 position, Vector2 anchor) =>
            new ChartText { Text = text, Position = position, Anchor = anchor };
    }
}
