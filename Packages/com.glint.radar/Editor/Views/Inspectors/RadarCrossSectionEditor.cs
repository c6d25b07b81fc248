using System.Collections.Generic;
using System.IO;
using UnityEditor;
using UnityEditor.UIElements;
using UnityEngine.UIElements;

namespace Glint.Editor.Views
{
    /// <summary>
    /// The inspector of a RadarCrossSection: findings, settings by group, figures, a run at the press of a button, its
    /// progress, and the polar plot of the rows so far.
    /// </summary>
    [CustomEditor(typeof(RadarCrossSection)), CanEditMultipleObjects]
    sealed class RadarCrossSectionEditor : FiguresEditor
    {
        const long ShowEveryMs = 200;

        CrossSectionCheck _check;
        (int rows, bool isRunning, string problem)? _shown;
        Button _run, _open;
        ProgressBar _progress;
        HelpBox _problem;
        PolarView _plot;
        VisualElement _results;
        PropertyField _receiverAzimuth, _receiverElevation, _receiverAzimuths;

        RadarCrossSection Radar => (RadarCrossSection)target;

        protected override void AddFields(VisualElement inspector)
        {
            inspector.Add(Parts.Field("_target", "Target"));
            inspector.Add(Parts.Group("Directions and signal",
                Parts.Field("_azimuths", "Azimuths, deg"),
                Parts.Field("_elevations", "Elevations, deg"),
                Parts.Field("_range", "Range (m)"),
                Parts.Field("_frequencies", "Frequencies, Hz"),
                Parts.Field("_polarisations", "Polarisations")));
            inspector.Add(Parts.Group("Receivers",
                Parts.Field("_receiver", "Receiver"),
                _receiverAzimuth = Parts.Field("_receiverAzimuth", "Receiver Azimuth (deg)"),
                _receiverElevation = Parts.Field("_receiverElevation", "Receiver Elevation (deg)"),
                _receiverAzimuths = Parts.Field("_receiverAzimuths", "Receiver Azimuths, deg")));
            inspector.Add(Parts.Group("Accuracy",
                Parts.Field("_tolerance", "Tolerance (dB)"),
                Parts.Field("_setFloor", "Set Floor"),
                Parts.Field("_floor", "Floor (dBsm)")));
            inspector.Add(Parts.Group("Physics",
                Parts.Field("_maxBounces", "Max Bounces"),
                Parts.Field("_edges", "Edges"),
                Parts.Field("_creaseAngle", "Crease Angle (deg)")));
            inspector.Add(Parts.Group("Run",
                Parts.Field("_runOnStart", "Run On Start"),
                Parts.Field("_outputFolder", "Output Folder"),
                Parts.Field("_kernel", "Kernel")));
        }

        protected override void StartLooking(VisualElement inspector)
        {
            if (!RadarCheck.CanLook(Radar))
                return;
            _check = new CrossSectionCheck(Radar);
            _shown = null;
            RadarWindow.AddStyle(inspector);
            var buttons = new VisualElement();
            buttons.style.flexDirection = FlexDirection.Row;
            buttons.Add(_run = new Button(RunOrCancel));
            buttons.Add(_open = new Button(() => EditorUtility.RevealInFinder(Radar.ResultsPath))
            {
                text = "Open results folder", tooltip = "Shows rcs.csv, rcs.npz and results.json."
            });
            inspector.Add(buttons);
            inspector.Add(_progress = new ProgressBar { lowValue = 0 });
            inspector.Add(_problem = new HelpBox("", HelpBoxMessageType.Error));
            inspector.Add(_plot = new PolarView());
            inspector.Add(_results = new VisualElement());
            new Watch(inspector, serializedObject, Look, () => _check.Seconds);
            inspector.schedule.Execute(ShowRun).Every(ShowEveryMs);
        }

        protected override (IEnumerable<Finding>, IEnumerable<(string, string, string)>) Shown()
        {
            bool isFixed = Radar.Receiver == CrossSectionReceiver.Fixed;
            _receiverAzimuth.SetEnabled(isFixed);
            _receiverElevation.SetEnabled(isFixed);
            _receiverAzimuths.SetEnabled(Radar.Receiver == CrossSectionReceiver.Sweep);
            _check.Update();
            return (_check.Findings, _check.Figures());
        }

        void RunOrCancel()
        {
            if (Radar.IsRunning)
                Radar.Cancel();
            else
                CrossSectionTicks.Run(Radar);
            ShowRun();
        }

        // Polls: play mode or a script may run it as well. What is shown already is not drawn again.
        void ShowRun()
        {
            if (target == null || _shown == (Radar.Rows.Count, Radar.IsRunning, Radar.Problem))
                return;
            _shown = (Radar.Rows.Count, Radar.IsRunning, Radar.Problem);
            (_run.text, _run.tooltip) = Radar.IsRunning
                ? ("Cancel", "Ends the run. Its rows are kept.")
                : ("Run", "Computes every row from the first one, and replaces the files of the last run.");
            _open.SetEnabled(Directory.Exists(Radar.ResultsPath));
            (_progress.highValue, _progress.value) = (Radar.RowCount, Radar.Rows.Count);
            _progress.title = Radar.RowCount > 0 ? $"{Radar.Rows.Count} of {Radar.RowCount} rows" : "";
            _problem.text = Radar.Problem ?? "";
            // Unity makes an empty string of null when it compiles scripts.
            _problem.style.display = _problem.text == "" ? DisplayStyle.None : DisplayStyle.Flex;
            _plot.Show(Radar.Rows, Radar.RunPlan);
            Parts.ShowRows(_results, CrossSectionCheck.Results(Radar));
        }
    }
}
