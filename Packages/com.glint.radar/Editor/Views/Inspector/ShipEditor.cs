using System.Linq;
using UnityEditor;
using UnityEngine;
using UnityEngine.UIElements;

namespace Glint.Editor.Views
{
    /// <summary>The inspector of a Ship: the measures that its mesh was made from, to be read.</summary>
    [CustomEditor(typeof(Ship)), CanEditMultipleObjects]
    sealed class ShipEditor : UnityEditor.Editor
    {
        public override VisualElement CreateInspectorGUI()
        {
            var inspector = new VisualElement();
            var figures = new VisualElement();
            var measures = Parts.Field("_settings", "Measures");
            measures.SetEnabled(false); // another ship is another mesh
            inspector.Add(figures);
            inspector.Add(measures);
            if (targets.Length == 1)
                Parts.ShowRows(figures, SeaFigures.Rows((Ship)target, TriangleCount()));
            return inspector;
        }

        int TriangleCount()
        {
            var mesh = ((Ship)target).TryGetComponent<MeshFilter>(out var filter) ? filter.sharedMesh : null;
            return mesh == null ? 0 : Enumerable.Range(0, mesh.subMeshCount).Sum(submesh => (int)mesh.GetIndexCount(submesh) / 3);
        }
    }
}
