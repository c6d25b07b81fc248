using System.Collections.Generic;
using UnityEditor;
using UnityEngine.UIElements;

namespace Glint.Editor.Views
{
    /// <summary>
    /// The inspector of a Radar Material: values, or a choice of published materials with their source.
    /// </summary>
    [CustomEditor(typeof(RadarMaterial)), CanEditMultipleObjects]
    sealed class RadarMaterialEditor : FiguresEditor
    {
        DropdownField _published;

        RadarMaterial Material => (RadarMaterial)target;

        protected override void AddFields(VisualElement inspector)
        {
            _published = new DropdownField("Published") { tooltip = "Material of the library." };
            _published.AddToClassList(DropdownField.alignedFieldUssClassName);
            _published.choices = RadarMaterialFigures.Names;
            _published.RegisterValueChangedCallback(_ => Choose());
            inspector.Add(Parts.Field("_kind", "Kind"));
            inspector.Add(targets.Length == 1 ? (VisualElement)_published : Parts.Field("_published", "Published"));
            inspector.Add(Parts.Field("_layers", "Layers"));
            inspector.Add(Parts.Field("_halfSpace", "Half-Space"));
            inspector.Add(Parts.Group("Radar Screen", Parts.Field("_slope", "Slope"), Parts.Field("_gammaDb", "Gamma (dB)")));
        }

        protected override (IEnumerable<Finding>, IEnumerable<(string, string, string)>) Shown()
        {
            _published.SetEnabled(Material.Kind == RadarMaterialKind.Published);
            _published.SetValueWithoutNotify(Material.Published);
            return (new[] { RadarMaterialFigures.Check(Material) }, RadarMaterialFigures.Rows(Material));
        }

        // Through the serialized field, for Undo.
        void Choose()
        {
            serializedObject.FindProperty("_published").stringValue = _published.value;
            serializedObject.ApplyModifiedProperties();
        }
    }
}
