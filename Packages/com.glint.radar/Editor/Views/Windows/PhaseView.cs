using UnityEngine.UIElements;

namespace Glint.Editor.Views
{
    /// <summary>Draws a <see cref="PhaseChart"/>.</summary>
    sealed class PhaseView : PlotArea
    {
        // Fraction of a bin's width.
        const double Gap = 0.06;

        PhaseChart _chart;

        public PhaseView() => AddToClassList("glint-plot-low");

        public void Show(PhaseChart chart)
        {
            _chart = chart;
            SetAxes(chart.X, chart.Y, "Phase, deg", "Rays", false);
        }

        protected override void DrawContent(Painter2D painter)
        {
            painter.fillColor = Colours.Line(0);
            double width = 1.0 / _chart.Heights.Count;
            for (int i = 0; i < _chart.Heights.Count; i++)
            {
                double left = (i + Gap / 2) * width, right = (i + 1 - Gap / 2) * width, top = _chart.Heights[i];
                if (top <= 0)
                    continue;
                painter.BeginPath();
                painter.MoveTo(At(left, 0));
                painter.LineTo(At(left, top));
                painter.LineTo(At(right, top));
                painter.LineTo(At(right, 0));
                painter.ClosePath();
                painter.Fill();
            }
        }
    }
}
