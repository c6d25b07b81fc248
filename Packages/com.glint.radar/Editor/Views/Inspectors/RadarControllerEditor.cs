using System.Linq;
using Glint.Core;
using UnityEditor;
using UnityEditorInternal;
using UnityEngine.UIElements;

namespace Glint.Editor.Views
{
    /// <summary>
    /// The inspector of a RadarController: findings, settings by group, figures,
    /// one pose at the press of a button, and its result.
    /// </summary>
    [CustomEditor(typeof(RadarController)), CanEditMultipleObjects]
    sealed class RadarControllerEditor : UnityEditor.Editor
    {
        const long ResultEveryMs = 500;

        RadarCheck _check;
        RadarTracing _tracing;
        RadarResult _shown;
        VisualElement _findings, _figures, _result;
        Button _showPaths;
        HelpBox _problem;
        Watch _watch;

        RadarController Radar => (RadarController)target;

        public override VisualElement CreateInspectorGUI()
        {
            var inspector = new VisualElement();
            _findings = new VisualElement();
            inspector.Add(_findings);
            AddSettings(inspector);
            if (targets.Length == 1 && RadarCheck.CanLook(Radar))
                AddLook(inspector);
            return inspector;
        }

        void OnDisable() => _tracing?.Dispose();

        void OnSceneGUI() => SceneHandles.Draw(Radar);

        static void AddSettings(VisualElement inspector)
        {
            inspector.Add(Parts.Group("Signal",
                Parts.Field("_frequencyHz", "Frequency (Hz)")));
            inspector.Add(Parts.Group("Rays",
                Parts.Field("_raysAcross", "Rays Across"),
                Parts.Field("_raysDown", "Rays Down"),
                Parts.Field("_fitAperture", "Fit Aperture"),
                Parts.Field("_raySpacing", "Ray Spacing (m)"),
                Parts.Field("_maxBounces", "Max Bounces"),
                Parts.Field("_regionCorner", "Region Corner (rays)"),
                Parts.Field("_regionSize", "Region Size (rays)")));
            inspector.Add(Parts.Group("Receiver",
                Parts.Field("_receiver", "Receiver"),
                Parts.Field("_receiverSize", "Receiver Size (m)")));
            inspector.Add(Parts.Group("What is traced",
                Parts.Field("_layers", "Layers"),
                Parts.Field("_roots", "Roots"),
                Parts.Field("_meshChanges", "Mesh Changes")));
            inspector.Add(Parts.Group("Results",
                Parts.Field("_toleranceDb", "Tolerance (dB)"),
                Parts.Field("_skipSamplingError", "Skip Sampling Error"),
                Parts.Field("_keptRays", "Kept Rays"),
                Parts.Field("_kernel", "Kernel"),
                Parts.Field("_tubeKernel", "Tube Kernel"),
                Parts.Field("_clutterKernel", "Clutter Kernel")));
        }

        void AddLook(VisualElement inspector)
        {
            _check = new RadarCheck(Radar);
            _tracing?.Dispose();
            _tracing = new RadarTracing(Radar);
            _shown = null;
            _figures = new VisualElement();
            _result = new VisualElement();
            _problem = new HelpBox("", HelpBoxMessageType.Error);
            inspector.Add(Parts.Group("Figures", _figures));
            var buttons = new VisualElement();
            buttons.style.flexDirection = FlexDirection.Row;
            buttons.Add(new Button(Trace)
            {
                text = "Trace now", tooltip = "Traces one pose of the present scene. It can be cancelled."
            });
            buttons.Add(
                new Button(() => RadarWindow.Show(Radar)) { text = "Sweep...", tooltip = "Traces many poses." });
            _showPaths = new Button(ShowPaths)
            {
                text = RadarFixes.ShowRayPaths(Radar).Label, tooltip = "Draws the ray paths of each pose "
                    + "in Scene and Game view: adds the component Ray Paths."
            };
            buttons.Add(_showPaths);
            inspector.Add(buttons);
            inspector.Add(_problem);
            inspector.Add(Parts.Group("Last result", _result));
            _watch = new Watch(inspector, serializedObject, Look, () => _check.Seconds);
            inspector.schedule.Execute(ShowResult).Every(ResultEveryMs);
        }

        void Look()
        {
            if (target == null)
                return;
            _check.Update();
            Parts.ShowFindings(_findings, _check.Findings, _watch.LookSoon);
            _showPaths.style.display = Radar.TryGetComponent<RayPaths>(out _) ? DisplayStyle.None : DisplayStyle.Flex;
            Parts.ShowRows(_figures, _check.Figures?.Rows() ?? Enumerable.Empty<(string, string, string)>());
        }

        void Trace()
        {
            _tracing.Trace();
            InternalEditorUtility.RepaintAllViews(); // the ray paths
            ShowResult();
        }

        void ShowPaths()
        {
            RadarFixes.ShowRayPaths(Radar).Apply();
            Look();
        }

        // Play mode, a sweep or the window may have traced as well.
        void ShowResult()
        {
            _problem.text = _tracing.Problem ?? "";
            _problem.style.display = _tracing.Problem == null ? DisplayStyle.None : DisplayStyle.Flex;
            if (target == null || Radar.Result == _shown)
                return;
            _shown = Radar.Result;
            Parts.ShowRows(_result, RadarTracing.Rows(_shown));
        }
    }
}
