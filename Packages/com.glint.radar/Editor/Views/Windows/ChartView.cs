using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using UnityEngine.UIElements;

namespace Glint.Editor.Views
{
    /// <summary>
    /// Draws a <see cref="SweepChart"/>. The pointer reads the nearest pose, a click chooses it.
    /// </summary>
    sealed class ChartView : PlotArea
    {
        // Above this number of poses the markers would hide the lines.
        const int MaxMarkers = 400;

        SweepChart _chart;
        PoseFigures _marked;

        public ChartView()
        {
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
        public void Show(SweepChart chart, PoseFigures marked)
        {
            (_chart, _marked) = (chart, marked);
            SetAxes(chart.X, chart.Y, chart.XTitle, chart.YTitle, chart.IsPolar);
        }

        void Find(Vector2 position, Action<ChartSeries, ChartPoint> act)
        {
            var (x, y) = From(position);
            if (_chart?.Nearest(x, y, Aspect) is var nearest && nearest.HasValue)
                act(nearest.Value.Series, nearest.Value.Point);
        }

        protected override void DrawContent(Painter2D painter)
        {
            bool hasMarkers = _chart.Series.Sum(series => series.Runs.Sum(run => run.Count)) <= MaxMarkers;
            for (int i = 0; i < _chart.Series.Count; i++)
                foreach (var run in _chart.Series[i].Runs)
                {
                    DrawBand(painter, run, Colours.Line(i));
                    DrawLine(painter, run, Colours.Line(i));
                    // A single pose has no line.
                    if (hasMarkers || run.Count == 1)
                        foreach (var point in run)
                            Markers.Draw(painter, At(point.X, point.Y), i, 3, Colours.Line(i),
                                _chart.Series[i].IsCompared);
                    foreach (var point in run.Where(point => point.Pose.IsUndersampled))
                        Markers.Draw(painter, At(point.X, point.Y), 1, 7, Colours.Uncertainty, true);
                    foreach (var point in run.Where(point => point.Pose == _marked))
                        Markers.Draw(painter, At(point.X, point.Y), 0, 6, Colours.Mark, true);
                }
        }

        void DrawBand(Painter2D painter, IReadOnlyList<ChartPoint> run, Color colour)
        {
            if (run.All(point => point.Lower == point.Upper))
                return;
            colour.a = 0.2f;
            painter.fillColor = colour;
            painter.BeginPath();
            painter.MoveTo(At(run[0].Upper.X, run[0].Upper.Y));
            foreach (var point in run.Skip(1))
                painter.LineTo(At(point.Upper.X, point.Upper.Y));
            foreach (var point in run.Reverse())
                painter.LineTo(At(point.Lower.X, point.Lower.Y));
            painter.ClosePath();
            painter.Fill();
        }

        void DrawLine(Painter2D painter, IReadOnlyList<ChartPoint> run, Color colour)
        {
            painter.strokeColor = colour;
            painter.lineWidth = 1.5f;
            painter.BeginPath();
            painter.MoveTo(At(run[0].X, run[0].Y));
            foreach (var point in run.Skip(1))
                painter.LineTo(At(point.X, point.Y));
            painter.Stroke();
        }
    }
}
