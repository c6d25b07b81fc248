using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using UnityEditor;
using UnityEditor.UIElements;
using UnityEngine;
using UnityEngine.UIElements;

namespace Glint.Editor.Views
{
    /// <summary>The window's right side: what is shown of the rows, and the chart.</summary>
    sealed class ResultsPanel : VisualElement
    {
        readonly ChartChoice _choice;
        readonly Action _redraw;
        readonly DropdownField _axis = new DropdownField("Over", new List<string> { SweepAxis.Angle.Name }, 0);
        readonly ToolbarMenu _compare = new ToolbarMenu { text = "Compare" };
        readonly ChartView _chart = new ChartView();
        readonly ChartLegend _legend = new ChartLegend();
        readonly Label _readout = new Label(), _differences = new Label();
        StoredRow _chosen;

        /// <param name="redraw">Called when the options have changed.</param>
        /// <param name="compare">
        /// Called with the folder or the published table of the compared run; empty for none.
        /// </param>
        /// <param name="saveFile">Called with the name of the results file to export.</param>
        /// <param name="saveReport">Called to export the HTML report.</param>
        /// <param name="savePicture">Called to export the chart.</param>
        /// <param name="look">Called to trace the radar's view.</param>
        /// <param name="savePreview">Called to export it.</param>
        public ResultsPanel(ChartChoice choice, Action redraw, Action<string> compare, Action<string> saveFile,
            Action saveReport, Action savePicture, Action look, Action savePreview)
        {
            (_choice, _redraw) = (choice, redraw);
            var bar = new Toolbar();
            _axis.RegisterValueChangedCallback(change => Choose(() => choice.Axis = change.newValue));
            _axis.labelElement.style.minWidth = 0;
            _axis.tooltip = "The chart's horizontal axis.";
            var column = new DropdownField("Show", ChartChoice.Columns.Select(shown => shown.Title).ToList(), 0)
            {
                tooltip = "The column of the results in the chart. A normalised amplitude is that of 2,073,600 rays "
                    + "over the same view."
            };
            column.SetValueWithoutNotify(choice.Column);
            column.RegisterValueChangedCallback(change => Choose(() => choice.Column = change.newValue));
            column.labelElement.style.minWidth = 0;
            bar.Add(column);
            bar.Add(_axis);
            var decibels = new ToolbarToggle
            {
                text = "Decibels", tooltip = "20 log10 of the amplitude.", value = choice.InDecibels
            };
            decibels.RegisterValueChangedCallback(change => Choose(() => choice.InDecibels = change.newValue));
            bar.Add(decibels);
            _compare.menu.AppendAction("Nothing", action => compare(""));
            foreach (var table in PublishedTable.All)
                _compare.menu.AppendAction(table.Title, action => compare(table.Name));
            _compare.menu.AppendAction("Results folder...", action =>
            {
                string folder = EditorUtility.OpenFolderPanel("Results folder", "", "");
                if (folder.Length > 0)
                    compare(folder);
            });
            bar.Add(_compare);
            var export = new ToolbarMenu { text = "Export" };
            foreach (string name in new[] { ResultsFolder.CsvName, ResultsFolder.JsonName })
                export.menu.AppendAction(name, action => saveFile(name));
            export.menu.AppendAction("HTML report", action => saveReport());
            export.menu.AppendAction("Chart as PNG", action => savePicture());
            export.menu.AppendAction("Radar's view as PNG", action => savePreview());
            bar.Add(export);
            Add(bar);
            _readout.AddToClassList("glint-readout");
            _differences.AddToClassList("glint-words");
            Add(_readout);
            Preview = new RadarPreviewView(look);
            var charts = new ScrollView { style = { flexGrow = 1 } };
            charts.Add(_chart);
            charts.Add(_legend);
            charts.Add(_differences);
            charts.Add(Preview);
            Add(charts);
            _chart.Hovered += (series, point) => _readout.text =
                series.Name.Length > 0 ? $"{series.Name}: {point.Pose.Text()}" : point.Pose.Text();
            _chart.Left += () => _readout.text = _chosen?.Text() ?? "";
            _chart.Chosen += row => Choose(() => choice.Pose = row);
        }

        /// <summary>The radar's view.</summary>
        public RadarPreviewView Preview { get; }

        /// <param name="comparison">The compared run; may be null.</param>
        public void Show(IReadOnlyList<StoredRow> rows, Comparison comparison)
        {
            var axes = SweepChart.AxesOf(rows);
            _axis.choices = axes.Select(axis => axis.Name).ToList();
            _axis.SetValueWithoutNotify(_choice.AxisOf(rows).Name);
            _compare.tooltip = comparison == null
                ? "Overlays a results folder or a published table on the chart."
                : "Laid over: " + comparison.Title;
            _chosen = _choice.Chosen(rows);
            _readout.text = _chosen?.Text() ?? "";
            var chart = _choice.Chart(rows, comparison);
            _chart.Show(chart, _chosen);
            _legend.Show(chart);
            _differences.text = comparison?.Text(rows) ?? "";
        }

        void Choose(Action choose)
        {
            choose();
            _redraw();
        }
    }

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
                Add(new Label(chart.LeftOutText));
        }

        static VisualElement Entry(ChartSeries series, int number)
        {
            var key = new VisualElement();
            key.AddToClassList("glint-legend-key");
            key.generateVisualContent = context => Markers.Draw(new PainterCanvas(context.painter2D),
                new Vector2(8, 8), number, 5, ChartColours.Skin.Line(number), series.IsCompared);
            var entry = new VisualElement();
            entry.AddToClassList("glint-legend-entry");
            entry.Add(key);
            entry.Add(new Label(series.Label));
            return entry;
        }
    }
}
