using System.Linq;
using UnityEditor;
using UnityEngine.UIElements;

namespace Glint.Editor.Views
{
    /// <summary>The inspector of a Ship: measures, and a button that makes the mesh from them.</summary>
    [CustomEditor(typeof(Ship)), CanEditMultipleObjects]
    sealed class ShipEditor : UnityEditor.Editor
    {
        VisualElement _findings, _figures;
        Button _remake;

        Ship Ship => (Ship)target;

        public override VisualElement CreateInspectorGUI()
        {
            var inspector = new VisualElement();
            _findings = new VisualElement();
            _figures = new VisualElement();
            _remake = new Button(Remake)
            {
                text = ShipFigures.Remake(Ship).Label,
                tooltip = "From the measures above. The mesh is stored with the scene."
            };
            inspector.Add(_findings);
            inspector.Add(Parts.Struct("_settings", "Measures", ShipFigures.Measures));
            if (targets.Length != 1)
                return inspector;
            // A prefab cannot hold the mesh.
            if (RadarCheck.CanLook(Ship))
                inspector.Add(_remake);
            else
                inspector.Add(new HelpBox("The mesh is made where the ship stands in a scene, or by glint ship, "
                    + "which stores it: a prefab cannot hold it.", HelpBoxMessageType.Info));
            inspector.Add(_figures);
            new Watch(inspector, serializedObject, Look);
            return inspector;
        }

        void Look()
        {
            if (target == null)
                return;
            var finding = ShipFigures.Check(Ship);
            Parts.ShowFindings(_findings, finding == null ? Enumerable.Empty<Finding>() : new[] { finding }, () => { });
            _remake.SetEnabled(finding == null);
            Parts.ShowRows(_figures, ShipFigures.Rows(Ship));
        }

        void Remake()
        {
            if (ShipFigures.Check(Ship) == null)
                ShipFigures.Remake(Ship).Apply();
            Look();
        }
    }
}
