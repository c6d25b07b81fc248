using UnityEditor;
using UnityEngine.UIElements;

namespace Glint.Editor.Views
{
    /// <summary>
    /// The inspector of a Sweep: findings about its lists as they are typed, and the number of poses.
    /// </summary>
    [CustomEditor(typeof(Sweep)), CanEditMultipleObjects]
    sealed class SweepEditor : UnityEditor.Editor
    {
        SweepCheck _check;
        VisualElement _findings, _figures;
        Watch _watch;

        public override VisualElement CreateInspectorGUI()
        {
            var inspector = new VisualElement();
            _findings = new VisualElement();
            _figures = new VisualElement();
            inspector.Add(_findings);
            inspector.Add(Parts.Field("_radar", "Radar"));
            inspector.Add(Parts.Field("_target", "Target"));
            inspector.Add(Parts.Field("_angles", "Angles (deg)"));
            inspector.Add(Parts.Field("_grazingAngles", "Grazing Angles (deg)"));
            inspector.Add(Parts.Field("_distances", "Distances (m)"));
            inspector.Add(Parts.Field("_frequencies", "Frequencies (Hz)"));
            inspector.Add(Parts.Field("_snapshots", "Snapshots"));
            inspector.Add(Parts.Field("_outputFolder", "Output Folder"));
            inspector.Add(_figures);
            if (targets.Length != 1 || !RadarCheck.CanLook((Sweep)target))
                return inspector;
            _check = new SweepCheck((Sweep)target);
            _watch = new Watch(inspector, serializedObject, Look);
            return inspector;
        }

        void Look()
        {
            if (target == null)
                return;
            _check.Update();
            Parts.ShowFindings(_findings, _check.Findings, _watch.LookSoon);
            Parts.ShowRows(_figures, _check.Rows());
        }
    }
}
