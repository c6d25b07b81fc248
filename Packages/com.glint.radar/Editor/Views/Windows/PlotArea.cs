using UnityEngine;
using UnityEngine.UIElements;

namespace Glint.Editor.Views
{
    /// <summary>Base of a chart: grid, ticks with labels, titles; subclasses draw the content.</summary>
    abstract class PlotArea : VisualElement
    {
        const float TickGap = 5;

        ChartScale _x, _y;
        string _xTitle, _yTitle;
        bool _isPolar;

        protected PlotArea()
        {
            AddToClassList("glint-plot");
            Colours = new ChartColours(this);
            generateVisualContent = Draw;
            RegisterCallback<GeometryChangedEvent>(changed => Write());
        }

        protected ChartColours Colours { get; }

        /// <summary>Draws the content.</summary>
        protected abstract void DrawContent(Painter2D painter);

        protected void SetAxes(ChartScale x, ChartScale y, string xTitle, string yTitle, bool isPolar)
        {
            (_x, _y, _xTitle, _yTitle, _isPolar) = (x, y, xTitle, yTitle, isPolar);
            EnableInClassList("glint-plot-polar", isPolar);
            Write();
            MarkDirtyRepaint();
        }

        /// <summary>Maps chart coordinates, 0 to 1 with y up, to the element's.</summary>
        protected Vector2 At(double x, double y)
        {
            var area = Area();
            return new Vector2(area.x + area.width * (float)x, area.yMax - area.height * (float)y);
        }

        /// <summary>Maps the element's coordinates to the chart's.</summary>
        protected (double X, double Y) From(Vector2 position)
        {
            var area = Area();
            return ((position.x - area.x) / area.width, (area.yMax - position.y) / area.height);
        }

        /// <summary>Width over height.</summary>
        protected double Aspect => Area().width / Area().height;

        Rect Area()
        {
            var all = contentRect;
            if (!_isPolar)
                return all;
            float side = Mathf.Min(all.width, all.height);
            return new Rect(all.x + (all.width - side) / 2, all.y + (all.height - side) / 2, side, side);
        }

        void Draw(MeshGenerationContext context)
        {
            if (_x == null || !(contentRect.width > 1 && contentRect.height > 1))
                return;
            var painter = context.painter2D;
            painter.lineWidth = 1;
            painter.strokeColor = Colours.Grid;
            foreach (var (position, _) in _y.Ticks)
                if (_isPolar)
                    Circle(painter, (float)position);
                else
                    Line(painter, At(0, position), At(1, position));
            foreach (var (position, _) in _x.Ticks)
                if (_isPolar)
                    Line(painter, At(0.5, 0.5), Around(position, 1));
                else
                    Line(painter, At(position, 0), At(position, 1));
            if (!_isPolar)
            {
                painter.strokeColor = Colours.Frame;
                Line(painter, At(0, 0), At(1, 0));
                Line(painter, At(0, 0), At(0, 1));
            }
            DrawContent(painter);
        }

        // A point of a polar chart, by the fraction of a turn clockwise from the top.
        Vector2 Around(double turn, double radius)
        {
            float angle = 2 * Mathf.PI * (float)turn;
            return At(0.5 + 0.5 * radius * Mathf.Sin(angle), 0.5 + 0.5 * radius * Mathf.Cos(angle));
        }

        void Circle(Painter2D painter, float radius)
        {
            painter.BeginPath();
            painter.Arc(At(0.5, 0.5), radius * Area().width / 2, Angle.Degrees(0), Angle.Degrees(360));
            painter.Stroke();
        }

        protected static void Line(Painter2D painter, Vector2 from, Vector2 to)
        {
            painter.BeginPath();
            painter.MoveTo(from);
            painter.LineTo(to);
            painter.Stroke();
        }

        void Write()
        {
            Clear();
            if (_x == null || !(contentRect.width > 1))
                return;
            foreach (var (position, label) in _y.Ticks)
                if (_isPolar)
                    Put(label, "glint-tick", At(0.5, 0.5 + 0.5 * position), 0, -50);
                else
                    Put(label, "glint-tick", At(0, position) + TickGap * Vector2.left, -100, -50);
            foreach (var (position, label) in _x.Ticks)
                if (_isPolar)
                    Put(label, "glint-tick", Around(position, 1.06), -50, -50);
                else
                    Put(label, "glint-tick", At(position, 0) + TickGap * Vector2.up, -50, 0);
            Put(_yTitle, "glint-axis-title",
                _isPolar ? new Vector2(0, 0) : At(0, 1) + 2 * TickGap * Vector2.down, 0, _isPolar ? 0 : -60);
            if (!_isPolar)
                Put(_xTitle, "glint-axis-title", At(0.5, 0) + 4 * TickGap * Vector2.up, -50, 0);
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
