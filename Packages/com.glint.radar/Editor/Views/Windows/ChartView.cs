using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using UnityEngine;
using UnityEngine.UIElements;

namespace Glint.Editor.Views
{
    /// <summary>
    /// Draws a <see cref="SweepChart"/>. The pointer reads the nearest pose, a click chooses it.
    /// </summary>
    sealed class ChartView : VisualElement
    {
        const float TickGap = 5;

        // Above this number of poses the markers would hide the lines.
        const int MaxMarkers = 400;

        readonly ChartColours _colours;
        SweepChart _chart;
        StoredRow _marked;

        public ChartView()
        {
            AddToClassList("glint-plot");
            _colours = new ChartColours(this);
            generateVisualContent = Draw;
            RegisterCallback<GeometryChangedEvent>(changed => Write());
            RegisterCallback<PointerMoveEvent>(
                move => Find(move.localPosition, (series, point) => Hovered?.Invoke(series, point)));
            RegisterCallback<PointerLeaveEvent>(leave => Left?.Invoke());
            RegisterCallback<ClickEvent>(click => Find(click.localPosition, (series, point) =>
            {
                if (!series.IsCompared)
                    Chosen?.Invoke(point.Row);
            }));
        }

        /// <summary>Raised with the pose nearest to the pointer.</summary>
        public event Action<ChartSeries, ChartPoint> Hovered;

        /// <summary>Raised when the pointer leaves.</summary>
        public event Action Left;

        /// <summary>Raised with the index of the clicked pose, from 0.</summary>
        public event Action<int> Chosen;

        /// <param name="marked">The chosen pose; may be null.</param>
        public void Show(SweepChart chart, StoredRow marked)
        {
            (_chart, _marked) = (chart, marked);
            Write();
            MarkDirtyRepaint();
        }

        // From chart coordinates, 0 to 1 with y up, to the element's.
        Vector2 At(double x, double y) => new Vector2(contentRect.x + contentRect.width * (float)x,
            contentRect.yMax - contentRect.height * (float)y);

        void Find(Vector2 position, Action<ChartSeries, ChartPoint> act)
        {
            var area = contentRect;
            if (_chart?.Nearest((position.x - area.x) / area.width, (area.yMax - position.y) / area.height,
                area.width / area.height) is var nearest && nearest.HasValue)
                act(nearest.Value.Series, nearest.Value.Point);
        }

        void Draw(MeshGenerationContext context)
        {
            if (_chart == null || !(contentRect.width > 1 && contentRect.height > 1))
                return;
            var painter = context.painter2D;
            painter.lineWidth = 1;
            painter.strokeColor = _colours.Grid;
            foreach (var (position, _) in _chart.Y.Ticks)
                DrawLine(painter, At(0, position), At(1, position));
            foreach (var (position, _) in _chart.X.Ticks)
                DrawLine(painter, At(position, 0), At(position, 1));
            painter.strokeColor = _colours.Frame;
            DrawLine(painter, At(0, 0), At(1, 0));
            DrawLine(painter, At(0, 0), At(0, 1));
            bool hasMarkers = _chart.Series.Sum(series => series.Runs.Sum(run => run.Count)) <= MaxMarkers;
            for (int i = 0; i < _chart.Series.Count; i++)
                DrawSeries(painter, _chart.Series[i], i, hasMarkers);
        }

        void DrawSeries(Painter2D painter, ChartSeries series, int number, bool hasMarkers)
        {
            foreach (var run in series.Runs.Where(run => run.Count > 1))
            {
                DrawBand(painter, run, _colours.Line(number));
                painter.strokeColor = _colours.Line(number);
                painter.lineWidth = 1.5f;
                DrawLine(painter, Thinning.Line(run).Select(point => At(point.X, point.Y)).ToArray());
            }
            // A single pose has no line.
            DrawMarkers(painter, series.Runs.Where(run => hasMarkers || run.Count == 1).SelectMany(run => run), number,
                3, _colours.Line(number), series.IsCompared);
            var points = series.Runs.SelectMany(run => run);
            DrawMarkers(painter, points.Where(point => point.Pose.IsUndersampled), 1, 7, _colours.Uncertainty, true);
            DrawMarkers(painter, points.Where(point => point.Pose == _marked), 0, 6, _colours.Mark, true);
        }

        void DrawMarkers(Painter2D painter, IEnumerable<ChartPoint> points, int kind, float radius, Color colour,
            bool isHollow)
        {
            foreach (var point in Thinning.Line(points.ToArray()))
                Markers.Draw(painter, At(point.X, point.Y), kind, radius, colour, isHollow);
        }

        void DrawBand(Painter2D painter, IReadOnlyList<ChartPoint> run, Color colour)
        {
            if (run.All(point => point.Lower == point.Upper))
                return;
            colour.a = 0.2f;
            painter.fillColor = colour;
            var band = Thinning.Band(run);
            Trace(painter, band.Select(point => At(point.X, point.Upper))
                .Concat(band.Reverse().Select(point => At(point.X, point.Lower))).ToArray());
            painter.ClosePath();
            painter.Fill();
        }

        static void DrawLine(Painter2D painter, params Vector2[] corners)
        {
            Trace(painter, corners);
            painter.Stroke();
        }

        static void Trace(Painter2D painter, Vector2[] corners)
        {
            painter.BeginPath();
            painter.MoveTo(corners[0]);
            foreach (var corner in corners.Skip(1))
                painter.LineTo(corner);
        }

        void Write()
        {
            Clear();
            if (_chart == null || !(contentRect.width > 1))
                return;
            foreach (var (position, label) in _chart.Y.Ticks)
                Put(label, "glint-tick", At(0, position) + TickGap * Vector2.left, -100, -50);
            foreach (var (position, label) in _chart.X.Ticks)
                Put(label, "glint-tick", At(position, 0) + TickGap * Vector2.up, -50, 0);
            Put(_chart.YTitle, "glint-axis-title", At(0, 1) + 2 * TickGap * Vector2.down, 0, -60);
            Put(_chart.XTitle, "glint-axis-title", At(0.5, 0) + 4 * TickGap * Vector2.up, -50, 0);
        }

        // Right and down: shift of the label in percent of its size; -50 centres it.
        void Put(string text, string kind, Vector2 at, float right, float down)
        {
            var label = new Label(text) { pickingMode = PickingMode.Ignore };
            label.AddToClassList(kind);
            (label.style.left, label.style.top) = (at.x, at.y);
            label.style.translate = new Translate(Length.Percent(right), Length.Percent(down));
            Add(label);
        }
    }
}
