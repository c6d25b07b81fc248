using System;
using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using UnityEditor;
using UnityEditor.UIElements;
using UnityEngine.UIElements;

namespace Glint.Editor.Views
{
    /// <summary>The window's right side: display options and charts.</summary>
    sealed class ResultsPanel : VisualElement
    {
        readonly ChartChoice _choice;
        readonly Action _redraw;
        readonly DropdownField _axis = new DropdownField("Over", new List<string> { SweepAxis.Angle.Name }, 0);
        readonly ToolbarMenu _compare = new ToolbarMenu { text = "Compare" };
        readonly ChartView _amplitude = new ChartView(), _received = new ChartView(), _hit = new ChartView();
        readonly ChartLegend _legend = new ChartLegend();
        readonly PhaseView _phases = new PhaseView();
        readonly Label _readout = new Label(), _differences = new Label(), _phaseText = new Label();
        PoseFigures _chosen;

        /// <param name="redraw">Called when the options have changed.</param>
        /// <param name="compare">
        /// Called with the folder or the published table of the compared run; empty for none.
        /// </param>
        /// <param name="saveFile">Called with the name of the results file to export.</param>
        /// <param name="saveReport">Called to export the HTML report.</param>
        /// <param name="savePicture">Called to export the charts.</param>
        /// <param name="look">Called to trace the radar's view.</param>
        /// <param name="savePreview">Called to export it.</param>
        public ResultsPanel(ChartChoice choice, Action redraw, Action<string> compare, Action<string> saveFile,
            Action saveReport, Action savePicture, Action look, Action savePreview)
        {
            (_choice, _redraw) = (choice, redraw);
            var bar = new Toolbar();
            _axis.RegisterValueChangedCallback(change => Choose(() => choice.Axis = change.newValue));
            _axis.labelElement.style.minWidth = 0;
            _axis.tooltip = "The axis that the charts go over.";
            bar.Add(_axis);
            bar.Add(Switch("Decibels", "20 log10 of the amplitude.", choice.InDecibels,
                value => choice.InDecibels = value));
            bar.Add(Switch("Polar", "Angles around a circle: 0 degrees at the top, clockwise.", choice.IsPolar,
                value => choice.IsPolar = value));
            bar.Add(Switch("Raw", "The amplitude as it is summed. Otherwise as if there were 2,073,600 rays over "
                + "the same view.", choice.IsRaw, value => choice.IsRaw = value));
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
            export.menu.AppendAction("Charts as PNG", action => savePicture());
            export.menu.AppendAction("Radar's view as PNG", action => savePreview());
            bar.Add(export);
            Add(bar);
            _readout.AddToClassList("glint-readout");
            _differences.AddToClassList("glint-words");
            _phaseText.AddToClassList("glint-words");
            Add(_readout);
            Charts = new ScrollView { style = { flexGrow = 1 } };
            Charts.Add(_amplitude);
            Charts.Add(_legend);
            Charts.Add(_differences);
            Charts.Add(_phases);
            Charts.Add(_phaseText);
            Charts.Add(_received);
            Charts.Add(_hit);
            Preview = new RadarPreviewView(look);
            Charts.Add(Preview);
            Add(Charts);
            foreach (var chart in new[] { _amplitude, _received, _hit })
            {
                chart.Hovered += (series, point) => _readout.text =
                    series.Name.Length > 0 ? $"{series.Name}: {point.Pose.Text()}" : point.Pose.Text();
                chart.Left += () => _readout.text = _chosen?.Text() ?? "";
                chart.Chosen += row => Choose(() => choice.Pose = row);
            }
        }

        /// <summary>The radar's view.</summary>
        public RadarPreviewView Preview { get; }

        /// <summary>All charts, for a picture of them.</summary>
        public ScrollView Charts { get; }

        /// <param name="comparison">The compared run; may be null.</param>
        public void Show(IReadOnlyList<PoseFigures> rows, Comparison comparison)
        {
            var axes = SweepChart.AxesOf(rows);
            _axis.choices = axes.Select(axis => axis.Name).ToList();
            _axis.SetValueWithoutNotify(_choice.AxisOf(rows).Name);
            _compare.tooltip = comparison == null
                ? "Lays a results folder or a published table over the charts."
                : "Laid over: " + comparison.Title;
            _chosen = _choice.Chosen(rows);
            _readout.text = _chosen?.Text() ?? "";
            var amplitude = _choice.Amplitude(rows, comparison);
            _amplitude.Show(amplitude, _chosen);
            _legend.Show(amplitude);
            _received.Show(_choice.Received(rows, comparison), _chosen);
            _hit.Show(_choice.Hit(rows, comparison), _chosen);
            _differences.text = comparison?.Text(rows) ?? "";
            var phases = new PhaseChart(_chosen);
            _phases.Show(phases);
            _phaseText.text = phases.Text;
        }

        void Choose(Action choose)
        {
            choose();
            _redraw();
        }

        ToolbarToggle Switch(string text, string help, bool value, Action<bool> set)
        {
            var toggle = new ToolbarToggle { text = text, tooltip = help, value = value };
            toggle.RegisterValueChangedCallback(change => Choose(() => set(change.newValue)));
            return toggle;
        }
    }
}
