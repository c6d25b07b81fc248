using System.Collections.Generic;
using System.Linq;
using UnityEngine.UIElements;

namespace Glint.Editor.Views
{
    /// <summary>An inspector with what is wrong above the fields, and figures below them.</summary>
    abstract class FiguresEditor : UnityEditor.Editor
    {
        VisualElement _findings, _figures;

        public override VisualElement CreateInspectorGUI()
        {
            var inspector = new VisualElement();
            (_findings, _figures) = (new VisualElement(), new VisualElement());
            inspector.Add(_findings);
            AddFields(inspector);
            inspector.Add(_figures);
            if (targets.Length == 1)
                StartLooking(inspector);
            return inspector;
        }

        /// <summary>Adds the fields and buttons.</summary>
        protected abstract void AddFields(VisualElement inspector);

        /// <summary>Present content: findings without nulls, and label, value and meaning of the figures.</summary>
        protected abstract (IEnumerable<Finding> findings,
            IEnumerable<(string label, string value, string tooltip)> rows) Shown();

        /// <summary>Sees to it that <see cref="Look"/> is called when what is shown may have changed.</summary>
        protected virtual void StartLooking(VisualElement inspector) => new Watch(inspector, serializedObject, Look);

        /// <summary>Shows findings and figures as they are now.</summary>
        protected void Look()
        {
            if (target == null)
                return;
            var (findings, rows) = Shown();
            Parts.ShowFindings(_findings, findings.Where(finding => finding != null), Look);
            Parts.ShowRows(_figures, rows);
        }
    }
}
