using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace Glint
{
    /// <summary>
    /// The renderers visible to a radar: enabled, of active objects on its layers and below its roots, of LOD 0, and
    /// not below its receiver.
    /// </summary>
    sealed class VisibleRenderers
    {
        readonly HierarchyWalk _walk = new HierarchyWalk();

        /// <summary>The renderers in the order of the hierarchy; those below nested roots repeat.</summary>
        /// <param name="roots">Not null; empty: every loaded scene.</param>
        /// <param name="receiver">May be null.</param>
        public IEnumerable<Renderer> Find(LayerMask layers, IReadOnlyList<Transform> roots, Transform receiver)
        {
            var lowerDetail = LowerDetail();
            foreach (var renderer in _walk.Find(roots))
            {
                var owner = renderer.gameObject;
                if (!renderer.enabled || !owner.activeInHierarchy || (layers.value & (1 << owner.layer)) == 0
                    || lowerDetail.Contains(renderer))
                    continue;
                if (receiver == null || !renderer.transform.IsChildOf(receiver))
                    yield return renderer;
            }
        }

        static HashSet<Renderer> LowerDetail()
        {
            var first = new HashSet<Renderer>();
            var lower = new HashSet<Renderer>();
            foreach (var group in Object.FindObjectsByType<LODGroup>(FindObjectsInactive.Exclude,
                FindObjectsSortMode.None))
            {
                var lods = group.GetLODs();
                lower.UnionWith(lods.Skip(1).SelectMany(lod => lod.renderers));
                first.UnionWith(lods.Take(1).SelectMany(lod => lod.renderers));
            }
            lower.ExceptWith(first);
            return lower;
        }
    }
}
