using System.Linq;
using Glint.Core;
using UnityEditor;
using UnityEngine.UIElements;

namespace Glint.Editor.Views
{
    /// <summary>
    /// The inspector of a Sweep: what is wrong with what is written, as it is typed, and how many poses it makes.
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
            foreach (var axis in SweepAxis.All.Reverse())
                inspector.Add(Parts.Field(FieldOf(axis), axis.ListLabel));
            inspector.Add(Parts.Field("_outputFolder", "Output Folder"));
            inspector.Add(_figures);
            if (targets.Length != 1 || !RadarCheck.CanLook((Sweep)target))
                return inspector;
            _check = new SweepCheck((Sweep)target);
            _watch = new Watch(inspector, serializedObject, Look);
            return inspector;
        }

        // "grazing angles" are in the field _grazingAngles.
        static string FieldOf(SweepAxis axis) => "_" + string.Concat(axis.Plural.Split(' ')
            .Select((word, i) => i == 0 ? word : char.ToUpperInvariant(word[0]) + word.Substring(1)));

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
