using System;
using System.Collections.Generic;
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
        SweepChart _chart;
        StoredRow _marked;

        public ChartView()
        {
            AddToClassList("glint-plot");
            generateVisualContent =
                context => Drawing?.Draw(new PainterCanvas(context.painter2D), ChartColours.Skin, _marked);
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

        // Null while there is nothing to draw, or no room.
        ChartDrawing Drawing => _chart != null && contentRect.width > 1 && contentRect.height > 1
            ? new ChartDrawing(_chart, contentRect) : null;

        /// <param name="marked">The chosen pose; may be null.</param>
        public void Show(SweepChart chart, StoredRow marked)
        {
            (_chart, _marked) = (chart, marked);
            Write();
            MarkDirtyRepaint();
        }

        void Find(Vector2 position, Action<ChartSeries, ChartPoint> act)
        {
            var area = contentRect;
            if (_chart?.Nearest((position.x - area.x) / area.width, (area.yMax - position.y) / area.height,
                area.width / area.height) is var nearest && nearest.HasValue)
                act(nearest.Value.Series, nearest.Value.Point);
        }

        void Write() => ChartLabels.Write(this, Drawing?.Texts() ?? Array.Empty<ChartText>());
    }

    /// <summary>The labels of a chart as elements.</summary>
    static class ChartLabels
    {
        /// <summary>Replaces the labels of an element.</summary>
        public static void Write(VisualElement parent, IEnumerable<ChartText> texts)
        {
            parent.Clear();
            foreach (var text in texts)
            {
                var label = new Label(text.Text) { pickingMode = PickingMode.Ignore };
                label.AddToClassList(text.IsTitle ? "glint-axis-title" : "glint-tick");
                (label.style.left, label.style.top) = (text.Position.x, text.Position.y);
                label.style.translate =
                    new Translate(Length.Percent(-100 * text.Anchor.x), Length.Percent(-100 * text.Anchor.y));
                label.style.color = ChartColours.Skin.Frame;
                parent.Add(label);
            }
        }
    }

    /// <summary>UI Toolkit's painter.</summary>
    sealed class PainterCanvas : IChartCanvas
    {
        readonly Painter2D _painter;

        public PainterCanvas(Painter2D painter) => _painter = painter;

        public void Line(IReadOnlyList<Vector2> corners, bool isClosed, float width, Color colour)
        {
            (_painter.lineWidth, _painter.strokeColor) = (width, colour);
            Trace(corners);
            if (isClosed)
                _painter.ClosePath();
            _painter.Stroke();
        }

        public void Area(IReadOnlyList<Vector2> outline, Color colour)
        {
            _painter.fillColor = colour;
            Trace(outline);
            _painter.ClosePath();
            _painter.Fill();
        }

        void Trace(IReadOnlyList<Vector2> corners)
        {
            _painter.BeginPath();
            _painter.MoveTo(corners[0]);
            for (int i = 1; i < corners.Count; i++)
                _painter.LineTo(corners[i]);
        }
    }
}
