using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using UnityEngine;

namespace Glint.Editor
{
    /// <summary>What charts are drawn on: the window or a picture. Positions in points, y downwards.</summary>
    interface IChartCanvas
    {
        /// <param name="isClosed">Whether the last corner is joined to the first.</param>
        void Line(IReadOnlyList<Vector2> corners, bool isClosed, float width, Color colour);

        /// <param name="outline">Closed; it may not cross itself.</param>
        void Area(IReadOnlyList<Vector2> outline, Color colour);
    }

    /// <summary>A label of a chart.</summary>
    struct ChartText
    {
        public string Text;

        public Vector2 Position;

        /// <summary>Where in the text the position is: 0 at its left and its top, 1 at the others.</summary>
        public Vector2 Anchor;

        /// <summary>A title of an axis; otherwise a tick.</summary>
        public bool IsTitle;
    }

    /// <summary>A chart in a rectangle. Ticks and titles of the axes are around it.</summary>
    sealed class ChartDrawing
    {
        const float TickGap = 5;

        // Above this number of poses the markers would hide the lines.
        const int MaxMarkers = 400;

        readonly SweepChart _chart;
        readonly Rect _area;

        public ChartDrawing(SweepChart chart, Rect area) => (_chart, _area) = (chart, area);

        /// <summary>The labels, which the canvas does not draw.</summary>
        public IEnumerable<ChartText> Texts()
        {
            foreach (var (position, label) in _chart.Y.Ticks)
                yield return Label(label, At(0, position) + TickGap * Vector2.left, 1, 0.5f, false);
            foreach (var (position, label) in _chart.X.Ticks)
                yield return Label(label, At(position, 0) + TickGap * Vector2.up, 0.5f, 0, false);
            yield return Label(_chart.YTitle, At(0, 1) + 2 * TickGap * Vector2.down, 0, 0.6f, true);
            yield return Label(_chart.XTitle, At(0.5, 0) + 4 * TickGap * Vector2.up, 0.5f, 0, true);
        }

        /// <param name="marked">The chosen pose; may be null.</param>
        public void Draw(IChartCanvas canvas, ChartColours colours, StoredRow marked)
        {
            foreach (var (position, _) in _chart.Y.Ticks)
                DrawLine(canvas, At(0, position), At(1, position), colours.Grid);
            foreach (var (position, _) in _chart.X.Ticks)
                DrawLine(canvas, At(position, 0), At(position, 1), colours.Grid);
            DrawLine(canvas, At(0, 0), At(1, 0), colours.Frame);
            DrawLine(canvas, At(0, 0), At(0, 1), colours.Frame);
            bool hasMarkers = _chart.Series.Sum(series => series.Runs.Sum(run => run.Count)) <= MaxMarkers;
            for (int i = 0; i < _chart.Series.Count; i++)
            {
                var (series, colour) = (_chart.Series[i], colours.Line(i));
                foreach (var run in series.Runs.Where(run => run.Count > 1))
                {
                    DrawBand(canvas, run, colour);
                    canvas.Line(Thinning.Line(run).Select(point => At(point.X, point.Y)).ToArray(), false, 1.5f,
                        colour);
                }
                // A single pose has no line.
                DrawMarkers(canvas, series.Runs.Where(run => hasMarkers || run.Count == 1).SelectMany(run => run), i,
                    3, colour, series.IsCompared);
                var points = series.Runs.SelectMany(run => run);
                DrawMarkers(canvas, points.Where(point => point.Pose.IsUndersampled), 1, 7, colours.Undersampled,
                    true);
                DrawMarkers(canvas, points.Where(point => point.Pose == marked), 0, 6, colours.Mark, true);
            }
        }

        void DrawBand(IChartCanvas canvas, IReadOnlyList<ChartPoint> run, Color colour)
        {
            if (run.All(point => point.Lower == point.Upper))
                return;
            colour.a = 0.2f;
            var band = Thinning.Band(run);
            canvas.Area(band.Select(point => At(point.X, point.Upper))
                .Concat(band.Reverse().Select(point => At(point.X, point.Lower))).ToArray(), colour);
        }

        void DrawMarkers(IChartCanvas canvas, IEnumerable<ChartPoint> points, int kind, float radius, Color colour,
            bool isHollow)
        {
            foreach (var point in Thinning.Line(points.ToArray()))
                Markers.Draw(canvas, At(point.X, point.Y), kind, radius, colour, isHollow);
        }

        static void DrawLine(IChartCanvas canvas, Vector2 from, Vector2 to, Color colour) =>
            canvas.Line(new[] { from, to }, false, 1, colour);

        // From chart coordinates, 0 to 1 with y up.
        Vector2 At(double x, double y) =>
            new Vector2(_area.x + _area.width * (float)x, _area.yMax - _area.height * (float)y);

        static ChartText Label(string text, Vector2 position, float right, float down, bool isTitle) =>
            new ChartText { Text = text, Position = position, Anchor = new Vector2(right, down), IsTitle = isTitle };
    }
}
