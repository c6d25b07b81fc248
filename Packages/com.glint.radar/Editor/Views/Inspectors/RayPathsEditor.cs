using System.Linq;
using UnityEditor;
using UnityEngine.UIElements;

namespace Glint.Editor.Views
{
    /// <summary>The inspector of Ray Paths: filters, number of rays drawn, or why there are none.</summary>
    [CustomEditor(typeof(RayPaths)), CanEditMultipleObjects]
    sealed class RayPathsEditor : UnityEditor.Editor
    {
        const long LookEveryMs = 500;

        VisualElement _findings, _figures;
        string _shown;

        RayPaths Paths => (RayPaths)target;

        public override VisualElement CreateInspectorGUI()
        {
            var inspector = new VisualElement();
            _findings = new VisualElement();
            _figures = new VisualElement();
            _shown = null;
            inspector.Add(_findings);
            inspector.Add(Parts.Field("_receivedOnly", "Received Only"));
            inspector.Add(Parts.Field("_every", "Every"));
            inspector.Add(Parts.Field("_fewestBounces", "Fewest Bounces"));
            inspector.Add(Parts.Field("_mostBounces", "Most Bounces"));
            inspector.Add(Parts.Field("_meeting", "Meeting"));
            inspector.Add(Parts.Field("_hitPoints", "Hit Points"));
            inspector.Add(_figures);
            if (targets.Length == 1)
                inspector.schedule.Execute(Look).Every(LookEveryMs);
            return inspector;
        }

        // Polls: rays are traced when a view shows them, and no event is raised.
        void Look()
        {
            if (target == null)
                return;
            var finding = RayPathsFigures.Check(Paths);
            var rows = RayPathsFigures.Rows(Paths).ToArray();
            string said = finding + rows[0].value;
            if (said == _shown)
                return;
            _shown = said;
            Parts.ShowFindings(_findings, finding == null ? Enumerable.Empty<Finding>() : new[] { finding }, () => { });
            Parts.ShowRows(_figures, rows);
        }
    }
}
