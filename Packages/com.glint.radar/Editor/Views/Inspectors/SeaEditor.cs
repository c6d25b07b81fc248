using System.Collections.Generic;
using System.Linq;
using UnityEditor;
using UnityEngine.UIElements;

namespace Glint.Editor.Views
{
    /// <summary>The inspector of a Sea: snapshots by name, figures, or why nothing is shown.</summary>
    [CustomEditor(typeof(Sea)), CanEditMultipleObjects]
    sealed class SeaEditor : FiguresEditor
    {
        DropdownField _snapshot;

        Sea Sea => (Sea)target;

        protected override void AddFields(VisualElement inspector)
        {
            _snapshot = new DropdownField("Snapshot") { tooltip = "Number of the snapshot that is shown." };
            _snapshot.AddToClassList(DropdownField.alignedFieldUssClassName);
            _snapshot.RegisterValueChangedCallback(_ => Choose());
            inspector.Add(Parts.Group("Snapshots", Parts.Field("_snapshots", "Snapshots"),
                targets.Length == 1 ? (VisualElement)_snapshot : Parts.Field("_snapshot", "Snapshot")));
            inspector.Add(Parts.Group("Without snapshots", Parts.Struct("_waves", "Waves", SeaFigures.Waves),
                Parts.Field("_timeSeconds", "Time (s)")));
            inspector.Add(Parts.Struct("_clutter", "Clutter", SeaFigures.Clutter));
            inspector.Add(Parts.Group("Extent and look", Parts.Field("_extent", "Extent (m)"),
                Parts.Field("_centre", "Centre"), Parts.Field("_material", "Material"),
                Parts.Field("_drawInScene", "Draw In Scene")));
            inspector.Add(Parts.Group("While the scene plays", Parts.Field("_motion", "Motion"),
                Parts.Field("_secondsPerSnapshot", "Seconds a Snapshot")));
        }

        protected override (IEnumerable<Finding>, IEnumerable<(string, string, string)>) Shown()
        {
            _snapshot.SetEnabled(Sea.Snapshots.Count > 0);
            _snapshot.choices = Enumerable.Range(1, Sea.Snapshots.Count)
                .Select(number => SeaFigures.Name(Sea, number)).ToList();
            _snapshot.SetValueWithoutNotify(Sea.Snapshots.Count > 0 ? SeaFigures.Name(Sea, Sea.Snapshot) : "none");
            return (new[] { SeaFigures.Check(Sea) }, SeaFigures.Rows(Sea));
        }

        // Through the serialized field, for Undo, prefab overrides and the sea's OnValidate.
        void Choose()
        {
            if (_snapshot.index < 0)
                return;
            serializedObject.FindProperty("_snapshot").intValue = _snapshot.index + 1;
            serializedObject.ApplyModifiedProperties();
        }
    }
}
