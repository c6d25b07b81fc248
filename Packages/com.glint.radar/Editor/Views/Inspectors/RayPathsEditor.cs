using System.Collections.Generic;
using System.Linq;
using UnityEditor;
using UnityEngine.UIElements;

namespace Glint.Editor.Views
{
    /// <summary>The inspector of Ray Paths: filters, number of rays drawn, or why there are none.</summary>
    [CustomEditor(typeof(RayPaths)), CanEditMultipleObjects]
    sealed class RayPathsEditor : FiguresEditor
    {
        const long LookEveryMs = 500;

        string _shown;

        RayPaths Paths => (RayPaths)target;

        protected override void AddFields(VisualElement inspector)
        {
            _shown = null;
            inspector.Add(Parts.Field("_receivedOnly", "Received Only"));
            inspector.Add(Parts.Field("_every", "Every"));
            inspector.Add(Parts.Field("_fewestBounces", "Fewest Bounces"));
            inspector.Add(Parts.Field("_mostBounces", "Most Bounces"));
            inspector.Add(Parts.Field("_meeting", "Meeting"));
            inspector.Add(Parts.Field("_hitPoints", "Hit Points"));
        }

        protected override (IEnumerable<Finding>, IEnumerable<(string, string, string)>) Shown() =>
            (new[] { RayPathsFigures.Check(Paths) }, RayPathsFigures.Rows(Paths));

        // Polls: rays are traced when a view shows them, and no event is raised.
        protected override void StartLooking(VisualElement inspector) =>
            inspector.schedule.Execute(LookForChange).Every(LookEveryMs);

        // The same text is not drawn again: a user may be selecting it.
        void LookForChange()
        {
            if (target == null)
                return;
            string shown = RayPathsFigures.Check(Paths) + RayPathsFigures.Rows(Paths).Single().value;
            if (shown == _shown)
                return;
            _shown = shown;
            Look();
        }
    }
}
