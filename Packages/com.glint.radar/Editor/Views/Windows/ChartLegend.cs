using UnityEngine;
using UnityEngine.UIElements;

namespace Glint.Editor.Views
{
    /// <summary>The legend of a chart.</summary>
    sealed class ChartLegend : VisualElement
    {
        public ChartLegend() => AddToClassList("glint-legend");

        public void Show(SweepChart chart)
        {
            Clear();
            if (chart.Series.Count > 1)
                for (int i = 0; i < chart.Series.Count; i++)
                    Add(Entry(chart.Series[i], i));
            if (chart.LeftOut > 0)
                Add(new Label($"{chart.LeftOut} more are not shown"));
        }

        static VisualElement Entry(ChartSeries series, int number)
        {
            var key = new VisualElement();
            key.AddToClassList("glint-legend-key");
            var colours = new ChartColours(key);
            key.generateVisualContent = context =>
                Markers.Draw(context.painter2D, new Vector2(8, 8), number, 5, colours.Line(number), series.IsCompared);
            var entry = new VisualElement();
            entry.AddToClassList("glint-legend-entry");
            entry.Add(key);
            entry.Add(new Label(series.Name.Length > 0 ? series.Name : "this run"));
            return entry;
        }
    }
}
