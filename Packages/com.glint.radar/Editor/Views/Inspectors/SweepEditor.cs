using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using UnityEditor;
using UnityEngine.UIElements;

namespace Glint.Editor.Views
{
    /// <summary>
    /// The inspector of a Sweep: findings about its lists as they are typed, and the number of poses.
    /// </summary>
    [CustomEditor(typeof(Sweep)), CanEditMultipleObjects]
    sealed class SweepEditor : FiguresEditor
    {
        SweepCheck _check;

        void OnSceneGUI() => SceneHandles.Draw((Sweep)target);

        protected override void AddFields(VisualElement inspector)
        {
            inspector.Add(Parts.Field("_radar", "Radar"));
            inspector.Add(Parts.Field("_target", "Target"));
            foreach (var axis in SweepAxis.All.Reverse())
                inspector.Add(Parts.Field(FieldOf(axis), axis.ListLabel));
            inspector.Add(Parts.Field("_outputFolder", "Output Folder"));
        }

        protected override void StartLooking(VisualElement inspector)
        {
            if (!RadarCheck.CanLook((Sweep)target))
                return;
            _check = new SweepCheck((Sweep)target);
            base.StartLooking(inspector);
        }

        protected override (IEnumerable<Finding>, IEnumerable<(string, string, string)>) Shown()
        {
            _check.Update();
            return (_check.Findings, _check.Rows());
        }

        // "grazing angles" are in the field _grazingAngles.
        static string FieldOf(SweepAxis axis) => "_" + string.Concat(axis.Plural.Split(' ')
            .Select((word, i) => i == 0 ? word : char.ToUpperInvariant(word[0]) + word.Substring(1)));
    }
}
