using System.Collections.Generic;
using System.Linq;
using Glint.Core;
using UnityEditor;
using UnityEngine.UIElements;

namespace Glint.Editor.Views
{
    /// <summary>The inspector of a Ship: measures, and a button that makes the mesh from them.</summary>
    [CustomEditor(typeof(Ship)), CanEditMultipleObjects]
    sealed class ShipEditor : FiguresEditor
    {
        Button _remake;

        Ship Ship => (Ship)target;

        protected override void AddFields(VisualElement inspector)
        {
            _remake = new Button(Remake)
            {
                text = ShipFigures.Remake(Ship).Label,
                tooltip = "Builds the mesh from the measures above. It is stored with the scene."
            };
            inspector.Add(Parts.Struct("_settings", "Measures", ShipSettings.Measures.Select(measure => measure.Row)));
            if (targets.Length != 1)
                return;
            // A prefab cannot hold the mesh.
            if (RadarCheck.CanLook(Ship))
                inspector.Add(_remake);
            else
                inspector.Add(new HelpBox("The mesh is built for a ship in a scene, or by glint ship, which stores "
                    + "it: a prefab cannot hold it.", HelpBoxMessageType.Info));
        }

        protected override (IEnumerable<Finding>, IEnumerable<(string, string, string)>) Shown()
        {
            var finding = ShipFigures.Check(Ship);
            _remake.SetEnabled(finding == null);
            return (new[] { finding }, ShipFigures.Rows(Ship));
        }

        void Remake()
        {
            if (ShipFigures.Check(Ship) == null)
                ShipFigures.Remake(Ship).Apply();
            Look();
        }
    }
}
